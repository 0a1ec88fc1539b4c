#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "factor/system.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

/// From a channel's radiance to right side and weights.
namespace twofold {

namespace {

constexpr std::size_t samples_per_task = 8192;

/// Radiance after the cap, negative values as 0.
double lowered(double radiance, double cap) { return min(max(radiance, 0.0), cap); }

double mean_of_finite(std::span<const double> radiance, double cap, std::size_t finite) {
    const double sum = ordered_sum(radiance.size(), [&](std::size_t i) {
        return std::isfinite(radiance[i]) ? lowered(radiance[i], cap) : 0.0;
    });
    return sum / static_cast<double>(finite);
}

void count_sample(TreatedSamples& treated, double radiance, double floor, double cap) {
    if (!std::isfinite(radiance)) {
        ++treated.non_finite;
        return;
    }
    ++treated.used;
    if (radiance < 0.0) {
        ++treated.negative;
    } else if (radiance == 0.0) {
        ++treated.zero;
    } else if (radiance < floor) {
        ++treated.floored;
    } else if (radiance > cap) {
        ++treated.capped;
    }
}

std::size_t count_finite(std::span<const double> radiance) {
    std::size_t finite = 0;
    for (const double value : radiance) finite += std::isfinite(value) ? 1U : 0U;
    return finite;
}

/// Turns the radiance of a sample, which stands in its right side, into right side and weight.
void treat(ChannelRows& channel, std::size_t i, double floor, double cap, double row_weight) {
    const double radiance = std::exchange(channel.right_side[i], 0.0);
    if (!std::isfinite(radiance)) {
        channel.weight[i] = 0.0;
    } else if (!channel.black()) {
        const double treated = max(lowered(radiance, cap), floor);
        channel.right_side[i] = exact::log(treated);
        channel.weight[i] = exact::pow(treated / channel.mean, row_weight);
    }
}

TreatedSamples treat_all(ChannelRows& channel, std::size_t samples, double floor, double cap,
                         double row_weight, int threads) {
    std::vector<TreatedSamples> counts((samples + samples_per_task - 1) / samples_per_task);
    parallel_for(counts.size(), threads, [&](std::size_t task) {
        TreatedSamples count;
        const std::size_t end = std::min((task + 1) * samples_per_task, samples);
        for (std::size_t i = task * samples_per_task; i < end; ++i) {
            count_sample(count, channel.right_side[i], floor, cap);
            treat(channel, i, floor, cap, row_weight);
        }
        counts[task] = count;
    });
    TreatedSamples all;
    for (const TreatedSamples& count : counts) all += count;
    return all;
}

}  // namespace

TreatedSamples& TreatedSamples::operator+=(const TreatedSamples& b) {
    used += b.used;
    non_finite += b.non_finite;
    negative += b.negative;
    zero += b.zero;
    floored += b.floored;
    capped += b.capped;
    return *this;
}

ChannelRows channel_rows(const LogRows& rows, Vector radiance, const FactorSettings& settings,
                         double white, int threads) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double cap = settings.cap * white > 0.0 ? settings.cap * white : infinity;
    const std::size_t samples = radiance.size(), finite = count_finite(radiance);
    if (finite == 0) throw Error(ExitCode::failure, "factor: no sample is finite");

    const double mean = mean_of_finite(radiance, cap, finite);
    ChannelRows channel{std::move(radiance), Vector(rows.matrix.rows(), 1.0), {}, mean};
    channel.right_side.resize(rows.matrix.rows(), 0.0);
    channel.treated =
        treat_all(channel, samples, settings.floor * mean, cap, settings.row_weight, threads);
    return channel;
}

}  // namespace twofold
