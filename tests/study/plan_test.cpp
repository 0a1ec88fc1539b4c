#include "study/sweep/plan.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "scenes/scene_file.hpp"
#include "sweep_fixtures.hpp"
#include "texunit/error.hpp"

using namespace twofold;

namespace {

const std::string two_axes = R"({
  "title": "t", "base": {"presets": ["nv17"], "image.width": 64},
  "axes": [
    {"name": "size", "plot": "line", "needs_objects": true, "path": "factorization.map_size", "values": [8, 16]},
    {"name": "both", "base": {"factorization.map_size": 16}, "points": [
      {"label": "same"}, {"label": "near", "set": {"draw.filter": "nearest"}},
      {"label": "exact", "set": {"draw.technique": "exact"}}]}
  ]})";

std::string error_of(const std::string& text) {
    try {
        parse_study(text, "s.json");
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

StudyPlan plan_of(const std::string& text, const std::string& scene = "sphere-lobe.json") {
    return make_plan(parse_study(text, "s.json"), shipped_scene(scene), {});
}

std::string id_with(const std::vector<std::string>& changes) {
    InputHashes inputs;
    return id_of(make_cell(read_source(shipped_scene("sphere-lobe.json")), changes), inputs);
}

}  // namespace

TEST_CASE("a study file's mistakes are named with their place") {
    CHECK(error_of(R"({"axis": []})") == "s.json: axis: unknown field; did you mean 'axes'?");
    CHECK(error_of(R"({"axes": [{"name": "a", "values": [1]}]})").find("axes.0") !=
          std::string::npos);
    CHECK(error_of(R"({"axes": [{"name": "a", "path": "x", "values": [1], "plot": "lines"}]})")
              .find("did you mean 'line'?") != std::string::npos);
    CHECK(error_of(R"({"axes": [{"name": "a", "points": [{"label": "p"}]},
                                {"name": "a", "points": [{"label": "p"}]}]})") ==
          "s.json: axes: two axes are named 'a'");
    CHECK(error_of(
              R"({"axes": [{"name": "a", "scenes": ["../x.json"], "points": [{"label": "p"}]}]})")
              .find("not the name of a file") != std::string::npos);
    CHECK_THROWS_AS(shipped_study("slow"), Error);
}

TEST_CASE("a wrong path or value of a cell is the scene's or the drawing's error") {
    CHECK_THROWS_WITH(
        plan_of(R"({"axes": [{"name": "a", "path": "factorization.mapsize", "values": [8]}]})"),
        Catch::Contains("did you mean 'map_size'?"));
    CHECK_THROWS_WITH(
        plan_of(R"({"axes": [{"name": "a", "path": "draw.way", "values": ["fast"]}]})"),
        Catch::Contains("draw.way"));
}

TEST_CASE("every cell is planned once, wherever it stands") {
    const StudyPlan plan = plan_of(two_axes);
    REQUIRE(plan.axes.size() == 2);
    CHECK(plan.cells.size() == 5);  // the base, 8, 16, near, exact
    CHECK(plan.axes[0].points[1].cell == plan.axes[1].points[0].cell);
    CHECK(plan.axes[0].points[1].value == 16.0);
    CHECK(plan.base == 0);
    CHECK(plan.cells[plan.axes[1].points[1].cell].cell.draw.filter == TexelFilter::nearest);
    std::set<std::string> ids;
    for (const PlannedCell& c : plan.cells) ids.insert(c.id);
    CHECK(ids.size() == plan.cells.size());
}

TEST_CASE("axes that need objects are left out for scenes without any") {
    const StudyPlan plan = plan_of(two_axes, "two-passes.json");
    REQUIRE(plan.axes.size() == 1);
    CHECK(plan.axes[0].name == "both");
}

TEST_CASE("the shards of a plan hold every cell once") {
    const StudyPlan plan = plan_of(two_axes);
    for (const int parts : {1, 2, 3, 7}) {
        std::multiset<std::size_t> cells;
        for (int part = 1; part <= parts; ++part)
            for (const std::size_t i : cells_of(plan, {part, parts})) cells.insert(i);
        CHECK(cells == std::multiset<std::size_t>{0, 1, 2, 3, 4});
    }
    CHECK(shard_of("2/5").part == 2);
    for (const char* wrong : {"", "2", "0/3", "4/3", "1/3x", "a/b", "1/99999", "-1/2"})
        CHECK_THROWS_WITH(shard_of(wrong), Catch::Contains("--shard"));
}

TEST_CASE("a cell's id follows what decides its picture, and nothing else") {
    const std::string id = id_with({"presets=[\"nv17\"]"});
    CHECK(id.size() == 16);
    CHECK(id_with({"presets=[\"nv17\"]", "title=another"}) == id);
    CHECK(id_with({"presets=[\"nv17\"]", "custom.snap_bits=2"}) == id);
    CHECK(id_with({"presets=[\"gl13\"]"}) != id);
    CHECK(id_with({"presets=[\"nv17\"]", "factorization.smoothness=0.5"}) != id);
    CHECK(id_with({"presets=[\"nv17\"]", "draw.way=literal"}) != id);
    CHECK(id_with({"draw.technique=exact", "factorization.map_size=16"}) ==
          id_with({"draw.technique=exact"}));
    CHECK(id_with({"presets=[\"custom\"]", "custom.snap_bits=2"}) !=
          id_with({"presets=[\"custom\"]"}));
}

TEST_CASE("a cell's id follows the bytes of the files that its scene names, not where they lie") {
    const ScratchFolder a("study-a"), b("study-b");
    const std::string scene = R"({"meshes": {"m": {"file": "m.obj"}}, "presets": ["nv17"],
                                  "passes": [{"mesh": "m"}]})";
    const auto id_in = [&](const ScratchFolder& folder, const std::string& mesh) {
        std::ofstream(folder.path() / "s.json") << scene;
        std::ofstream(folder.path() / "m.obj") << mesh;
        InputHashes inputs;
        return id_of(make_cell(read_source(folder.path() / "s.json"), {}), inputs);
    };
    const std::string first = id_in(a, "v 0 0 0\n");
    CHECK(id_in(b, "v 0 0 0\n") == first);
    CHECK(id_in(b, "v 0 0 1\n") != first);
}

TEST_CASE("an axis over scenes has its cells of each scene that is there") {
    const StudyPlan plan = plan_of(R"({"axes": [{"name": "a", "scenes":
        ["sphere-lobe.json", "two-passes.json", "not-there.json"], "points": [{"label": "p"}]}]})");
    REQUIRE(plan.axes[0].points.size() == 2);
    CHECK(plan.axes[0].points[0].scene == "sphere-lobe.json");
    CHECK(plan.axes[0].points[1].scene == "two-passes.json");
    CHECK(plan.axes[0].points[0].cell == plan.base);
}

TEST_CASE("the shipped studies fit every shipped scene", "[long]") {
    std::size_t planned = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shipped_scene(""))) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".json" || name == "scene.schema.json") continue;
        for (const char* study : {"quick", "full"})
            planned += make_plan(shipped_study(study), entry.path(), {}).cells.size();
    }
    CHECK(planned > 500);
}
