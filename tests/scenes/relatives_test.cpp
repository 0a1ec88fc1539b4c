#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "raster/reference.hpp"
#include "scenes/exact_picture.hpp"
#include "scenes/lighting.hpp"
#include "scenes/object_passes.hpp"
#include "scenes/scene_file.hpp"

using namespace twofold;

namespace {

const std::string lamps = R"({"painted": {"background": 0.4, "width": 32, "height": 16, "lights": [
    {"direction": [0.5, 0.6, 0.8], "half_angle_degrees": 20, "radiance": 3},
    {"direction": [-0.8, 0.2, 0.4], "half_angle_degrees": 20, "radiance": 2}]}})";
const std::string phong = R"({"modified_phong": {"exponent": 20}})";

/// Red alone: a black channel costs no fit.
const std::string three_lights = R"({"directional": [
    {"direction": [0.3, 0.5, 0.8], "irradiance": [3, 0, 0]}, {"direction": [-0.8, 0.1, 0.5], "irradiance": [2, 0, 0]},
    {"direction": [0.2, 0.9, -0.3], "irradiance": [2, 0, 0]}]})";

Scene sphere_scene(const std::string& factorization, const std::string& material = phong,
                   const std::string& environment = lamps) {
    return parse_scene(R"({
  "image": {"width": 49, "height": 49},
  "camera": {"eye": [1, 2, 3.4], "vertical_fov_degrees": 34},
  "environment": )" + environment +
                           R"(,
  "factorization": {"samples": 12000, "held_out": 1000, )" +
                           factorization + R"(},
  "materials": {"m": )" + material +
                           R"(},
  "meshes": {"s": {"sphere": {"subdivisions": 24}}},
  "objects": [{"mesh": "s", "material": "m"}]})",
                       "t.json", "/", {"white=3"});
}

struct Drawn {
    LitScene lit;
    Frame frame;
    Framebuffer picture;
    double error = 0.0;  ///< rms of the covered pixels against the exact picture

    const FactoredLighting& lighting() const { return lit.materials.at("m"); }
};

double rms_difference(const Framebuffer& a, const Framebuffer& b) {
    double sum = 0.0;
    int covered = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        if (a.values[i][3] == 0.0 || b.values[i][3] == 0.0) continue;
        const double d = a.values[i][0] - b.values[i][0];
        sum += d * d;
        ++covered;
    }
    return std::sqrt(sum / covered);
}

Drawn draw(const Scene& scene, Preset preset = Preset::ideal64) {
    const SceneAssets assets = load_assets(scene);
    Drawn drawn{light_scene(scene, 2, [](const std::string&) {}), {}, {}, 0.0};
    drawn.frame = make_frame(scene, assets, drawn.lit.materials, preset);
    drawn.picture = render_reference(drawn.frame, preset, scene.custom);
    drawn.error = rms_difference(drawn.picture, exact_picture(scene, assets, drawn.lit, 2).picture);
    CHECK(drawn.frame.passes.size() == pass_count(drawn.lighting()));
    return drawn;
}

/// The red texels of a map, face after face.
std::vector<double> reds_of(const FactorMap& map) {
    std::vector<double> reds;
    for (const Texture& face : faces_of(map.real))
        for (const Rgba32f& t : std::get<std::vector<Rgba32f>>(face.texels))
            reds.push_back(static_cast<double>(t[0]));
    return reds;
}

/// What the passes should show in red in the middle of the picture, where the sphere's normal, the
/// view and r are one direction, clamped after each.
double sum_in_the_middle(const Scene& scene, const FactoredLighting& lighting) {
    const Vec3 n = normalized(scene.camera.eye);
    const auto at = footprints_of(std::array{SurfaceView{n, n}}, lighting.terms[0].t1.shape);
    double value = 0.0;
    for (const ProductTerm& term : lighting.terms) {
        const double product = term.scale_color.x * term.combiner_scale *
                               filtered(reds_of(term.t1), at[0].first) *
                               filtered(reds_of(term.t2), at[0].second);
        value += term.subtract ? -product : product;
        value = std::min(std::max(value, 0.0), 1.0);
    }
    return std::min(value * (1 << lighting.doubling_passes), 1.0);
}

constexpr std::size_t middle = 24 * 49 + 24;

}  // namespace

TEST_CASE("signed products are added and taken off, and the picture is the sum of the maps",
          "[long]") {
    for (const auto& [form, size] : {std::pair{"cube", "16"}, {"dual_paraboloid", "32"}}) {
        CAPTURE(form);
        const std::string maps =
            std::string(R"("map_size": )") + size + R"(, "map_form": ")" + form + "\"";
        const Scene scene = sphere_scene(R"("model": "svd", "terms": 2, "rounds": 6, )" + maps,
                                         phong, three_lights);
        const Drawn exact = draw(scene), card = draw(scene, Preset::nv17);
        std::size_t taken_off = 0;
        for (const Pass& pass : exact.frame.passes) {
            const auto& blend = pass.state.blend;
            const bool off = blend && blend->equation == BlendEquation::reverse_subtract;
            CHECK(pass.state.color_mask[3] != off);
            taken_off += off ? 1U : 0U;
        }
        CHECK(taken_off > 0);
        CHECK(exact.picture.values[middle][0] ==
              Approx(sum_in_the_middle(scene, exact.lighting())).margin(0.5 / 255.0));
        // Each product rounds its maps, its passes and what is drawn already.
        CHECK(rms_difference(exact.picture, card.picture) < 2.0 / 255.0);
        const Drawn one = draw(sphere_scene(maps, phong, three_lights));
        CHECK(exact.error < 0.8 * one.error);
    }
}

TEST_CASE("normalised decomposition draws the passes of one product") {
    const Drawn nd = draw(sphere_scene(R"("model": "nd", "row_norm": "one", "map_size": 16)"));
    CHECK(nd.frame.passes.size() == 4);
    CHECK(nd.error < 0.15);
}

TEST_CASE("prefiltered maps are added on two units in one set of passes", "[long]") {
    const Scene scene = sphere_scene(R"("model": "prefilter", "map_size": 32)");
    const Drawn drawn = draw(scene);
    REQUIRE(drawn.frame.passes.size() == 4);
    for (const Pass& pass : drawn.frame.passes) {
        CHECK(pass.state.units[1]->env.mode == TexEnvMode::add);
        CHECK_FALSE(pass.state.blend);
    }
    // Seen head on, the sum is exact but for the filtering between texels.
    const SceneAssets assets = load_assets(scene);
    const ExactPicture exact = exact_picture(scene, assets, drawn.lit, 2);
    CHECK(drawn.picture.values[middle][0] ==
          Approx(exact.picture.values[middle][0]).margin(2.0 / 255.0));
    const Drawn diffuse = draw(sphere_scene(R"("model": "prefilter", "map_size": 16)",
                                            R"({"modified_phong": {"specular": 0}})"));
    CHECK(diffuse.error < 2.5 / 255.0);
}

TEST_CASE("sphere maps take one pass, the normal's coordinates come with the mesh", "[long]") {
    const Drawn sphere = draw(sphere_scene(R"("map_form": "sphere", "map_size": 34)"));
    REQUIRE(sphere.frame.passes.size() == 1);
    const PassState& state = sphere.frame.passes[0].state;
    CHECK_FALSE(state.alpha_test);
    CHECK(state.units[0]->texgen == TexGenState{});
    CHECK(state.units[1]->texgen == texgen_all(TexGen::sphere_map));
    const Mesh& mesh = sphere.frame.meshes.at(sphere.frame.passes[0].mesh);
    REQUIRE(mesh.texcoords[0].size() == mesh.normals.size());
    const Drawn paraboloids =
        draw(sphere_scene(R"("map_form": "dual_paraboloid", "map_size": 24)"));
    CHECK(sphere.error < 1.15 * paraboloids.error);
}

TEST_CASE("a sphere map is torn where r looks straight away, at the outline of a coarse mesh",
          "[long]") {
    // Only what is mirrored shows; the light stands behind the object.
    const auto drawn = [](const std::string& form, int subdivisions) {
        Scene scene =
            sphere_scene(R"("map_size": 24, "map_form": ")" + form + "\"",
                         R"({"modified_phong": {"diffuse": 0, "specular": 1, "exponent": 5}})");
        scene.meshes["s"] = SphereMesh{subdivisions};
        return draw(scene).picture;
    };
    const auto differing = [&](int subdivisions) {
        const Framebuffer sphere = drawn("sphere", subdivisions),
                          cube = drawn("cube", subdivisions);
        int pixels = 0;
        for (std::size_t i = 0; i < sphere.values.size(); ++i)
            pixels += std::abs(sphere.values[i][0] - cube.values[i][0]) > 0.1 ? 1 : 0;
        return pixels;
    };
    const int coarse = differing(3), fine = differing(40);
    CAPTURE(coarse, fine);
    CHECK(coarse > 3 * fine + 10);
}

TEST_CASE("a BRDF's p q p takes a pass for each light and one for p(v), through 8 bits") {
    const Scene scene = sphere_scene(R"("model": "mccool", "map_size": 64)",
                                     R"({"modified_phong": {"exponent": 5}})", three_lights);
    const Drawn drawn = draw(scene), card = draw(scene, Preset::nv17);
    REQUIRE(drawn.frame.passes.size() == 4);
    CHECK(drawn.frame.passes[1].state.blend->source == BlendFactor::one);
    CHECK(drawn.frame.passes[3].state.blend == Blend{BlendFactor::zero, BlendFactor::src_color});
    // In the middle n and v are one: the sum over the lights by the float maps.
    const FactoredLighting& lighting = drawn.lighting();
    const MapShape& shape = lighting.terms[0].t1.shape;
    const std::vector<double> p = reds_of(lighting.terms[0].t1), q = reds_of(lighting.terms[0].t2);
    const auto at = [&](const std::vector<double>& map, double cosine) {
        return filtered(map, footprint_of({std::sqrt(1.0 - cosine * cosine), 0.0, cosine}, shape));
    };
    const Vec3 n = normalized(scene.camera.eye);
    double sum = 0.0;
    for (std::size_t k = 0; k < lighting.lights.size(); ++k) {
        const Vec3 l = lighting.lights.direction(k);
        const double cosine = dot(n, l);
        if (cosine <= 0.0) continue;
        sum +=
            lighting.lights.weight(k).x * cosine * at(p, cosine) * at(q, dot(n, normalized(l + n)));
    }
    const double wanted = sum * at(p, 1.0) * lighting.terms[0].scale_color.x *
                          lighting.terms[0].combiner_scale * (1 << lighting.doubling_passes);
    CHECK(drawn.picture.values[middle][0] == Approx(wanted).margin(1.5 / 255.0));
    CHECK(rms_difference(drawn.picture, card.picture) < 2.0 / 255.0);
    CHECK(drawn.error < 0.1);
}

TEST_CASE("more lights than mccool draws are refused with what to do") {
    CHECK_THROWS_WITH(draw(sphere_scene(R"("model": "mccool", "map_size": 16)")),
                      Catch::Contains("at most 64") && Catch::Contains("directional"));
}

TEST_CASE("a surface light field draws vertex colours times a map of r") {
    Scene scene = sphere_scene(R"("model": "slf", "terms": 2, "rounds": 6, "map_form": "cube",
                                  "map_size": 16)",
                               phong, three_lights);
    scene.meshes["s"] = SphereMesh{10};
    const Drawn slf = draw(scene), card = draw(scene, Preset::nv17);
    const ProductTerm& first = slf.lighting().terms[0];
    const Mesh& mesh = slf.frame.meshes.at(slf.frame.passes[0].mesh);
    REQUIRE(mesh.colors.size() == first.vertices.size());
    CHECK(mesh.colors[7].x == Approx(first.scale_color.x * first.vertices[7].x));
    for (const Pass& pass : slf.frame.passes) CHECK_FALSE(pass.state.units[1]);
    CHECK(rms_difference(slf.picture, card.picture) < 2.0 / 255.0);
    scene.factorization.terms = 1;
    CHECK(slf.error < 0.8 * draw(scene).error);
    CHECK(slf.error < 0.05);
}

TEST_CASE("on a plane whose radiance is a product the surface light field is exact") {
    // One normal: L is a function of r alone, and t1 is constant over vertices and texels.
    for (const std::string rows : {"vertices", "texels"}) {
        CAPTURE(rows);
        Scene scene = sphere_scene(
            R"("model": "slf", "smoothness": 0.05, "map_form": "sphere", "map_size": 32, "surface_rows": ")" +
                rows + "\"",
            R"({"modified_phong": {"exponent": 5}})", three_lights);
        scene.meshes["s"] = QuadMesh{};
        const Drawn drawn = draw(scene);
        CHECK(drawn.lighting().fit[0].relative_rms < 0.02);
        const ProductTerm& term = drawn.lighting().terms[0];
        const std::vector<double> t1 = reds_of(term.t1);
        if (rows == "vertices")
            for (const Rgb& value : term.vertices) CHECK(value.x == Approx(1.0).margin(0.02));
        else
            CHECK(*std::min_element(t1.begin(), t1.end()) > 0.9);
        CHECK(drawn.error < 3.0 / 255.0);
    }
}

TEST_CASE("a surface light field needs one object a material, and coordinates for its texels") {
    CHECK_THROWS_WITH(draw(sphere_scene(R"("model": "slf", "surface_rows": "texels")")),
                      Catch::Contains("'s' has no texture coordinates"));
    const std::string two = R"({"environment": {"painted": {}}, "factorization": {"model": "slf"},
        "materials": {"m": {"modified_phong": {}}}, "meshes": {"s": {"sphere": {}}},
        "objects": [{"mesh": "s", "material": "m"}, {"mesh": "s", "material": "m"}]})";
    CHECK_THROWS_WITH(parse_scene(two, "t.json", "/"),
                      Catch::Contains("objects.1.material: 'm' is that of objects.0 too"));
}
