#include "factor/product_brdf.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "factor/lsmr.hpp"
#include "factor/sparse_matrix.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {
namespace {

constexpr std::size_t p_nodes = 33, q_nodes = 65, unknowns = p_nodes + q_nodes;
constexpr double floor_of_median = 1e-2;
constexpr double row_weight_power = 0.25;
constexpr double unsupported_share = 0.4;
constexpr double curvature_weight = 1.0;
constexpr double slope_weight = 0.01;  // keeps what no sample touches level
constexpr StopRule stop{.tolerance = 1e-8, .iteration_limit = 400};

using Row = std::array<MatrixEntry, 6>;

/// A sample's six weights: p at wi and wo, q at the half vector.
void put_node(Row& row, std::size_t first, double coordinate, std::size_t start,
              std::size_t nodes) {
    const double position = coordinate * static_cast<double>(nodes - 1);
    const std::size_t i = to_fixed(position, std::size_t{0}, nodes - 2);
    const double t = position - static_cast<double>(i);
    row[first] = {static_cast<std::uint32_t>(start + i), 1.0 - t};
    row[first + 1] = {static_cast<std::uint32_t>(start + i + 1), t};
}

Row row_of(const BrdfSample& s) {
    const Vec3 sum = s.wi + s.wo;
    Row row;
    put_node(row, 0, paraboloid_radius(s.wi.z), 0, p_nodes);
    put_node(row, 2, paraboloid_radius(s.wo.z), 0, p_nodes);
    put_node(row, 4, half_coordinate(s.wi.z, s.wo.z, dot(sum, sum)), p_nodes, q_nodes);
    return row;
}

/// A channel on its way: the samples that count, their values after the floor.
struct Treated {
    std::vector<std::size_t> sample;
    std::vector<double> value;
    double median = 0.0;
};

double median_of_positive(std::span<const BrdfSample> samples, int c) {
    std::vector<double> positive;
    for (const BrdfSample& s : samples)
        if (s.f[c] > 0.0) positive.push_back(s.f[c]);
    std::stable_sort(positive.begin(), positive.end());
    return positive.empty() ? 0.0 : positive[positive.size() / 2];
}

void count(ProductFit& fit, std::span<const BrdfSample> samples, int c, double floor) {
    for (const BrdfSample& s : samples) {
        const double f = s.f[c];
        if (!std::isfinite(f))
            ++fit.unmeasured;
        else if (f <= 0.0)
            ++fit.zero;
        else if (f < floor)
            ++fit.floored;
    }
    const std::size_t measured = samples.size() - fit.unmeasured;
    fit.partly_unsupported =
        static_cast<double>(fit.zero) >= unsupported_share * static_cast<double>(measured);
    fit.used = measured - (fit.partly_unsupported ? fit.zero : 0);
}

Treated treat(std::span<const BrdfSample> samples, int c, ProductFit& fit) {
    Treated treated;
    treated.median = median_of_positive(samples, c);
    const double floor = floor_of_median * treated.median;
    count(fit, samples, c, floor);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double f = samples[i].f[c];
        if (!std::isfinite(f) || (fit.partly_unsupported && f <= 0.0)) continue;
        treated.sample.push_back(i);
        treated.value.push_back(max(f, floor));
    }
    return treated;
}

/// scale x'' = 0 inside a profile, and a hundredth of it for x'.
void add_smoothness(RowBuilder& builder, std::size_t start, std::size_t nodes, double scale) {
    const auto column = [&](std::size_t i) { return static_cast<std::uint32_t>(start + i); };
    for (std::size_t i = 0; i + 1 < nodes; ++i) {
        const double slope = slope_weight * scale;
        builder.add(std::array{MatrixEntry{column(i), -slope}, MatrixEntry{column(i + 1), slope}});
        if (i == 0) continue;
        const double bend = curvature_weight * scale;
        builder.add(std::array{MatrixEntry{column(i - 1), bend},
                               MatrixEntry{column(i), -2.0 * bend},
                               MatrixEntry{column(i + 1), bend}});
    }
}

/// log x of the nodes, by LSMR on columns of unit length.
Vector solve(const SparseMatrix& matrix, Vector b, ProductFit& fit) {
    b.resize(matrix.rows(), 0.0);
    Vector scale = matrix.column_norms(Vector(matrix.rows(), 1.0), 1);
    for (double& s : scale) s = s > 0.0 ? s : 1.0;
    const auto unscaled = [&](Vector x) {
        for (std::size_t j = 0; j < x.size(); ++j) x[j] /= scale[j];
        return x;
    };
    const RectangularOperator a{
        [&](const Vector& x) { return matrix.multiply(unscaled(x), 1); },
        [&](const Vector& y) { return unscaled(matrix.multiply_transpose(y, 1)); }};
    Solution solution = solve_lsmr(a, b, Vector(unknowns, 0.0), stop);
    fit.solver = std::move(solution.report);
    return unscaled(std::move(solution.x));
}

/// All nodes of p, and those of q to which samples above 0 give at least half of the weight.
std::vector<bool> supported(std::span<const Row> rows, std::span<const BrdfSample> samples, int c) {
    std::vector<double> balance(unknowns, 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const MatrixEntry& entry : std::span(rows[i]).last(2))
            if (std::isfinite(samples[i].f[c]))
                balance[entry.column] += samples[i].f[c] > 0.0 ? entry.value : -entry.value;
    std::vector<bool> keep;
    for (const double b : balance) keep.push_back(b >= 0.0);
    return keep;
}

Vector fit_logs(std::span<const Row> rows, const Treated& treated, ProductFit& fit) {
    RowBuilder builder;
    Vector b;
    for (std::size_t k = 0; k < treated.sample.size(); ++k) {
        const double weight = exact::pow(treated.value[k] / treated.median, row_weight_power);
        Row row = rows[treated.sample[k]];
        for (MatrixEntry& entry : row) entry.value *= weight;
        builder.add(row);
        b.push_back(weight * exact::log(treated.value[k]));
    }
    const double scale =
        std::sqrt(static_cast<double>(treated.sample.size()) / static_cast<double>(unknowns));
    add_smoothness(builder, 0, p_nodes, scale);
    add_smoothness(builder, p_nodes, q_nodes, scale);
    return solve(builder.build(unknowns), std::move(b), fit);
}

void put_channel(ProductBrdf& brdf, std::size_t c, const Vector& x, const std::vector<bool>& keep) {
    const auto largest = [&](std::size_t first, std::size_t end) {
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t j = first; j < end; ++j)
            if (keep[j]) most = max(most, x[j]);
        return most;
    };
    const double p = largest(0, p_nodes), q = largest(p_nodes, unknowns);
    for (std::size_t j = 0; j < unknowns; ++j) {
        const double value = keep[j] ? exact::exp(x[j] - (j < p_nodes ? p : q)) : 0.0;
        Profile& profile = j < p_nodes ? brdf.p : brdf.q;
        profile.nodes[j < p_nodes ? j : j - p_nodes][c] = static_cast<float>(value);
    }
    brdf.alpha[c] = static_cast<float>(exact::exp(p + q + p));
}

/// Fills in relative_rms and log_rms of a channel.
void judge(ProductFit& fit, const ProductBrdf& brdf, std::span<const BrdfSample> samples,
           const Treated& treated, int c) {
    std::vector<double> error2, data2, log2;
    for (std::size_t k = 0; k < treated.sample.size(); ++k) {
        const BrdfSample& s = samples[treated.sample[k]];
        const Vec3 sum = s.wi + s.wo;
        const double f = product(brdf, view_part(brdf, s.wo.z), paraboloid_radius(s.wi.z),
                                 half_coordinate(s.wi.z, s.wo.z, dot(sum, sum)))[c];
        const double cosines = s.wi.z * s.wo.z;
        const double error = (f - s.f[c]) * cosines, data = s.f[c] * cosines;
        const double log_error =
            exact::log(max(f, floor_of_median * treated.median) / treated.value[k]);
        error2.push_back(error * error);
        data2.push_back(data * data);
        log2.push_back(log_error * log_error);
    }
    const auto total = [](const std::vector<double>& terms) {
        return ordered_sum(terms.size(), [&](std::size_t i) { return terms[i]; });
    };
    fit.relative_rms = std::sqrt(total(error2) / total(data2));
    fit.log_rms = std::sqrt(total(log2) / static_cast<double>(log2.size()));
}

}  // namespace

FactoredBrdf factor_brdf(std::span<const BrdfSample> samples, int threads) {
    std::vector<Row> rows;
    for (const BrdfSample& s : samples) rows.push_back(row_of(s));
    FactoredBrdf result;
    result.brdf.p.nodes.resize(p_nodes);
    result.brdf.q.nodes.resize(q_nodes);
    std::array<Treated, 3> treated;
    parallel_for(3, threads, [&](std::size_t c) {
        const int channel = static_cast<int>(c);
        ProductFit& fit = result.fit[c];
        treated[c] = treat(samples, channel, fit);
        if (treated[c].median == 0.0) return;  // black: every factor stays 0
        const Vector x = fit_logs(rows, treated[c], fit);
        const auto keep = fit.partly_unsupported ? supported(rows, samples, channel)
                                                 : std::vector<bool>(unknowns, true);
        put_channel(result.brdf, c, x, keep);
    });
    // Only when all channels are there: judging one evaluates the product, which reads all three.
    parallel_for(3, threads, [&](std::size_t c) {
        if (treated[c].median != 0.0)
            judge(result.fit[c], result.brdf, samples, treated[c], static_cast<int>(c));
    });
    if (result.brdf.alpha == Rgba32f{})
        throw Error(ExitCode::failure, "brdf: no measured value is above 0");
    return result;
}

}  // namespace twofold
