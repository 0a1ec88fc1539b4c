#include "scenes/historical.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "raster/reference.hpp"
#include "scenes/factor_set.hpp"
#include "tests/data_folder.hpp"
#include "tests/factor/measured_files.hpp"
#include "tests/refusal.hpp"
#include "tests/scenes/scene_text.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"

using namespace twofold;
using namespace twofold::scene_text;

namespace {

const std::string text = "Red paint\r\n0\r\n0.1 0.05 0.02\r\n26.05\r\n";

std::string refusal(std::string_view set) {
    return cases::refusal(ExitCode::bad_file, [&] { parse_factor_set(set, "f.txt"); });
}

void write_even_texture(const std::filesystem::path& path, std::uint8_t level) {
    const ByteImage image{8, 8, std::vector<Rgba8>(64, Rgba8{level, level, level, 255})};
    write_file_atomically(path, encode_png(image));
}

/// A sphere of a factor set, seen from +z and lit from there.
std::string scene_of(const std::string& factors, const std::string& more = "") {
    return R"({"image": {"width": 33, "height": 33}, "meshes": {"s": {"sphere": {"subdivisions": 12}}},
               "historical": [{"mesh": "s", "factors": ")" +
           factors + "\"" + more + "}]}";
}

Framebuffer picture_of(const std::string& scene_text, const std::filesystem::path& folder) {
    const Scene scene = parse_scene(scene_text, "x.json", folder);
    const Frame frame = make_frame(scene, load_assets(scene), {}, Preset::ideal64);
    return render_reference(frame, Preset::ideal64, scene.custom);
}

}  // namespace

TEST_CASE(
    "a factor set's text is name, kind and constants, and what cannot be is refused by its line") {
    const FactorSet set = parse_factor_set(text, "f.txt");
    CHECK(set.name == "Red paint");
    CHECK(set.kind == FactorSet::Kind::product);
    CHECK(set.alpha == Rgb(0.1, 0.05, 0.02));
    CHECK(refusal("") == "f.txt: line 2: the kind is none of 0, 1 and 2");
    CHECK(refusal("n\n3\n1 1 1\n") == "f.txt: line 2: the kind is none of 0, 1 and 2");
    CHECK(refusal("n\n0\n1 1\n") == "f.txt: line 3: three constants of 0 to 1e6 are wanted");
    for (const char* constant : {"nan", "-1", "1e7", "1,5"})
        CHECK(refusal(std::string("n\n0\n1 1 ") + constant).find("line 3") != std::string::npos);
    const cases::Bytes seed(text.begin(), text.end());
    CHECK(cases::replay_damaged(seed, 1000, 30, [](const cases::Bytes& bytes) {
              parse_factor_set(std::string(bytes.begin(), bytes.end()), "f.txt");
          }) > 100);
}

TEST_CASE("a direction's paraboloid coordinates are Waterloo's, with the guard 7/8") {
    const Vec3 d = normalized(Vec3(0.3, -0.5, 0.7));
    const Vec4 c = paraboloid_coordinates(d);
    CHECK(c.x / c.w == Approx((7.0 / 8.0 * d.x + d.z + 1.0) / (2.0 * (d.z + 1.0))));
    CHECK(c.y / c.w == Approx((7.0 / 8.0 * d.y + d.z + 1.0) / (2.0 * (d.z + 1.0))));
    CHECK(paraboloid_coordinates(Vec3(0.0, 0.0, 1.0)) == Vec4(1.0, 1.0, 0.0, 2.0));
    CHECK(paraboloid_coordinates(Vec3(1.0, 0.0, -0.5)).w == 1.0);
}

TEST_CASE(
    "a historical object is diffuse alpha p q p (n.l) in two passes, and a highlight in a third") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "f.txt", text);
    write_file_atomically(folder / "f_s.txt", "Red paint\n1\n0.1 0.05 0.02\n1\n");
    for (const std::string stem : {"f", "f_s"}) {
        write_even_texture(folder / (stem + "_0.png"), 204);  // p = .8
        write_even_texture(folder / (stem + "_1.png"), 153);  // q = .6
        write_even_texture(folder / (stem + "_2.png"), 51);   // s = .2
    }
    const std::size_t middle = 16 * 33 + 16;
    const Framebuffer product = picture_of(scene_of("f.txt"), folder.path());
    const Rgb wanted = 5.0 * Rgb(0.1, 0.05, 0.02) * (0.8 * 0.6 * 0.8);
    for (std::size_t c = 0; c < 3; ++c)
        CHECK(product.values[middle][c] == Approx(wanted[static_cast<int>(c)]).epsilon(2e-3));
    // Brighter than 1 before the maps: the combiner's scale carries it.
    const Framebuffer bright = picture_of(scene_of("f.txt", R"(, "irradiance": 4)"), folder.path());
    CHECK(bright.values[middle][0] == Approx(4.0 * wanted.x).epsilon(2e-3));
    const Framebuffer both = picture_of(scene_of("f_s.txt"), folder.path());
    CHECK(both.values[middle][2] == Approx(wanted.z + 0.5 * 0.2).epsilon(2e-3));
    // Lit from behind it is black, and covers what it covers.
    const Framebuffer dark =
        picture_of(scene_of("f.txt", R"(, "light": [0, 0, -1])"), folder.path());
    CHECK(dark.values[middle] == std::array<double, 4>{0.0, 0.0, 0.0, dark.values[middle][3]});
    CHECK(parse_scene(scene_of("f_s.txt"), "x.json", folder.path()).historical.size() == 1);
}

TEST_CASE("a historical object needs a mesh, and its files inside the scene's folder") {
    CHECK(error_of(scene_of("../f.txt")).find("historical.0.factors: '../f.txt' leads out") !=
          std::string::npos);
    CHECK(error_of(scene_of("f.txt"), {"historical.0.mesh=t"})
              .find("historical.0.mesh: no mesh named 't'") != std::string::npos);
    CHECK(error_of(scene_of("f.txt"), {"historical.0.light=[0,0,0]"}).find("has no direction") !=
          std::string::npos);
    const TemporaryFolder folder;
    write_file_atomically(folder / "f.txt", text);
    CHECK_THROWS_WITH(picture_of(scene_of("f.txt"), folder.path()), Catch::Contains("f_0.png"));
}

TEST_CASE("Waterloo's own factor textures are drawn, garnet red the reddest") {
    const auto data = data_folder();
    if (!data) return;
    const std::size_t middle = 16 * 33 + 16;
    const auto garnet = picture_of(scene_of("garnetred64.txt"), *data / "brdf/shmedia/garnetred");
    CHECK(garnet.values[middle][0] > 2.0 * garnet.values[middle][1]);
    for (const char* name : {"garnetred64_s.txt", "garnetred64_spec.txt"})
        CHECK(picture_of(scene_of(name), *data / "brdf/shmedia/garnetred").values[middle][0] > 0.0);
    for (const char* name : {"leather.txt", "leather64.txt"}) {
        const auto leather = picture_of(scene_of(name), *data / "brdf/shmedia/leather");
        CHECK(leather.values[middle][0] > leather.values[middle][2]);
    }
}
