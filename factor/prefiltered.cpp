#include "factor/prefiltered.hpp"

#include <algorithm>
#include <utility>

#include "factor/factorize_check.hpp"
#include "factor/lighting.hpp"
#include "texunit/error.hpp"
#include "texunit/fixed.hpp"

namespace twofold {

namespace {

struct Parts {
    Brdf diffuse, specular;
};

Parts parts_of(const Brdf& brdf) {
    return std::visit(
        [](const auto& material) -> Parts {
            if constexpr (requires { material.specular; }) {
                auto diffuse = material, specular = material;
                diffuse.specular = specular.diffuse = Rgb(0.0);
                return {diffuse, specular};
            }
            throw Error(ExitCode::failure,
                        "factor: model prefilter needs a material with a diffuse and a specular "
                        "part, and a measured one has none");
        },
        brdf);
}

/// Radiance seen head on, at every texel.
std::vector<Rgb> head_on(const Brdf& brdf, const DistantLights& lights, const MapShape& shape,
                         int threads) {
    std::vector<SurfaceView> at;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const Vec3 d = texel_direction(texel_at(j, shape), shape);
        at.push_back({d, d});
    }
    return outgoing_radiance(brdf, lights, at, threads);
}

/// Radiance in units of white, clipped there.
NormalisedChannel in_white(std::span<const double> radiance, double white) {
    NormalisedChannel map;
    std::size_t clipped = 0;
    for (const double value : radiance) {
        clipped += value > white ? 1U : 0U;
        map.texel.push_back(min(value / white, 1.0));
    }
    map.clipped_share = static_cast<double>(clipped) / static_cast<double>(radiance.size());
    return map;
}

/// What a sum of two maps shows at pairs.
std::vector<double> sums_at(std::span<const double> t1, std::span<const double> t2,
                            std::span<const PairFootprint> pairs) {
    std::vector<double> sums;
    for (const PairFootprint& pair : pairs)
        sums.push_back(filtered(t1, pair.first) + filtered(t2, pair.second));
    return sums;
}

/// One channel: color x t1 + t2, in units of white.
struct PrefilteredChannel {
    NormalisedChannel t1, t2;
    double color = 0.0;
};

PrefilteredChannel channel_maps(std::span<const double> diffuse, std::span<const double> specular,
                                const MapShape& shape, double white) {
    NormalisedChannel lit = in_white(diffuse, white);
    PrefilteredChannel channel{normalised_values(std::move(lit.texel), shape),
                               in_white(specular, white)};
    channel.t1.clipped_share = lit.clipped_share;
    channel.color = maximum_of(channel.t1);
    return channel;
}

/// The sums that 8 bits hold.
std::vector<double> byte_sums_at(const PrefilteredChannel& channel, double white,
                                 std::span<const PairFootprint> pairs) {
    std::vector<double> first = byte_values(channel.t1.texel),
                        second = byte_values(channel.t2.texel);
    for (double& value : first) value *= channel.color * white;
    for (double& value : second) value *= white;
    return sums_at(first, second, pairs);
}

void put_constants(ProductTerm& term, int c, const PrefilteredChannel& channel, double white) {
    const double largest = *std::max_element(channel.t2.texel.begin(), channel.t2.texel.end());
    term.scale_color[c] = channel.color;
    term.max1[c] = channel.color * white;
    term.max2[c] = white;
    term.c[c] = max(channel.color, largest);
}

}  // namespace

FactoredLighting prefilter(const Brdf& brdf, const DistantLights& lights,
                           const MaterialSamples& samples, const FactorSettings& settings,
                           double white, int threads) {
    check_arguments(samples.fit, samples.held_out, settings, white);
    const MapShape shape = shape_of(settings);
    const Parts parts = parts_of(brdf);
    const std::vector<Rgb> diffuse = head_on(parts.diffuse, lights, shape, threads);
    const std::vector<Rgb> specular = head_on(parts.specular, lights, shape, threads);
    const LightingSamples& judged = samples.held_out.at.empty() ? samples.fit : samples.held_out;
    const std::vector<PairFootprint> pairs = footprints_of(judged.at, shape);

    FactoredLighting result;
    result.model = Model::prefilter;
    result.white = white;
    result.closed_form = "prefiltered";
    ProductTerm term;
    term.sum_of_maps = true;
    std::array<NormalisedChannel, 3> t1, t2;
    for (std::size_t c = 0; c < 3; ++c) {
        const int number = static_cast<int>(c);
        const auto d = channel_of(diffuse, number), s = channel_of(specular, number);
        PrefilteredChannel channel = channel_maps(d, s, shape, white);
        put_constants(term, number, channel, white);
        put_error(result.fit[c],
                  fit_error(sums_at(d, s, pairs), byte_sums_at(channel, white, pairs),
                            channel_of(judged.radiance, number), white));
        t1[c] = std::move(channel.t1);
        t2[c] = std::move(channel.t2);
    }
    term.t1 = make_factor_map(t1, shape, "t1");
    term.t2 = make_factor_map(t2, shape, "t2");
    result.terms.push_back(std::move(term));
    return result;
}

}  // namespace twofold
