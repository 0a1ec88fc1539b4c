#include "scenes/material_samples.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "factor/row_order.hpp"
#include "scenes/lighting.hpp"
#include "scenes/scene_file.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

void quiet(const std::string&) {}

/// A sphere of a metal under two lights or many.
Scene metal_scene(const std::string& environment, int samples) {
    Scene scene = parse_scene(R"({
      "image": {"width": 8, "height": 8},
      "camera": {"eye": [0, 0, 3], "target": [0, 0, 0]},
      "environment": )" + environment +
                                  R"(,
      "factorization": {"map_size": 16, "held_out": 500, "iteration_limit": 20},
      "materials": {"m": {"cook_torrance": {"diffuse": 0.1, "specular": 0.9, "f0": [0.9, 0.7, 0.3],
                                            "lobes": [{"m": 0.3, "weight": 1}]}}},
      "meshes": {"s": {"sphere": {}}},
      "objects": [{"mesh": "s", "material": "m"}]})",
                              "s.json", ".");
    scene.factorization.samples = samples;
    return scene;
}

const std::string two_lights = R"({"directional": [
  {"direction": [0.6, 0, 0.8], "irradiance": [2, 1, 0.5]}, {"direction": [0, 0.6, 0.8], "irradiance": 1}]})";
const std::string many_lights =
    R"({"painted": {"background": [0.2, 0.3, 0.4], "width": 64, "height": 32}})";

/// Floats of both maps, error figures and constants.
std::vector<double> values_of(const FactoredLighting& lighting) {
    std::vector<double> values;
    for (const FactorMap* map : {&lighting.terms[0].t1, &lighting.terms[0].t2})
        for (const Texture& texture : map->real)
            for (const Rgba32f& texel : std::get<std::vector<Rgba32f>>(texture.texels))
                values.insert(values.end(), {texel[0], texel[1], texel[2]});
    for (const ChannelFit& fit : lighting.fit)
        values.insert(values.end(), {fit.relative_rms, fit.byte_rms});
    for (const Rgb& c : {lighting.terms[0].c, lighting.terms[0].scale_color})
        values.insert(values.end(), {c.x, c.y, c.z});
    return values;
}

/// Radiances of all magnitudes, zeros among them.
MaterialSamples scattered_samples(std::size_t count) {
    MaterialSamples samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double size = i % 7 == 0 ? 0.0 : std::ldexp(1.0, static_cast<int>(i % 60) - 30);
        samples.fit.at.push_back({{0, 0, 1}, {0, 0, 1}});
        samples.fit.radiance.push_back(
            {size * random_unit(1, i), size * random_unit(2, i), size * random_unit(3, i)});
    }
    return samples;
}

}  // namespace

TEST_CASE("samples that are placed as they are made give the bits of those held at once") {
    // More than a block of ordered rows and than two batches.
    const Scene scene = metal_scene(two_lights, static_cast<int>(ordered_rows) + 1000);
    const SampledScene sampled = sample_scene(scene, 2, quiet);
    const double white = white_radiance(scene.white, sampled.samples);
    const LitScene at_once = factor_scene(scene, sampled, white, 2, quiet);
    const LitScene placed = light_scene(scene, 2, quiet);
    CHECK(placed.white == white);
    const FactoredLighting &a = placed.materials.at("m"), &b = at_once.materials.at("m");
    CHECK(values_of(a) == values_of(b));
    CHECK(a.warnings == b.warnings);
}

TEST_CASE("a batch of samples is a part of all, whatever sums the lights") {
    const std::string environment = GENERATE(two_lights, many_lights);
    const Scene scene = metal_scene(environment, 700);
    const DistantLights lights = make_lights(scene).lights;
    const Brdf& metal = scene.materials.at("m");
    const MaterialSampler sampler(metal, lights, scene.factorization, 2);
    CHECK(sampler.report().has_value() == (environment == many_lights));
    const LightingSamples all = sampler.fitted(), batch = sampler.fitted(300, 250);
    REQUIRE(all.at.size() == 700);
    REQUIRE(batch.radiance.size() == 250);
    for (std::size_t i = 0; i < 250; ++i) {
        CHECK(batch.at[i].n == all.at[300 + i].n);
        CHECK(batch.at[i].v == all.at[300 + i].v);
        CHECK(batch.radiance[i] == all.radiance[300 + i]);
    }
    CHECK_FALSE(sampler.held_out().at[0].n == all.at[0].n);
}

TEST_CASE("the white point is the percentile of the samples' largest channels") {
    const MaterialSamples samples = scattered_samples(4001);
    std::vector<double> sorted;
    for (const Rgb& radiance : samples.fit.radiance) sorted.push_back(max_component(radiance));
    std::sort(sorted.begin(), sorted.end());
    FitSamples placed({}, samples.fit.at.size());
    placed.add(samples.fit, 1);
    std::map<std::string, FitSamples> all_placed;
    all_placed.emplace("m", placed);
    for (const double percent : {0.0, 14.2, 14.4, 50.0, 99.5, 99.99, 100.0}) {
        const WhitePoint white{.radiance = std::nullopt, .percentile = percent};
        const double wanted = sorted[static_cast<std::size_t>(percent / 100.0 * 4000.0)];
        CHECK(white_radiance(white, {{"m", samples}}) == (wanted > 0.0 ? wanted : 1.0));
        CHECK(white_radiance(white, all_placed) == (wanted > 0.0 ? wanted : 1.0));
    }
    CHECK(white_radiance({.radiance = 3.5, .percentile = 99.0}, {{"m", samples}}) == 3.5);
    CHECK(white_radiance(WhitePoint{}, std::map<std::string, MaterialSamples>{}) == 1.0);
}
