#include "factor/scale.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// Steps of 2^(1/4) on either side that the search goes.
constexpr int search_steps = 16;

/// A doubling pass draws the object once more: it has to lower the error to this share of it.
constexpr double doubling_pays = 0.8;

double constant_of(const ChannelProduct& product, double white) {
    return product.scale > 0.0 ? product.scale / white : 0.0;
}

ChannelProduct with_limits(const ChannelProduct& product, const MapShape& shape, double limit1,
                           double limit2, double limit3 = 1.0) {
    ChannelProduct result = product;
    result.t1 = limited(product.t1, shape, limit1);
    result.t2 = limited(product.t2, shape, limit2);
    for (double& value : result.view) value = min(value / limit3, 1.0);
    result.scale = product.scale * limit1 * limit2 * limit3;
    return result;
}

/// One way to carry the constant of a channel.
struct Candidate {
    double limit1 = 1.0, limit2 = 1.0;
    double color = 0.0;
    double limit3 = 1.0;  ///< of g, which the vertex colour clips
    double error = std::numeric_limits<double>::infinity();  ///< mean square, in units of white
};

double displayed(double x) { return min(x, 1.0); }

/// Mean square of what the bytes of a candidate show less what the product shows.
double error_of(const ChannelProduct& product, double constant, const MapShape& shape,
                const Candidate& candidate, double scale, std::span<const PairFootprint> pairs) {
    const std::vector<double> t1 = byte_values(limited(product.t1, shape, candidate.limit1).texel);
    const std::vector<double> t2 = byte_values(limited(product.t2, shape, candidate.limit2).texel);
    const double color = to_byte(candidate.color) / 255.0;
    const double sum = ordered_sum(pairs.size(), [&](std::size_t i) {
        const PairFootprint& at = pairs[i];
        const double g = view_value(product.view, at.cosine);
        const double wanted = constant * g * filtered(product.t1.texel, at.first) *
                              filtered(product.t2.texel, at.second);
        const double shown = scale * color * min(g / candidate.limit3, 1.0) *
                             filtered(t1, at.first) * filtered(t2, at.second);
        const double difference = displayed(shown) - displayed(wanted);
        return difference * difference;
    });
    return sum / static_cast<double>(pairs.size());
}

/// The best way to carry a channel at combiner scale k.
Candidate best_candidate(const ChannelProduct& product, double constant, const MapShape& shape,
                         double k, std::span<const PairFootprint> pairs) {
    if (constant == 0.0) return {.error = 0.0};
    Candidate best;
    const auto consider = [&](Candidate candidate) {
        candidate.error = error_of(product, constant, shape, candidate, k, pairs);
        if (candidate.error < best.error) best = candidate;
    };
    const double least_limit3 = product.view.empty() ? 1.0 : 0.125;
    for (double limit3 = 1.0; limit3 >= least_limit3; limit3 *= 0.5) {
        const double rest = constant * limit3;
        if (rest <= k) consider({1.0, 1.0, rest / k, limit3});
        for (int j = -search_steps; j <= search_steps; ++j) {
            const double limit1 = exact::pow(2.0, 0.25 * j);
            const double limit2 = k / (rest * limit1);
            if (limit1 <= 2.0 && limit2 <= 2.0) consider({limit1, limit2, 1.0, limit3});
        }
    }
    return best;
}

struct Choice {
    std::array<Candidate, 3> channel;
    double error = 0.0;
};

Choice best_choice(const std::array<ChannelProduct, 3>& channels, Rgb c, const MapShape& shape,
                   double k, std::span<const PairFootprint> pairs) {
    Choice choice;
    for (std::size_t i = 0; i < 3; ++i) {
        choice.channel[i] = best_candidate(channels[i], c[static_cast<int>(i)], shape, k, pairs);
        choice.error += choice.channel[i].error;
    }
    return choice;
}

ScaledProduct best_split(const std::array<ChannelProduct, 3>& channels,
                         const FactorSettings& settings, Rgb c,
                         std::span<const PairFootprint> pairs) {
    const MapShape shape = shape_of(settings);
    ScaledProduct result{channels, c, {}};
    Choice best{{}, std::numeric_limits<double>::infinity()};
    const int largest = settings.combiner_scale;
    for (int k = 1; k <= 2 * largest; k *= 2) {
        const bool doubled = k > largest;
        if (doubled && (max_component(c) <= largest || settings.terms > 1)) break;
        const Choice choice = best_choice(channels, c, shape, k, pairs);
        if (!(choice.error < (doubled ? doubling_pays * doubling_pays : 1.0) * best.error))
            continue;
        best = choice;
        result.split.combiner_scale = doubled ? largest : k;
        result.split.doubling_passes = doubled ? 1 : 0;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Candidate& chosen = best.channel[i];
        result.channels[i] =
            with_limits(channels[i], shape, chosen.limit1, chosen.limit2, chosen.limit3);
        result.split.color[static_cast<int>(i)] = chosen.color;
    }
    return result;
}

void warn_of_vanished(ScaleSplit& split, Rgb c) {
    for (int i = 0; i < 3; ++i) {
        if (c[i] == 0.0 || split.color[i] >= 1.0 / 510.0) continue;
        split.warnings.push_back(
            fmt::format("channel {} vanishes: vertex colour {:.6g} is 0 in 8 bits",
                        channel_name(static_cast<std::size_t>(i)), split.color[i]));
    }
}

}  // namespace

ScaleSplit split_scale(Rgb c, int largest_scale) {
    ScaleSplit split;
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(c[i]) && c[i] >= 0.0) continue;
        throw Error(ExitCode::failure,
                    fmt::format("factor: scale constant of channel {} is {}",
                                channel_name(static_cast<std::size_t>(i)), c[i]));
    }
    const double largest = max_component(c);
    while (split.combiner_scale < largest_scale && split.combiner_scale < largest)
        split.combiner_scale *= 2;
    double scale = split.combiner_scale;
    for (; scale < largest; scale *= 2.0) ++split.doubling_passes;
    split.color = c / scale;

    if (split.doubling_passes > 0) {
        split.warnings.push_back(fmt::format(
            "scale constant {:.6g} exceeds the combiner's {}: {} doubling passes needed", largest,
            largest_scale, split.doubling_passes));
    }
    warn_of_vanished(split, c);
    return split;
}

ScaleSplit with_doubling(ScaleSplit split, int doubling_passes) {
    for (; split.doubling_passes < doubling_passes; ++split.doubling_passes) {
        if (split.combiner_scale > 1)
            split.combiner_scale /= 2;
        else
            split.color *= 0.5;
    }
    return split;
}

ScaledProduct scaled_product(const std::array<ChannelProduct, 3>& channels,
                             const FactorSettings& settings, double white,
                             std::span<const PairFootprint> pairs) {
    const MapShape shape = shape_of(settings);
    Rgb c{0.0};
    for (std::size_t i = 0; i < 3; ++i) c[static_cast<int>(i)] = constant_of(channels[i], white);
    ScaledProduct result{channels, c, split_scale(c, settings.combiner_scale)};
    if (settings.scale == ScaleRule::maximum || max_component(c) == 0.0) return result;
    if (settings.scale == ScaleRule::best_split) {
        result = best_split(channels, settings, c, pairs);
        warn_of_vanished(result.split, c);
        return result;
    }
    Rgb constant{0.0};
    for (std::size_t i = 0; i < 3; ++i) {
        if (c[static_cast<int>(i)] == 0.0) continue;
        const auto limit = [&](const NormalisedChannel& map) {
            return max(percentile(map, shape, settings.scale_percentile), 1.0 / 65536.0);
        };
        result.channels[i] =
            with_limits(channels[i], shape, limit(channels[i].t1), limit(channels[i].t2));
        constant[static_cast<int>(i)] = constant_of(result.channels[i], white);
    }
    result.split = split_scale(constant, settings.combiner_scale);
    return result;
}

}  // namespace twofold
