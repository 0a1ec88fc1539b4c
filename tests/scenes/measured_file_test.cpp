#include "scenes/measured_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "scenes/lighting.hpp"
#include "tests/data_folder.hpp"
#include "tests/factor/measured_files.hpp"
#include "tests/scenes/scene_text.hpp"
#include "tests/temporary_folder.hpp"

using namespace twofold;
using namespace twofold::scene_text;

namespace {

/// A small scene around one material.
std::string scene_of(const std::string& material) {
    return R"({"environment": {"directional": [{"direction": [0, 0, 1], "irradiance": 1}]},
               "materials": {"m": )" +
           material + R"(}, "meshes": {"s": {"sphere": {}}}, "factorization": {"map_size": 8,
               "samples": 3000, "held_out": 500}, "objects": [{"mesh": "s", "material": "m"}]})";
}

void write(const std::filesystem::path& path, std::string_view text) {
    std::ofstream(path, std::ios::binary) << text;
}

LitScene lit(const std::string& text, const std::filesystem::path& folder) {
    return light_scene(parse_scene(text, "x.json", folder), 1, [](const std::string&) {});
}

}  // namespace

TEST_CASE(
    "SHA-256 is that of its standard, and a list of known files is searched by sum and size") {
    const std::string abc = "abc";
    const std::vector<unsigned char> bytes(abc.begin(), abc.end());
    const std::string sum = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    CHECK(sha256_of(bytes) == sum);
    const std::string list = "# a note\n00ff 3 other.binary\n" + sum + " 3 abc.binary\r\n";
    CHECK(known_name(list, sum, 3) == "abc.binary");
    CHECK(known_name(list, sum, 4).empty());
    CHECK(known_name("", sum, 3).empty());
}

TEST_CASE("a scene's measured material is loaded, factored and reported") {
    const TemporaryFolder folder;
    write(folder / "m.brdf", cases::cornell_file([](double ti, double to, double) {
              return 0.1 + 0.1 * std::cos(ti) * std::cos(to);
          }));
    for (const std::string fill : {"homomorphic", "interpolate"}) {
        const LitScene scene = lit(
            scene_of(R"({"cornell": {"file": "m.brdf", "fill": ")" + fill + "\"}}"), folder.path());
        const auto& brdf = std::get<MeasuredBrdf>(scene.brdfs.at("m"));
        CHECK(brdf.model->report.sha256.size() == 64);
        CHECK(brdf.model->report.recognised.empty());
        CHECK(brdf.model->report.factors.has_value() == (fill == "homomorphic"));
        CHECK(scene.materials.at("m").fit[1].relative_rms < 0.2);
    }
    CHECK_THROWS_WITH(lit(scene_of(R"({"rgl": {"file": "m.brdf"}})"), folder.path()),
                      Catch::Contains("m.brdf: no tensor file"));
    CHECK_THROWS_WITH(lit(scene_of(R"({"merl": {"file": "none"}})"), folder.path()),
                      Catch::Contains("none"));
}

TEST_CASE("D04 a MERL file is held against the list of known files beside it",
          "[hard][D04][long]") {
    const TemporaryFolder folder;
    const auto file = cases::merl_file([](int, int, int, int) { return 150.0; });
    write(folder / "grey.binary", {reinterpret_cast<const char*>(file.data()), file.size()});
    const std::string text = scene_of(R"({"merl": {"file": "grey.binary"}})");
    const auto recognised = [&] {
        return std::get<MeasuredBrdf>(lit(text, folder.path()).brdfs.at("m"))
            .model->report.recognised;
    };
    CHECK(recognised().empty());
    write(folder / std::string(known_list), sha256_of(file) + " 34992012 grey-paint.binary\n");
    CHECK(recognised() == "grey-paint.binary");
}

TEST_CASE("the published list of MERL files is read") {
    const auto folder = data_folder();
    if (!folder) return;
    const auto bytes = bytes_of(*folder / "brdf/merl" / known_list);
    const std::string list(bytes.begin(), bytes.end());
    CHECK(known_name(list, "d6506c69e44430bfe8ea676f3950599ca3a6bfb1f46b9906da336d13991bd37d",
                     34992012) == "alum-bronze.binary");
}

TEST_CASE("a measured material needs a file inside the scene's folder and a known fill") {
    const auto error = [](const std::string& material) { return error_of(scene_of(material)); };
    CHECK(error(R"({"merl": {}})").find("materials.m.merl: ") != std::string::npos);
    CHECK(error(R"({"merl": {"file": "../m"}})").find("materials.m.merl.file: '../m' leads out") !=
          std::string::npos);
    CHECK(error(R"({"rgl": {"file": "m", "fill": "homomorph"}})")
              .find("did you mean 'homomorphic'") != std::string::npos);
    CHECK(error(R"({"cornel": {"file": "m"}})").find("did you mean 'cornell'") !=
          std::string::npos);
}
