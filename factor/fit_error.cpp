#include "factor/fit_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "factor/vector_arithmetic.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// Logarithms and relative errors take no value for smaller than this share of the mean.
constexpr double floor_share = 1e-3;

/// Products and radiance of the pairs that count.
struct Compared {
    std::vector<double> product;
    std::vector<double> radiance;
};

Compared compare(std::span<const double> product, std::span<const double> radiance) {
    Compared compared;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        if (!std::isfinite(radiance[i])) continue;
        compared.product.push_back(product[i]);
        compared.radiance.push_back(max(radiance[i], 0.0));
    }
    return compared;
}

std::vector<double> sums_of(std::span<const ChannelProduct> terms,
                            std::span<const PairFootprint> pairs) {
    std::vector<double> sums;
    for (const PairFootprint& pair : pairs) {
        double sum = 0.0;
        for (const ChannelProduct& term : terms) sum += product_at(term, pair);
        sums.push_back(sum);
    }
    return sums;
}

std::vector<ChannelProduct> stored_in_bytes(std::span<const ChannelProduct> terms) {
    std::vector<ChannelProduct> stored(terms.begin(), terms.end());
    for (ChannelProduct& term : stored) {
        term.t1.texel = byte_values(term.t1.texel);
        term.t2.texel = byte_values(term.t2.texel);
    }
    return stored;
}

/// |P - L| / |L|, each in units of its own largest element: barely touched texels of an
/// unregularised fit make products whose squares overflow.
double relative_rms_of(const Compared& c) {
    const Vector error = minus(c.product, c.radiance);
    const int error_exponent = binary_exponent(largest_magnitude(error));
    const int radiance_exponent = binary_exponent(largest_magnitude(c.radiance));
    const double ratio = norm(times_power_of_two(error, -error_exponent)) /
                         norm(times_power_of_two(c.radiance, -radiance_exponent));
    return times_power_of_two(ratio, error_exponent - radiance_exponent);
}

double log_rms_of(const Compared& c, double floor) {
    const double sum = ordered_sum(c.product.size(), [&](std::size_t i) {
        const double ratio = exact::log(max(c.product[i], floor) / max(c.radiance[i], floor));
        return ratio * ratio;
    });
    return std::sqrt(sum / static_cast<double>(c.product.size()));
}

std::vector<double> sorted_relative_errors(const Compared& c, double floor) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < c.product.size(); ++i) {
        if (c.radiance[i] < floor) continue;
        errors.push_back(std::fabs(c.product[i] - c.radiance[i]) / c.radiance[i]);
    }
    std::stable_sort(errors.begin(), errors.end());
    return errors;
}

double psnr_of(const Compared& c, double white) {
    const double sum = ordered_sum(c.product.size(), [&](std::size_t i) {
        const double shown = min(max(c.product[i] / white, 0.0), 1.0);
        const double difference = shown - min(c.radiance[i] / white, 1.0);
        return difference * difference;
    });
    const double mean = sum / static_cast<double>(c.product.size());
    return mean > 0.0 ? -10.0 * exact::log(mean) / exact::log(10.0)
                      : std::numeric_limits<double>::infinity();
}

/// The value that at least `percent` of a hundred do not exceed.
double nearest_rank(std::span<const double> sorted, std::size_t percent) {
    return sorted[(percent * sorted.size() + 99) / 100 - 1];
}

}  // namespace

ChannelProduct product_of(NormalisedChannel t1, NormalisedChannel t2) {
    const double scale = maximum_of(t1) * maximum_of(t2);
    return {std::move(t1), std::move(t2), {}, scale};
}

std::vector<PairFootprint> footprints_of(std::span<const SurfaceView> at, const MapShape& shape) {
    std::vector<PairFootprint> footprints;
    footprints.reserve(at.size());
    for (const SurfaceView& pair : at) {
        footprints.push_back({footprint_of(pi_1(pair), shape), footprint_of(pi_2(pair), shape),
                              dot(pair.n, pair.v)});
    }
    return footprints;
}

double product_at(const ChannelProduct& product, const PairFootprint& at) {
    const double scale = product.subtract ? -product.scale : product.scale;
    const double maps =
        scale * filtered(product.t1.texel, at.first) * filtered(product.t2.texel, at.second);
    return product.view.empty() ? maps : maps * view_value(product.view, at.cosine);
}

std::vector<double> byte_values(std::span<const double> texels) {
    std::vector<double> stored(texels.size());
    for (std::size_t j = 0; j < texels.size(); ++j) stored[j] = to_byte(texels[j]) / 255.0;
    return stored;
}

FitError fit_error(std::span<const double> product, std::span<const double> in_bytes,
                   std::span<const double> radiance, double white) {
    const Compared c = compare(product, radiance);
    const double sum = ordered_sum(c.radiance.size(), [&](std::size_t i) { return c.radiance[i]; });
    if (!(sum > 0.0)) return {};
    const double floor = floor_share * sum / static_cast<double>(c.radiance.size());
    const std::vector<double> errors = sorted_relative_errors(c, floor);
    return {.relative_rms = relative_rms_of(c),
            .byte_rms = relative_rms_of(compare(in_bytes, radiance)),
            .log_rms = log_rms_of(c, floor),
            .median = nearest_rank(errors, 50),
            .p95 = nearest_rank(errors, 95),
            .psnr = psnr_of(c, white)};
}

FitError fit_error(std::span<const ChannelProduct> terms, std::span<const PairFootprint> pairs,
                   std::span<const double> radiance, double white) {
    return fit_error(sums_of(terms, pairs), sums_of(stored_in_bytes(terms), pairs), radiance,
                     white);
}

std::vector<double> channel_of(std::span<const Rgb> radiance, int channel) {
    std::vector<double> values;
    values.reserve(radiance.size());
    for (const Rgb& rgb : radiance) values.push_back(rgb[channel]);
    return values;
}

}  // namespace twofold
