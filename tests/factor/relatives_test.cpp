#include <catch2/catch.hpp>
#include <cmath>

#include "factor/approximate.hpp"
#include "factor/lighting.hpp"
#include "factor_cases.hpp"
#include "texunit/sphere_map.hpp"

using namespace twofold;

namespace {

DistantLights lamps() {
    DistantLights lights;
    for (const Vec3 l : cases::many_lights()) lights.push_back(l, Rgb(0.4, 0.3, 0.0));
    return bound_blocks(std::move(lights));
}

LightingSamples samples_of(const Brdf& brdf, const DistantLights& lights,
                           std::vector<SurfaceView> at) {
    LightingSamples samples{std::move(at), {}};
    samples.radiance = outgoing_radiance(brdf, lights, samples.at, 2);
    return samples;
}

std::vector<SurfaceView> head_on(int count) {
    std::vector<SurfaceView> at = surface_views(count, 1);
    for (SurfaceView& pair : at) pair.v = pair.n;
    return at;
}

FactorSettings settings_of(Model model, int map_size) {
    FactorSettings settings;
    settings.model = model;
    settings.map_size = map_size;
    settings.samples = 20000;
    return settings;
}

}  // namespace

TEST_CASE("prefiltered maps are exact for diffuse materials, and for others seen head on") {
    const FactorSettings settings = settings_of(Model::prefilter, 48);
    const ModifiedPhong diffuse{Rgb(0.8), Rgb(0.0), 1.0};
    const CookTorrance glass{Rgb(0.3), Rgb(0.7), Rgb(0.04), {{0.4, 1.0}}};
    const auto error = [&](const Brdf& brdf, std::vector<SurfaceView> at) {
        const LightingSamples judged = samples_of(brdf, lamps(), std::move(at));
        const auto result = approximate(brdf, lamps(), {judged, {}}, settings, 1.0, 2);
        CHECK(result.terms.size() == 1);
        CHECK(result.terms[0].sum_of_maps);
        CHECK(result.terms[0].c.z == 0.0);
        return result.fit[0].relative_rms;
    };
    CHECK(error(diffuse, surface_views(3000, 1)) < 0.003);
    CHECK(error(ModifiedPhong{Rgb(0.2), Rgb(0.7), 8.0}, head_on(3000)) < 0.005);
    CHECK(error(glass, head_on(3000)) < 0.02);
    // And off the normal it is not: r stands in for n in the cosine.
    CHECK(error(ModifiedPhong{Rgb(0.2), Rgb(0.7), 8.0}, surface_views(3000, 1)) > 0.1);
}

TEST_CASE("a measured material has no parts to filter") {
    const LightingSamples samples = samples_of(ModifiedPhong{}, lamps(), surface_views(100, 1));
    CHECK_THROWS_WITH(approximate(MeasuredBrdf{}, lamps(), {samples, {}},
                                  settings_of(Model::prefilter, 8), 1.0, 1),
                      Catch::Contains("a measured one has none"));
}

TEST_CASE("p q p of a diffuse BRDF is that BRDF under every light") {
    DistantLights two;
    two.push_back(normalized(Vec3(0.2, 0.4, 0.9)), Rgb(2.0));
    two.push_back(normalized(Vec3(-0.7, 0.1, 0.2)), Rgb(1.0, 0.5, 0.25));
    const DistantLights lights = bound_blocks(two);
    const ModifiedPhong diffuse{Rgb(0.8, 0.4, 0.2), Rgb(0.0), 1.0};
    const LightingSamples judged = samples_of(diffuse, lights, surface_views(2000, 1));
    const FactoredLighting result =
        approximate(diffuse, lights, {judged, {}}, settings_of(Model::mccool, 32), 1.0, 2);
    for (const ChannelFit& fit : result.fit) CHECK(fit.relative_rms < 1e-4);
    CHECK(result.lights.size() == 2);
    CHECK(result.terms[0].c.x == Approx(0.8 / 3.14159265358979 * 2.0).epsilon(1e-4));
    // A lobe is no product of that kind, but near one.
    const ModifiedPhong shiny{Rgb(0.4), Rgb(0.4), 10.0};
    const LightingSamples lobes = samples_of(shiny, lights, surface_views(2000, 1));
    const auto near =
        approximate(shiny, lights, {lobes, {}}, settings_of(Model::mccool, 32), 1.0, 2);
    CHECK(near.fit[0].relative_rms > 0.05);
    CHECK(near.fit[0].relative_rms < 0.6);
}

TEST_CASE("a direction and its sphere map point find each other, but at -z") {
    for (const SurfaceView& at : surface_views(500, 2)) {
        const Vec2 st = to_sphere_map(at.n);
        // OpenGL 1.3, 2.10.4, as printed.
        const double m =
            2.0 * std::sqrt(at.n.x * at.n.x + at.n.y * at.n.y + (at.n.z + 1.0) * (at.n.z + 1.0));
        CHECK(st.x == Approx(at.n.x / m + 0.5));
        CHECK(st.y == Approx(at.n.y / m + 0.5));
        CHECK(length(from_sphere_map(st) - at.n) < 1e-7);
    }
    CHECK(to_sphere_map({0.0, 0.0, 1.0}) == Vec2(0.5, 0.5));
    CHECK(to_sphere_map({0.0, 0.0, -1.0}) == Vec2(1.0, 0.5));
    CHECK(from_sphere_map({0.02, 0.03}) == Vec3(0.0, 0.0, -1.0));
}

TEST_CASE("a sphere map's texels are found again by their directions, and beyond the rim lies -z") {
    const MapShape shape{16, 0.875, MapForm::sphere};
    CHECK(shape.texels() == 256);
    std::size_t beyond = 0;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const MapTexel texel = texel_at(j, shape);
        CHECK(is_opaque(texel, shape));
        const Vec3 d = texel_direction(texel, shape);
        if (!within_face(texel, shape)) {
            ++beyond;
            CHECK(d == Vec3(0.0, 0.0, -1.0));
            continue;
        }
        const TexelFootprint at = footprint_of(d, shape);
        double own = 0.0;
        for (std::size_t k = 0; k < 4; ++k) own += at.index[k] == j ? at.weight[k] : 0.0;
        CHECK(own == Approx(1.0).margin(1e-6));
    }
    CHECK(beyond > 40);
    CHECK(beyond < 60);
}
