#include "scenes/frame.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "raster/reference.hpp"
#include "scenes/exact_picture.hpp"
#include "scenes/lighting.hpp"
#include "scenes/scene_file.hpp"

using namespace twofold;

namespace {

const std::string lamps = R"({"painted": {"background": 0.4, "width": 32, "height": 16, "lights": [
    {"direction": [0.5, 0.6, 0.8], "half_angle_degrees": 20, "radiance": 3},
    {"direction": [-0.8, 0.2, 0.4], "half_angle_degrees": 20, "radiance": 2}]}})";
const std::string three_lights = R"({"directional": [
    {"direction": [0.3, 0.5, 0.8], "irradiance": 3}, {"direction": [-0.8, 0.1, 0.5], "irradiance": 2},
    {"direction": [0.2, -0.9, 0.3], "irradiance": 2}]})";

/// A sphere under two lamps and a dim sky, with one map size for all tests.
Scene sphere_scene(const std::string& factorization, const std::string& material,
                   const std::string& environment = lamps) {
    return parse_scene(R"({
  "image": {"width": 48, "height": 48},
  "camera": {"eye": [0, 0, 4], "vertical_fov_degrees": 34},
  "environment": )" + environment +
                           R"(,
  "factorization": {"map_size": 32, "samples": 42000, "held_out": 1000, )" +
                           factorization + R"(},
  "materials": {"m": )" + material +
                           R"(},
  "meshes": {"s": {"sphere": {"subdivisions": 24}}},
  "objects": [{"mesh": "s", "material": "m"}]})",
                       "t.json", "/");
}

const std::string phong = R"({"modified_phong": {"exponent": 20}})";
const std::string glass = R"({"cook_torrance": {"diffuse": 0.3, "specular": 0.7}})";

struct Drawn {
    LitScene lit;
    Frame frame;
    double error = 0.0;  ///< rms of the covered pixels against the exact picture
};

Drawn draw(const Scene& scene) {
    const SceneAssets assets = load_assets(scene);
    Drawn drawn{light_scene(scene, 2, [](const std::string&) {}), {}, 0.0};
    drawn.frame = make_frame(scene, assets, drawn.lit.materials, Preset::ideal64);
    const Framebuffer picture = render_reference(drawn.frame, Preset::ideal64, scene.custom);
    const ExactPicture exact = exact_picture(scene, assets, drawn.lit, 2);
    double sum = 0.0;
    int covered = 0;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (picture.values[i][3] == 0.0 || exact.picture.values[i][3] == 0.0) continue;
        const double d = picture.values[i][0] - exact.picture.values[i][0];
        sum += d * d;
        ++covered;
    }
    drawn.error = std::sqrt(sum / covered);
    UNSCOPED_INFO("relative rms " << drawn.lit.materials.at("m").fit[0].relative_rms);
    return drawn;
}

}  // namespace

TEST_CASE("g(n.v) goes into the vertex colours, costs no pass and brings the picture nearer",
          "[long]") {
    const Drawn without = draw(sphere_scene(R"("view_knots": 0)", glass));
    const Drawn with = draw(sphere_scene(R"("view_knots": 24)", glass));
    CHECK(with.frame.passes.size() == without.frame.passes.size());
    CHECK(with.frame.textures.size() == without.frame.textures.size());
    const Mesh& mesh = with.frame.meshes.at(with.frame.passes[0].mesh);
    REQUIRE(mesh.colors.size() == mesh.positions.size());
    const ProductTerm& term = with.lit.materials.at("m").terms[0];
    for (std::size_t i = 0; i < mesh.colors.size(); i += 37) {
        // The sphere stands at the origin: normal and position are one.
        const Vec3 n = mesh.normals[i], to_eye = Vec3{0.0, 0.0, 4.0} - mesh.positions[i];
        const double cosine = dot(n, to_eye) / length(to_eye);
        const Rgb wanted = term.scale_color * view_value(std::span(term.view), cosine);
        CHECK(mesh.colors[i].x == Approx(wanted.x).epsilon(1e-9));
        CHECK(mesh.colors[i].w == 1.0);
    }
    CAPTURE(without.error, with.error);
    CHECK(with.error < 0.7 * without.error);
}

TEST_CASE("each further product adds four passes of its own, by the blender", "[long]") {
    const Drawn one = draw(sphere_scene(R"("refinement": 6)", phong, three_lights));
    const Drawn two = draw(sphere_scene(R"("refinement": 6, "terms": 2)", phong, three_lights));
    REQUIRE(one.frame.passes.size() == 4);
    REQUIRE(two.frame.passes.size() == 8);
    for (std::size_t i = 0; i < 8; ++i) {
        const PassState& state = two.frame.passes[i].state;
        CHECK(state.blend.has_value() == (i % 2 == 1));
        CHECK(state.depth_test->write == (i % 2 == 0));
    }
    CAPTURE(one.error, two.error);
    CHECK(two.error < 0.7 * one.error);
}

TEST_CASE("a diffuse material is drawn with one unit in two passes", "[long]") {
    const Scene scene =
        sphere_scene(R"("shortcuts": true)", R"({"modified_phong": {"specular": 0}})");
    const Drawn drawn = draw(scene);
    CHECK(drawn.lit.materials.at("m").closed_form == "diffuse");
    REQUIRE(drawn.frame.passes.size() == 2);
    for (const auto& pass : drawn.frame.passes) CHECK_FALSE(pass.state.units[1]);
    CHECK(drawn.error < 0.02);
    CHECK(drawn.lit.materials.at("m").fit[0].relative_rms < 0.01);
}

TEST_CASE("the preset best is nearer to the exact picture than the preset paper", "[long]") {
    const Drawn paper = draw(sphere_scene(R"("method": "paper")", glass));
    const Drawn best = draw(sphere_scene(R"("method": "best")", glass));
    CAPTURE(paper.error, best.error);
    CHECK(best.frame.passes.size() == paper.frame.passes.size());
    CHECK(best.error < 0.5 * paper.error);
}

TEST_CASE("cube maps take one pass where paraboloids take four, and the picture is as near",
          "[long]") {
    const Drawn four = draw(sphere_scene(R"("map_form": "dual_paraboloid")", phong));
    // 6 x 18^2 texels in place of 2 x 32^2.
    Scene cubes = sphere_scene(R"("map_form": "cube")", phong);
    cubes.factorization.map_size = 18;
    const Drawn one = draw(cubes);
    CHECK(four.frame.passes.size() == 4);
    REQUIRE(one.frame.passes.size() == 1);
    CHECK(one.frame.textures.size() == 2);
    CHECK_FALSE(one.frame.passes[0].state.alpha_test);
    CHECK(one.error < 1.1 * four.error);
}
