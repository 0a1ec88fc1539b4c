#include "factor/separable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "factor/factorize_check.hpp"
#include "factor/first_guess.hpp"
#include "factor/refine.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

constexpr double half_step = 0.5 / 255.0;

/// Pairs that may be clamped on the way.
constexpr double clamped_pairs = 1e-3;

/// The rows of the regulariser that are about one map.
SparseMatrix regulariser_of(const SparseMatrix& both, std::size_t first, std::size_t count) {
    RowBuilder builder;
    for (std::size_t i = 0; i < both.rows(); ++i) {
        const auto row = both.row(i);
        if (row[0].column < first || row[0].column >= first + count) continue;
        std::vector<MatrixEntry> entries(row.begin(), row.end());
        for (MatrixEntry& entry : entries) entry.column -= static_cast<std::uint32_t>(first);
        builder.add(entries);
    }
    return builder.build(count);
}

/// Radiance as it is fitted: from 0 to the cap; what is not finite as 0, and its weight too.
struct LinearRows {
    Vector values;
    Vector weight;
};

LinearRows linear_rows(std::span<const double> radiance, const FactorSettings& settings,
                       double white) {
    const double cap = settings.cap * white;
    LinearRows rows;
    for (const double value : radiance) {
        const bool finite = std::isfinite(value);
        const double lit = finite ? max(value, 0.0) : 0.0;
        rows.values.push_back(cap > 0.0 ? min(lit, cap) : lit);
        rows.weight.push_back(finite ? 1.0 : 0.0);
    }
    return rows;
}

struct ChannelResult {
    std::vector<ChannelProduct> parts;
    ChannelFit fit;
};

SolverReport report_of(const SignedSum& sum) {
    SolverReport report;
    report.status = sum.stationary ? SolverStatus::converged : SolverStatus::limit;
    report.iterations = static_cast<int>(sum.objective.size()) - 1;
    report.best_iteration = report.iterations;
    for (const double rms : sum.objective) report.history.push_back(rms / sum.objective[0]);
    report.relative_residual = report.history.back();
    return report;
}

void fit_svd(ChannelResult& result, const Sides& sides, const LinearRows& rows,
             const FactorSettings& settings, int threads) {
    const SignedSum sum =
        fit_signed_sum({sides.first, sides.second, rows.values, rows.weight},
                       static_cast<std::size_t>(settings.terms), settings.rounds, threads);
    result.parts = positive_parts(sum, sides.shapes);
    result.fit.solver = report_of(sum);
}

void fit_nd(ChannelResult& result, const Sides& sides, const LinearRows& rows,
            const FactorSettings& settings, int threads) {
    const MapShape& shape = sides.log.shape;
    NormalisedDecomposition d = decompose(sides.first.footprint, sides.second.footprint,
                                          rows.values, settings.row_norm, threads);
    std::size_t untouched = 0;
    for (const auto& [side, map] : {std::pair{&sides.first, &d.first}, {&sides.second, &d.second}})
        untouched += fill_untouched(*map, side->footprint.multiply_transpose(rows.weight, threads),
                                    0, shape, settings.fill_power, threads);
    result.parts = {product_of(normalised_values(std::move(d.first), shape),
                               normalised_values(std::move(d.second), shape))};
    result.fit.untouched_share =
        static_cast<double>(untouched) / static_cast<double>(2 * shape.texels());
}

ChannelResult factor_channel(const Sides& sides, std::span<const double> radiance,
                             const FactorSettings& settings, double white, int threads) {
    const ChannelRows counted =
        channel_rows(sides.log, Vector(radiance.begin(), radiance.end()), settings, white, threads);
    ChannelResult result;
    result.fit.counts = counted.treated;
    const std::size_t parts =
        settings.model == Model::nd ? 1 : 4 * static_cast<std::size_t>(settings.terms);
    if (counted.black()) {
        const NormalisedChannel first{std::vector<double>(sides.first.footprint.columns(), 0.0)};
        result.parts.assign(parts, product_of(first, black_channel(sides.shapes.second)));
        for (std::size_t k = 0; k < parts; ++k) result.parts[k].subtract = k % 4 >= 2;
        return result;
    }
    const LinearRows rows = linear_rows(radiance, settings, white);
    if (settings.model == Model::nd)
        fit_nd(result, sides, rows, settings, threads);
    else
        fit_svd(result, sides, rows, settings, threads);
    return result;
}

/// One sign of a vector, as values >= 0.
NormalisedChannel signed_part(const Vector& values, double sign, const MapShape& shape) {
    std::vector<double> part;
    for (const double value : values) part.push_back(max(sign * value, 0.0));
    return normalised_values(std::move(part), shape);
}

double clamp01(double x) { return min(max(x, 0.0), 1.0); }

/// The largest share of clamped pairs of the channels.
double worst_clamped_share(const std::vector<std::array<ChannelProduct, 3>>& parts,
                           std::span<const PairFootprint> pairs, double white, int doubling) {
    double worst = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<ChannelProduct> channel;
        for (const auto& part : parts) channel.push_back(part[c]);
        worst = max(worst, clamped_share(channel, pairs, white, doubling));
    }
    return worst;
}

/// More room than two doublings costs more steps than clamping does.
constexpr int most_headroom = 2;

}  // namespace

Sides sides_of(const LightingSamples& fit, FactorSettings settings, int threads) {
    settings.view_knots = 0;
    LogRows log = log_rows(fit.at, settings, threads);
    ProductRows rows = product_rows(log);
    const std::size_t texels = log.shape.texels();
    const TermShapes shapes{log.shape, log.shape};
    return {std::move(log),
            {std::move(rows.factors[0]), regulariser_of(rows.regulariser, 0, texels)},
            {std::move(rows.factors[1]), regulariser_of(rows.regulariser, texels, texels)},
            shapes};
}

NormalisedDecomposition decompose(const SparseMatrix& first, const SparseMatrix& second,
                                  const Vector& values, RowNorm norm, int threads) {
    const auto divided_by_touch = [&](const SparseMatrix& side, Vector sum) {
        const Vector touch = side.multiply_transpose(Vector(side.rows(), 1.0), threads);
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] = touch[k] > 0.0 ? sum[k] / touch[k] : 0.0;
        return sum;
    };
    NormalisedDecomposition d;
    if (norm == RowNorm::max) {
        d.first.assign(first.columns(), 0.0);
        for (std::size_t i = 0; i < values.size(); ++i)
            for (const MatrixEntry& entry : first.row(i))
                if (entry.value > 0.0)
                    d.first[entry.column] = max(d.first[entry.column], values[i]);
    } else {
        Vector powers = values;
        for (double& value : powers) value = norm == RowNorm::two ? value * value : value;
        d.first = divided_by_touch(first, first.multiply_transpose(powers, threads));
        for (double& value : d.first) value = norm == RowNorm::two ? std::sqrt(value) : value;
    }
    Vector ratio = first.multiply(d.first, threads);
    for (std::size_t i = 0; i < ratio.size(); ++i)
        ratio[i] = ratio[i] > 0.0 ? values[i] / ratio[i] : 0.0;
    d.second = divided_by_touch(second, second.multiply_transpose(ratio, threads));
    return d;
}

std::vector<ChannelProduct> positive_parts(const SignedSum& sum, const TermShapes& shapes) {
    std::vector<ChannelProduct> parts;
    for (std::size_t j = 0; j < sum.first.size(); ++j)
        for (const auto& [u, v] : {std::pair{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}}) {
            parts.push_back(product_of(signed_part(sum.first[j], u, shapes.first),
                                       signed_part(sum.second[j], v, shapes.second)));
            parts.back().subtract = u != v;
        }
    return parts;
}

std::vector<std::array<ChannelProduct, 3>> drawn_parts(
    std::vector<std::array<ChannelProduct, 3>> parts, double white) {
    std::vector<std::array<ChannelProduct, 3>> drawn;
    for (const bool subtract : {false, true})
        for (std::array<ChannelProduct, 3>& part : parts) {
            if (part[0].subtract != subtract) continue;
            const double largest = std::max({part[0].scale, part[1].scale, part[2].scale});
            if (drawn.empty() || largest >= half_step * white) drawn.push_back(std::move(part));
        }
    return drawn;
}

double clamped_share(std::span<const ChannelProduct> terms, std::span<const PairFootprint> pairs,
                     double white, int doubling) {
    const double room = static_cast<double>(1 << doubling);
    std::size_t clamped = 0;
    for (const PairFootprint& pair : pairs) {
        double shown = 0.0, sum = 0.0;
        for (const ChannelProduct& term : terms) {
            const double product = product_at(term, pair) / white;
            shown = min(max(shown + product, 0.0), room);
            sum += product;
        }
        clamped += std::fabs(min(shown, 1.0) - clamp01(sum)) > half_step ? 1U : 0U;
    }
    return static_cast<double>(clamped) / static_cast<double>(pairs.size());
}

int headroom(const std::vector<std::array<ChannelProduct, 3>>& parts,
             std::span<const PairFootprint> pairs, double white) {
    int doubling = 0;
    while (doubling < most_headroom &&
           worst_clamped_share(parts, pairs, white, doubling) > clamped_pairs)
        ++doubling;
    return doubling;
}

FactoredLighting fitted_separably(const Sides& sides, const std::vector<Rgb>& radiance,
                                  const JudgedPairs& judged, const FactorSettings& settings,
                                  double white, int threads) {
    std::array<ChannelResult, 3> channels;
    parallel_for(3, threads, [&](std::size_t c) {
        channels[c] = factor_channel(sides, channel_of(radiance, static_cast<int>(c)), settings,
                                     white, threads);
    });
    std::vector<std::array<ChannelProduct, 3>> parts;
    for (std::size_t k = 0; k < channels[0].parts.size(); ++k)
        parts.push_back({channels[0].parts[k], channels[1].parts[k], channels[2].parts[k]});
    parts = drawn_parts(std::move(parts), white);
    const int doubling = headroom(parts, judged.pairs, white);
    return assembled(std::move(parts), {channels[0].fit, channels[1].fit, channels[2].fit}, judged,
                     sides.shapes, settings, white, doubling);
}

FactoredLighting factor_separable(const MaterialSamples& samples, const FactorSettings& settings,
                                  double white, int threads) {
    check_arguments(samples.fit, samples.held_out, settings, white);
    const LightingSamples& judged = samples.held_out.at.empty() ? samples.fit : samples.held_out;
    return fitted_separably(sides_of(samples.fit, settings, threads), samples.fit.radiance,
                            {footprints_of(judged.at, shape_of(settings)), judged.radiance},
                            settings, white, threads);
}

}  // namespace twofold
