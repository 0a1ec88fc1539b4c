#include "factor/factorize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "factor/factorize_check.hpp"
#include "factor/first_guess.hpp"
#include "factor/refine.hpp"
#include "factor/solve_channels.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// Fewer samples an unknown than this leave the fit at the mercy of single samples (docs/method.md,
/// section 8).
constexpr std::size_t wanted_samples_per_unknown = 10;

/// One channel on its way from samples to texels: its products, and how they were found.
struct ChannelResult {
    std::vector<ChannelProduct> terms;
    ChannelFit fit;
};

/// g from its logarithms, divided by its largest value, whose logarithm is added to `log_maximum`.
std::vector<double> view_of(std::span<const double> logs, double& log_maximum) {
    if (logs.empty()) return {};
    const double largest = *std::max_element(logs.begin(), logs.end());
    log_maximum += largest;
    std::vector<double> view;
    for (const double value : logs) view.push_back(exact::exp(value - largest));
    return view;
}

ChannelProduct product_of(std::span<const double> x, const MapShape& shape, const char* channel) {
    ChannelProduct product;
    const std::size_t texels = shape.texels();
    product.t1 = normalised(x.first(texels), shape, fmt::format("t1 {}", channel));
    product.t2 = normalised(x.subspan(texels, texels), shape, fmt::format("t2 {}", channel));
    double log_view = 0.0;
    product.view = view_of(x.subspan(2 * texels), log_view);
    product.scale = exact::exp(product.t1.log_maximum) * exact::exp(product.t2.log_maximum);
    if (!product.view.empty()) product.scale *= exact::exp(log_view);
    return product;
}

ChannelProduct black_product(const MapShape& shape) {
    return {black_channel(shape), black_channel(shape), {}, 0.0};
}

/// The left sides: of the log fit and, if there is a refinement, of the fit to filtered texels.
struct LeftSides {
    LogRows log;
    std::optional<ProductRows> product;
};

bool refines(const FactorSettings& settings) {
    return settings.refinement > 0 || settings.terms > 1;
}

/// The logarithms of all terms, from those of the first.
Vector refined_terms(const LeftSides& left, const ChannelRows& right,
                     const FactorSettings& settings, Vector x, int threads) {
    if (!left.product) return x;
    if (settings.terms > 1)
        x = divided_terms(x, static_cast<std::size_t>(settings.terms), left.log.shape);
    return refine(*left.product,
                  product_target(right, left.log.samples, settings.refinement_weight), std::move(x),
                  settings.refinement, threads)
        .x;
}

/// A channel before and after the solve of its logarithms. A black channel has no system, which
/// refers to the right side beside it.
struct Channel {
    ChannelRows right;
    FirstGuess guess;
    std::optional<WeightedSystem> system;
    Solution solution;
};

/// Whether anything looks at the right side once the system stands.
bool needs_right_side(const FactorSettings& settings) {
    return settings.solver != Solver::qmr || refines(settings);
}

/// The gauge of a channel: that of another whose rows of positive weight are the same, as they
/// nearly always are.
Gauge gauge_of(const LogRows& left, const ChannelRows& right, const Channel* other) {
    const auto alike = [](double a, double b) { return (a > 0.0) == (b > 0.0); };
    if (other != nullptr &&
        std::equal(right.weight.begin(), right.weight.end(), other->right.weight.begin(), alike))
        return other->system->gauge();
    return Gauge(left.matrix, right.weight, left.starts());
}

/// One channel after another, so that only one has all of its rows at a time; the threads share
/// those. @param other a channel that has a system, if there is one
void prepare(Channel& channel, const Channel* other, const LogRows& left, Vector radiance,
             const FactorSettings& settings, double white, int threads) {
    channel.right = channel_rows(left, std::move(radiance), settings, white, threads);
    if (channel.right.black()) return;
    channel.guess = first_guess(left, channel.right, settings.fill_power, threads);
    channel.system.emplace(left, channel.right, gauge_of(left, channel.right, other), settings,
                           threads);
    if (!needs_right_side(settings)) channel.right.right_side = Vector();
}

void solve(std::array<Channel, 3>& channels, const FactorSettings& settings, int threads) {
    std::vector<Channel*> lit;
    std::vector<const WeightedSystem*> systems;
    std::vector<Vector> start;
    for (Channel& channel : channels) {
        if (!channel.system) continue;
        lit.push_back(&channel);
        systems.push_back(&*channel.system);
        start.push_back(channel.system->scaled_unknowns(channel.guess.x));
    }
    auto solutions =
        solve_channels(settings.solver, systems, start, stop_rule_of(settings), threads);
    for (std::size_t k = 0; k < lit.size(); ++k) {
        const WeightedSystem& system = *systems[k];
        solutions[k].x = system.gauge().balanced(system.unknowns(solutions[k].x));
        lit[k]->solution = std::move(solutions[k]);
    }
}

ChannelResult finished(const LeftSides& left, Channel& channel, const FactorSettings& settings,
                       const char* name, int threads) {
    const MapShape& shape = left.log.shape;
    const auto terms = static_cast<std::size_t>(settings.terms);
    ChannelResult result;
    result.fit.counts = channel.right.treated;
    if (!channel.system) {
        result.terms.assign(terms, black_product(shape));
        return result;
    }
    const std::size_t unknowns = channel.solution.x.size();
    const Vector x =
        refined_terms(left, channel.right, settings, std::move(channel.solution.x), threads);
    for (std::size_t k = 0; k < terms; ++k)
        result.terms.push_back(
            product_of(std::span(x).subspan(k * unknowns, unknowns), shape, name));
    result.fit.components = channel.system->gauge().components();
    result.fit.solver = std::move(channel.solution.report);
    result.fit.untouched_share =
        static_cast<double>(channel.guess.untouched) / static_cast<double>(2 * shape.texels());
    return result;
}

/// What the samples and the settings let one expect, before any channel is looked at.
std::vector<std::string> sample_warnings(std::size_t samples, const FactorSettings& settings) {
    const MapShape shape = shape_of(settings);
    const std::size_t unknowns = 2 * shape.texels();
    if (samples >= wanted_samples_per_unknown * unknowns) return {};
    return {fmt::format("{} samples for {} unknowns: fewer than {} an unknown", samples, unknowns,
                        wanted_samples_per_unknown)};
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
    if (fit.components > 1) {
        warnings.push_back(
            fmt::format("{}: the samples fall into {} components, whose scales against each other "
                        "are arbitrary",
                        name, fit.components));
    }
    if (settings.smoothness == 0.0 && fit.untouched_share > 0.0) {
        warnings.push_back(
            fmt::format("{}: {:.1f} % of the texels are touched by no sample and keep their first "
                        "guess (smoothness is 0)",
                        name, 100.0 * fit.untouched_share));
    }
    if (bytes_are_too_few(fit)) {
        const ByteLoss& first = result.terms[0].t1.loss[channel];
        const ByteLoss& second = result.terms[0].t2.loss[channel];
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

}  // namespace

FactoredLighting factorize(const LightingSamples& fit, const LightingSamples& held_out,
                           const FactorSettings& settings, double white, int threads) {
    check_arguments(fit, held_out, settings, white);
    FitSamples samples(settings, fit.at.size());
    samples.add(fit, threads);
    return factorize(std::move(samples), held_out.at.empty() ? fit : held_out, white, threads);
}

FactoredLighting factorize(FitSamples fit, const LightingSamples& judged, double white,
                           int threads) {
    check_white(white);
    check_samples(judged, "held_out");
    const FactorSettings settings = fit.settings();
    auto [log, radiance] = std::move(fit).parts(threads);
    LeftSides left{std::move(log), std::nullopt};
    if (refines(settings)) left.product = product_rows(left.log);

    std::array<Channel, 3> solved;
    const Channel* other = nullptr;
    for (std::size_t c = 0; c < 3; ++c) {
        prepare(solved[c], other, left.log, std::move(radiance[c]), settings, white, threads);
        if (solved[c].system) other = &solved[c];
    }
    solve(solved, settings, threads);
    std::array<ChannelResult, 3> channels;
    parallel_for(3, threads, [&](std::size_t c) {
        channels[c] = finished(left, solved[c], settings, channel_name(c), threads);
    });
    std::vector<std::array<ChannelProduct, 3>> terms;
    for (std::size_t k = 0; k < static_cast<std::size_t>(settings.terms); ++k)
        terms.push_back({channels[0].terms[k], channels[1].terms[k], channels[2].terms[k]});
    FactoredLighting result =
        assembled(std::move(terms), {channels[0].fit, channels[1].fit, channels[2].fit}, judged,
                  settings, white);
    append(result.warnings, sample_warnings(left.log.samples, settings));
    for (std::size_t c = 0; c < 3; ++c)
        append(result.warnings, channel_warnings(result, settings, c));
    return result;
}

}  // namespace twofold
