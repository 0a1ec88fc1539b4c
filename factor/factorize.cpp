#include "factor/factorize.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "factor/first_guess.hpp"
#include "factor/lsmr.hpp"
#include "factor/qmr.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// Fewer samples an unknown than this leave the fit at the mercy of single samples (docs/method.md,
/// section 8).
constexpr std::size_t wanted_samples_per_unknown = 10;

/// One channel on its way from samples to texels.
struct ChannelResult {
    NormalisedChannel t1;
    NormalisedChannel t2;
    double max1 = 0.0;
    double max2 = 0.0;
    ChannelFit fit;
};

void require(bool condition, const std::string& text) {
    if (!condition) throw Error(ExitCode::failure, "factor: " + text);
}

void check_samples(const LightingSamples& samples, const char* name) {
    require(samples.at.size() == samples.radiance.size(),
            fmt::format("{} has {} pairs but {} radiances", name, samples.at.size(),
                        samples.radiance.size()));
}

void check(const LightingSamples& fit, const LightingSamples& held_out, const FactorSettings& s,
           double white) {
    require(!fit.at.empty(), "no samples");
    check_samples(fit, "fit");
    check_samples(held_out, "held_out");
    require(s.map_size >= 2 && s.map_size <= 2048, fmt::format("map_size is {}", s.map_size));
    require(s.guard > 0.0 && s.guard <= 1.0, fmt::format("guard is {}", s.guard));
    require(s.floor > 0.0 && std::isfinite(s.floor), fmt::format("floor is {}", s.floor));
    require(s.cap >= 0.0, fmt::format("cap is {}", s.cap));
    require(s.smoothness >= 0.0 && std::isfinite(s.smoothness),
            fmt::format("smoothness is {}", s.smoothness));
    require(s.seam >= 0.0 && std::isfinite(s.seam), fmt::format("seam is {}", s.seam));
    require(std::isfinite(s.row_weight), fmt::format("row_weight is {}", s.row_weight));
    require(s.tolerance >= 0.0, fmt::format("tolerance is {}", s.tolerance));
    require(s.iteration_limit > 0, fmt::format("iteration_limit is {}", s.iteration_limit));
    require(white >= 0.0 && std::isfinite(white), fmt::format("white is {}", white));
}

Solution solve(const WeightedSystem& system, const Vector& start, const FactorSettings& settings) {
    const StopRule rule{.tolerance = settings.tolerance,
                        .iteration_limit = settings.iteration_limit};
    const Vector b = system.right_side();
    const Vector y = system.scaled_unknowns(start);
    Solution solution =
        settings.solver == Solver::qmr
            ? solve_qmr(system.normal_equations(), system.apply_transpose(b), y, rule)
            : solve_lsmr(system.least_squares(), b, y, rule);
    solution.x = balanced(system.unknowns(solution.x));
    return solution;
}

ChannelResult factor_channel(const LogRows& left, std::span<const double> radiance,
                             const FactorSettings& settings, double white, const char* name,
                             int threads) {
    const ChannelRows right = channel_rows(left, radiance, settings, white);
    ChannelResult result;
    result.fit.counts = right.treated;
    if (right.black()) {
        result.t1 = result.t2 = black_channel(left.shape);
        return result;
    }
    const FirstGuess guess = first_guess(left, right, settings.fill_power, threads);
    const WeightedSystem system(left, right, settings.column_scaling, threads);
    Solution solution = solve(system, guess.x, settings);

    const std::span<const double> x = solution.x;
    result.t1 = normalised(x.first(left.shape.texels()), left.shape, fmt::format("t1 {}", name));
    result.t2 = normalised(x.last(left.shape.texels()), left.shape, fmt::format("t2 {}", name));
    result.max1 = exact::exp(result.t1.log_maximum);
    result.max2 = exact::exp(result.t2.log_maximum);
    result.fit.solver = std::move(solution.report);
    result.fit.untouched_share =
        static_cast<double>(guess.untouched) / static_cast<double>(x.size());
    return result;
}

void put_error(ChannelFit& fit, const FitError& error) {
    fit.relative_rms = error.relative_rms;
    fit.byte_rms = error.byte_rms;
    fit.log_rms = error.log_rms;
    fit.median = error.median;
    fit.p95 = error.p95;
}

/// What the samples and the settings let one expect, before any channel is looked at.
std::vector<std::string> sample_warnings(const LightingSamples& fit,
                                         const FactorSettings& settings) {
    const MapShape shape{settings.map_size, settings.guard};
    const std::size_t unknowns = 2 * shape.texels();
    if (fit.at.size() >= wanted_samples_per_unknown * unknowns) return {};
    return {fmt::format("{} samples for {} unknowns: fewer than {} an unknown", fit.at.size(),
                        unknowns, wanted_samples_per_unknown)};
}

/// The factors are of no use in 8 bits: a few texels own the maximum and the rest is stored in too
/// few levels, or as 0.
bool bytes_are_too_few(const ChannelFit& fit) {
    const bool much_worse =
        fit.byte_rms > 1.3 * fit.relative_rms && fit.byte_rms > fit.relative_rms + 0.02;
    return much_worse || !(fit.relative_rms < 0.9);
}

std::vector<std::string> channel_warnings(const FactoredLighting& result,
                                          const FactorSettings& settings, std::size_t channel) {
    const ChannelFit& fit = result.fit[channel];
    const char* name = channel_name(channel);
    std::vector<std::string> warnings;
    if (fit.solver.status != SolverStatus::converged) {
        warnings.push_back(fmt::format("{}: the solver ended with {} after {} iterations", name,
                                       name_of(fit.solver.status), fit.solver.iterations));
    }
    if (settings.smoothness == 0.0 && fit.untouched_share > 0.0) {
        warnings.push_back(
            fmt::format("{}: {:.1f} % of the texels are touched by no sample and keep their first "
                        "guess (smoothness is 0)",
                        name, 100.0 * fit.untouched_share));
    }
    if (bytes_are_too_few(fit)) {
        const ByteLoss& first = result.t1.loss[channel];
        const ByteLoss& second = result.t2.loss[channel];
        warnings.push_back(fmt::format(
            "{}: relative error {:.3g}, in 8 bits {:.3g}; {:.1f} % of t1 and {:.1f} % of t2 are "
            "stored as 0, {} and {} levels are left below the maximum",
            name, fit.relative_rms, fit.byte_rms, 100.0 * first.zero_share,
            100.0 * second.zero_share, first.levels, second.levels));
    }
    return warnings;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

FactoredLighting assemble(std::array<ChannelResult, 3>& channels, const MapShape& shape,
                          double white) {
    FactoredLighting result;
    result.t1 = make_factor_map({channels[0].t1, channels[1].t1, channels[2].t1}, shape, "t1");
    result.t2 = make_factor_map({channels[0].t2, channels[1].t2, channels[2].t2}, shape, "t2");
    result.white = white;
    for (int i = 0; i < 3; ++i) {
        ChannelResult& channel = channels[static_cast<std::size_t>(i)];
        result.max1[i] = channel.max1;
        result.max2[i] = channel.max2;
        // A black channel has no constant, whatever white is.
        result.c[i] = channel.max1 > 0.0 ? channel.max1 * channel.max2 / white : 0.0;
        result.fit[static_cast<std::size_t>(i)] = std::move(channel.fit);
    }
    const ScaleSplit split = split_scale(result.c);
    result.scale_color = split.color;
    result.combiner_scale = split.combiner_scale;
    result.doubling_passes = split.doubling_passes;
    result.warnings = split.warnings;
    return result;
}

}  // namespace

FactoredLighting factorize(const LightingSamples& fit, const LightingSamples& held_out,
                           const FactorSettings& settings, double white, int threads) {
    check(fit, held_out, settings, white);
    const LogRows left = log_rows(fit.at, settings);
    const LightingSamples& judged = held_out.at.empty() ? fit : held_out;
    const std::vector<PairFootprint> pairs = footprints_of(judged.at, left.shape);

    std::array<ChannelResult, 3> channels;
    parallel_for(3, threads, [&](std::size_t c) {
        const int channel = static_cast<int>(c);
        ChannelResult& result = channels[c];
        result = factor_channel(left, channel_of(fit.radiance, channel), settings, white,
                                channel_name(c), threads);
        put_error(result.fit, fit_error(result.t1, result.t2, result.max1 * result.max2, pairs,
                                        channel_of(judged.radiance, channel)));
    });

    FactoredLighting result = assemble(channels, left.shape, white);
    append(result.warnings, sample_warnings(fit, settings));
    for (std::size_t c = 0; c < 3; ++c)
        append(result.warnings, channel_warnings(result, settings, c));
    return result;
}

}  // namespace twofold
