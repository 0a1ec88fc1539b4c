#include "study/sweep/cell_store.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "study/sweep/study_page.hpp"
#include "sweep_fixtures.hpp"
#include "texunit/error.hpp"

using namespace twofold;

namespace {

CellFindings findings() {
    return {{{"preset", "nv17"}, {"times", {{"x", 0.125}}}}, {1, 1, {Rgba8{1, 2, 3, 255}}}};
}

/// A plan of one axis with two cells, and results made up for them.
StudyResults made_up() {
    StudyResults r;
    r.plan.cells.resize(2);
    r.plan.cells[0].id = "aa";
    r.plan.cells[1].id = "bb";
    r.plan.axes = {{"axis", "The axis", AxisPlot::bars, AxisReference::exact, false, {}}};
    r.plan.axes[0].points = {{"one, \"quoted\"", 1.0, "", 0}, {"two", std::nullopt, "s.json", 1}};
    r.cells["aa"] = {
        {"id", "aa"},
        {"preset", "nv17"},
        {"errors", {{"exact", {{"rms_steps", 2.5}}}, {"ideal64", nullptr}}},
        {"times",
         {{"sampling", {{"wall", 1.0}}},
          {"factoring", {{"wall", 0.5}}},
          {"frame", {{"ratio_to_anchor", 2.0}, {"anchor_processor", {{"least", 0.25}}}}}}}};
    r.cells["bb"] = {{"id", "bb"}, {"preset", "nv17"}, {"failed", "no such texture"}};
    return r;
}

}  // namespace

TEST_CASE("a kept cell is read back, from its folder or one that took it over") {
    const ScratchFolder a("store-a"), b("store-b");
    const CellStore store(a.path()), other(b.path());
    CHECK_FALSE(store.result("0123456789abcdef"));
    store.keep("0123456789abcdef", findings());
    const auto result = store.result("0123456789abcdef");
    REQUIRE(result);
    CHECK(result->at("id") == "0123456789abcdef");
    CHECK(result->at("times").at("x") == 0.125);
    other.take_over("0123456789abcdef", store);
    CHECK(*other.result("0123456789abcdef") == *result);
}

TEST_CASE("a cell without its picture, of another id or torn is not there") {
    const ScratchFolder a("store-c");
    const CellStore store(a.path());
    store.keep("aaaaaaaaaaaaaaaa", findings());
    std::filesystem::remove(store.picture_file("aaaaaaaaaaaaaaaa"));
    CHECK_FALSE(store.result("aaaaaaaaaaaaaaaa"));
    std::ofstream(a.path() / "bbbbbbbbbbbbbbbb.json") << "{\"id\": \"bbbb";
    CHECK_FALSE(store.result("bbbbbbbbbbbbbbbb"));
    store.keep("cccccccccccccccc", {{{"failed", "why"}}, {}});
    CHECK(store.result("cccccccccccccccc"));
    std::filesystem::copy_file(a.path() / "cccccccccccccccc.json",
                               a.path() / "dddddddddddddddd.json");
    CHECK_FALSE(store.result("dddddddddddddddd"));
}

TEST_CASE("what was not measured is counted and the first named") {
    const ScratchFolder a("store-d");
    StudyPlan plan = made_up().plan;
    CHECK_THROWS_WITH(collect(plan, CellStore(a.path())),
                      Catch::Contains("2 of 2 cells") && Catch::Contains("aa (The axis: one"));
}

TEST_CASE("the table has one line a place, quoted where it must be") {
    const std::string csv = study_csv(made_up());
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
    CHECK(csv.find("\naxis,\"one, \"\"quoted\"\"\",1,,aa,0.5,1.5,nv17,") != std::string::npos);
    CHECK(csv.find("\naxis,two,,s.json,bb,,,nv17,") != std::string::npos);
    CHECK(csv.find("no such texture\n") != std::string::npos);
}

TEST_CASE("the summary speaks of the common cell") {
    StudyResults results = made_up();
    CHECK(study_summary(results).find("off by 2.50 of 255 steps RMS") != std::string::npos);
}
