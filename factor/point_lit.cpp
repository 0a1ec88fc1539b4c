#include "factor/point_lit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "factor/evaluate.hpp"
#include "factor/factorize_check.hpp"
#include "factor/scale.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/random.hpp"

namespace twofold {

namespace {

constexpr Vec3 normal{0.0, 0.0, 1.0};

/// Waterloo's, which the passes use (scenes/point_lit_passes.hpp).
constexpr double surface_guard = 0.875;

/// Number `index` of the directions above the horizon, even on the sphere.
Vec3 random_direction(std::uint64_t seed, std::uint64_t index) {
    const double z = 1.0 - random_unit(seed, 2 * index);
    const double turn = 2.0 * exact::pi * random_unit(seed, 2 * index + 1);
    const double across = std::sqrt(max(1.0 - z * z, 0.0));
    return {across * exact::cos(turn), across * exact::sin(turn), z};
}

std::vector<BrdfSample> samples_of(const Brdf& brdf, int count) {
    std::vector<BrdfSample> samples;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        const Vec3 l = random_direction(1, i), v = random_direction(2, i);
        samples.push_back({l, v, evaluate(brdf, normal, v, l)});
    }
    return samples;
}

FactoredBrdf factors_of(const Brdf& brdf, const FactorSettings& settings, int threads) {
    const auto* measured = std::get_if<MeasuredBrdf>(&brdf);
    if (measured != nullptr && measured->model->report.factors)
        return {measured->model->product, *measured->model->report.factors};
    return factor_brdf(samples_of(brdf, settings.samples), threads);
}

MapShape surface_shape(const FactorSettings& settings) {
    return {settings.map_size, surface_guard, MapForm::hemisphere};
}

/// A profile over the map: p by the paraboloid's radius, q by (1 - cos theta)^(1/4).
NormalisedChannel map_of(const Profile& profile, bool half_vector, std::size_t c,
                         const MapShape& shape) {
    NormalisedChannel map;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const double cosine = max(texel_direction(texel_at(j, shape), shape).z, 0.0);
        const double place =
            half_vector ? std::sqrt(std::sqrt(max(1.0 - cosine, 0.0))) : paraboloid_radius(cosine);
        map.texel.push_back(static_cast<double>(value_at(profile, min(place, 1.0))[c]));
    }
    return map;
}

/// A direction's footprint by its cosine alone: the maps are symmetric about the normal.
TexelFootprint footprint_at(double cosine, const MapShape& shape) {
    const double z = min(max(cosine, 0.0), 1.0);
    return footprint_of({std::sqrt(1.0 - z * z), 0.0, z}, shape);
}

/// Both maps of a channel, and alpha.
struct ChannelMaps {
    std::vector<double> p, q;
    double alpha = 0.0;
};

double radiance_at(const ChannelMaps& maps, int c, const MapShape& shape,
                   const DistantLights& lights, const SurfaceView& at) {
    double sum = 0.0;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Vec3 l = lights.direction(k), h = l + at.v;
        const double cosine = dot(at.n, l), along = length(h);
        if (!(cosine > 0.0) || !(along > 0.0)) continue;
        sum += lights.weight(k)[c] * cosine * filtered(maps.p, footprint_at(cosine, shape)) *
               filtered(maps.q, footprint_at(dot(at.n, h) / along, shape));
    }
    return maps.alpha * sum * filtered(maps.p, footprint_at(dot(at.n, at.v), shape));
}

FitError error_of(const ChannelMaps& maps, int c, const MapShape& shape,
                  const DistantLights& lights, const LightingSamples& judged, double white) {
    const auto all = [&](const ChannelMaps& from) {
        std::vector<double> values;
        for (const SurfaceView& at : judged.at)
            values.push_back(radiance_at(from, c, shape, lights, at));
        return values;
    };
    return fit_error(all(maps), all({byte_values(maps.p), byte_values(maps.q), maps.alpha}),
                     channel_of(judged.radiance, c), white);
}

/// The constant of the brightest light, in the vertex colour, the combiner's scale and doubling
/// passes.
void put_scale(FactoredLighting& result, Rgb alpha, int largest_scale) {
    Rgb brightest{0.0};
    for (std::size_t k = 0; k < result.lights.size(); ++k)
        for (int c = 0; c < 3; ++c) brightest[c] = max(brightest[c], result.lights.weight(k)[c]);
    ProductTerm& term = result.terms[0];
    term.c = alpha * brightest / result.white;
    ScaleSplit split = split_scale(term.c, largest_scale);
    term.combiner_scale = split.combiner_scale;
    result.doubling_passes = split.doubling_passes;
    result.warnings = std::move(split.warnings);
    // At a light of irradiance 1: the passes multiply by the irradiance of each.
    term.scale_color = alpha / (result.white * split.combiner_scale *
                                static_cast<double>(1 << split.doubling_passes));
    term.max1 = Rgb(1.0);
    term.max2 = Rgb(1.0);
}

}  // namespace

FactoredLighting factor_point_lit(const Brdf& brdf, const DistantLights& lights,
                                  const MaterialSamples& samples, const FactorSettings& settings,
                                  double white, int threads) {
    check_arguments(samples.fit, samples.held_out, settings, white);
    if (lights.size() > most_point_lights)
        throw Error(ExitCode::failure,
                    fmt::format("factor: model mccool draws a pass for each light, at most {}, and "
                                "the environment has {}: give 'directional' lights or fewer cells",
                                most_point_lights, lights.size()));
    const MapShape shape = surface_shape(settings);
    const FactoredBrdf factored = factors_of(brdf, settings, threads);
    const LightingSamples& judged = samples.held_out.at.empty() ? samples.fit : samples.held_out;

    FactoredLighting result;
    result.model = Model::mccool;
    result.white = white;
    result.lights = lights;
    result.terms.resize(1);
    std::array<NormalisedChannel, 3> p, q;
    Rgb alpha{0.0};
    for (std::size_t c = 0; c < 3; ++c) {
        const int channel = static_cast<int>(c);
        alpha[channel] = static_cast<double>(factored.brdf.alpha[c]);
        p[c] = map_of(factored.brdf.p, false, c, shape);
        q[c] = map_of(factored.brdf.q, true, c, shape);
        result.fit[c].solver = factored.fit[c].solver;
        put_error(result.fit[c], error_of({p[c].texel, q[c].texel, alpha[channel]}, channel, shape,
                                          lights, judged, white));
    }
    result.terms[0].t1 = make_factor_map(p, shape, "p");
    result.terms[0].t2 = make_factor_map(q, shape, "q");
    put_scale(result, alpha, settings.combiner_scale);
    return result;
}

}  // namespace twofold
