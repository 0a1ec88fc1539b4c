#include "scenes/vertex_lighting.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/lighting.hpp"
#include "scenes/scene_file.hpp"
#include "texunit/error.hpp"

using namespace twofold;

namespace {

/// One vertex seen straight on, lit from 60 degrees.
Scene lit_scene(const std::string& material) {
    return parse_scene(R"({
      "image": {"width": 8, "height": 8},
      "camera": {"eye": [0, 0, 3], "target": [0, 0, 0]},
      "environment": {"directional": [{"direction": [0.8660254037844386, 0, 0.5], "irradiance": [2, 1, 0]}]},
      "factorization": {"samples": 300, "held_out": 10},
      "materials": {"m": )" +
                           material + R"(},
      "meshes": {"t": {"vertices": {"positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
                                  "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]], "indices": [0, 1, 2]}}},
      "objects": [{"mesh": "t", "material": "m"}]})",
                       "s.json", ".");
}

const Mesh& lit_mesh(const Frame& frame) { return frame.meshes[frame.passes[0].mesh]; }

Mesh gl_mesh(const std::string& material, double white) {
    const Scene scene = lit_scene(material);
    const SampledScene sampled = sample_scene(scene, 1, [](const std::string&) {});
    return lit_mesh(make_vertex_lights_frame(scene, load_assets(scene), sampled, white, 8));
}

}  // namespace

TEST_CASE("fixed-function lighting of a vertex is OpenGL's formula") {
    const std::string phong =
        R"({"modified_phong": {"diffuse": [0.5, 0.25, 0.1], "specular": 0.3, "exponent": 6}})";
    const Mesh mesh = gl_mesh(phong, 4.0);
    // n.l = 1/2; h is half-way between 0 and 60 degrees: n.h = cos 30.
    const double highlight = 0.3 * 8.0 / (2.0 * M_PI) * std::pow(std::cos(M_PI / 6.0), 24.0);
    CHECK(mesh.colors[0].x == Approx(2.0 * (0.25 / M_PI + highlight) / 4.0).epsilon(1e-12));
    CHECK(mesh.colors[0].y == Approx(1.0 * (0.125 / M_PI + highlight) / 4.0).epsilon(1e-12));
    CHECK(mesh.colors[0].z == 0.0);
    CHECK(mesh.colors[0].w == 1.0);
}

TEST_CASE("a Beckmann lobe's stand-in has its width and its height, and 128 is the most") {
    const std::string metal =
        R"({"cook_torrance": {"diffuse": 0, "specular": 1, "f0": 0.5, "lobes": [{"m": 0.25, "weight": 1}]}})";
    const double cosine = std::cos(M_PI / 6.0), height = 0.5 / (M_PI * 0.0625);
    CHECK(gl_mesh(metal, 100.0).colors[0].x ==
          Approx(2.0 * height * std::pow(cosine, 32.0) / 100.0).epsilon(1e-12));
    const std::string sharp =
        R"({"modified_phong": {"diffuse": 0, "specular": 1, "exponent": 1000}})";
    CHECK(gl_mesh(sharp, 1.0).colors[0].x ==
          Approx(2.0 * 1002.0 / (2.0 * M_PI) * std::pow(cosine, 128.0)).epsilon(1e-9));
}

TEST_CASE("colours beyond white are cut at the vertices") {
    const std::string phong = R"({"modified_phong": {"diffuse": 1, "specular": 0, "exponent": 1}})";
    CHECK(gl_mesh(phong, 1e-3).colors[0].x == 1.0);
}

TEST_CASE("the sum at a vertex is equation 1 there") {
    const Scene scene =
        lit_scene(R"({"modified_phong": {"diffuse": 0.5, "specular": 0.3, "exponent": 6}})");
    const SampledScene sampled = sample_scene(scene, 1, [](const std::string&) {});
    const Mesh mesh = lit_mesh(make_vertex_sum_frame(scene, load_assets(scene), sampled, 4.0, 1));
    const SurfaceView at{{0, 0, 1}, normalized(Vec3{-1, 0, 3})};
    const Rgb sum = outgoing_radiance(sampled.brdfs.at("m"), sampled.lights.lights, at);
    CHECK(mesh.colors[1].x == sum.x / 4.0);
    CHECK(mesh.colors[1].y == sum.y / 4.0);
}

TEST_CASE("the first samples of many are those of a scene with so few") {
    Scene scene =
        lit_scene(R"({"modified_phong": {"diffuse": 0.5, "specular": 0.3, "exponent": 6}})");
    const auto quiet = [](const std::string&) {};
    const SampledScene many = sample_scene(scene, 1, quiet);
    scene.factorization.samples = 120;
    const SampledScene few = sample_scene(scene, 2, quiet);
    const LightingSamples cut = first_samples(many, 120).samples.at("m").fit;
    const LightingSamples& own = few.samples.at("m").fit;
    REQUIRE(cut.radiance.size() == 120);
    CHECK(cut.radiance == own.radiance);
    for (std::size_t i = 0; i < 120; ++i) CHECK(cut.at[i].v == own.at[i].v);
}
