#include "factor/gauge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "factor/log_matrix.hpp"
#include "factor/sparse_matrix.hpp"
#include "factor/vector_arithmetic.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// Disjoint sets of unknowns; the smallest member stands for a set.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = find(i), b = find(j);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

struct Connection {
    DisjointSets sets;
    std::vector<bool> touched;
};

template <class Matrix>
void connect_row(Connection& found, const Matrix& rows, std::size_t i) {
    std::optional<std::uint32_t> first;
    for (const MatrixEntry& entry : rows.row(i)) {
        if (entry.value == 0.0) continue;
        found.touched[entry.column] = true;
        if (!first) first = entry.column;
        found.sets.join(*first, entry.column);
    }
}

/// Which footprints rows had: the bits of an unknown say which weights were 0 where it came first.
class SeenFootprints {
  public:
    explicit SeenFootprints(const LogMatrix& rows)
        : at_(rows.places()), first_knot_(rows.first_knot()), kinds_(rows.columns()) {}

    /// Whether a row before had the footprints of this one, each by itself.
    bool take(std::size_t i) {
        const bool first = take(at_.texel[0][i], at_.fraction[0][i], at_.fraction[1][i]);
        const bool second = take(at_.texel[1][i], at_.fraction[2][i], at_.fraction[3][i]);
        const bool third = at_.knot.empty() || take(knot(i), at_.knot_fraction[i], 0);
        return first && second && third;
    }

    /// The first unknowns, whose weights are never 0, in one set.
    bool joined(std::size_t i, DisjointSets& sets) const {
        const std::uint32_t set = sets.find(at_.texel[0][i]);
        return sets.find(at_.texel[1][i]) == set && (at_.knot.empty() || sets.find(knot(i)) == set);
    }

  private:
    std::uint32_t knot(std::size_t i) const { return first_knot_ + at_.knot[i]; }

    bool take(std::uint32_t first, std::uint16_t x, std::uint16_t y) {
        const unsigned kind = 1U << ((x != 0 ? 1U : 0U) + (y != 0 ? 2U : 0U));
        const bool seen = (kinds_[first] & kind) != 0;
        kinds_[first] = static_cast<std::uint8_t>(kinds_[first] | kind);
        return seen;
    }

    const SampleRows& at_;
    std::uint32_t first_knot_;
    std::vector<std::uint8_t> kinds_;
};

/// The rows of samples: one whose like was seen connects nothing.
/// @return their number
std::size_t connect_samples(Connection& found, const LogMatrix& rows,
                            std::span<const double> weight) {
    SeenFootprints seen(rows);
    for (std::size_t i = 0; i < rows.samples(); ++i)
        if (weight[i] > 0.0 && !(seen.take(i) && seen.joined(i, found.sets)))
            connect_row(found, rows, i);
    return rows.samples();
}

std::size_t connect_samples(Connection&, const SparseMatrix&, std::span<const double>) { return 0; }

template <class Matrix>
Connection connected(const Matrix& rows, std::span<const double> row_weight) {
    Connection found{DisjointSets(rows.columns()), std::vector<bool>(rows.columns(), false)};
    for (std::size_t i = connect_samples(found, rows, row_weight); i < rows.rows(); ++i)
        if (row_weight[i] > 0.0) connect_row(found, rows, i);
    return found;
}

std::size_t factor_of(std::size_t unknown, const FactorStarts& starts) {
    std::size_t factor = 0;
    while (unknown >= starts[factor + 1]) ++factor;
    return factor;
}

double sum_over(const std::vector<std::uint32_t>& index, const Vector& x) {
    return ordered_sum(index.size(), [&](std::size_t k) { return x[index[k]]; });
}

double mean_over(const std::vector<std::uint32_t>& index, const Vector& x) {
    return index.empty() ? 0.0 : sum_over(index, x) / static_cast<double>(index.size());
}

double square_over(const std::vector<std::uint32_t>& index, const Vector& x) {
    return ordered_sum(index.size(), [&](std::size_t k) { return x[index[k]] * x[index[k]]; });
}

void shift(Vector& x, const std::vector<std::uint32_t>& index, double by) {
    for (const std::uint32_t j : index) x[j] += by;
}

double norm_of(const Vector& x) {
    return std::sqrt(ordered_sum(x.size(), [&](std::size_t k) { return x[k] * x[k]; }));
}

/// Appends factor x D at the unknowns.
void append(SparseVector& to, const std::vector<std::uint32_t>& index, const Vector& column_scale,
            double factor) {
    for (const std::uint32_t j : index) {
        to.index.push_back(j);
        to.value.push_back(factor * column_scale[j]);
    }
}

SparseVector of_unit_length(SparseVector v) {
    const double length = norm_of(v.value);
    for (double& value : v.value) value /= length;
    return v;
}

}  // namespace

template <class Matrix>
Gauge::Gauge(const Matrix& rows, std::span<const double> row_weight, const FactorStarts& starts) {
    Connection connection = connected(rows, row_weight);
    std::map<std::uint32_t, Part> found;
    for (std::uint32_t j = 0; j < rows.columns(); ++j) {
        if (connection.touched[j])
            found[connection.sets.find(j)][factor_of(j, starts)].push_back(j);
    }
    for (auto& [first, part] : found) {
        const auto factors = std::count_if(part.begin(), part.end(),
                                           [](const auto& index) { return !index.empty(); });
        if (factors >= 2) parts_.push_back(std::move(part));
    }
    if (parts_.empty()) return;
    for (std::uint32_t j = 0; j < rows.columns(); ++j) {
        if (!connection.touched[j]) parts_[0][factor_of(j, starts)].push_back(j);
    }
    for (auto& index : parts_[0]) std::stable_sort(index.begin(), index.end());
}

template Gauge::Gauge(const LogMatrix&, std::span<const double>, const FactorStarts&);
template Gauge::Gauge(const SparseMatrix&, std::span<const double>, const FactorStarts&);

Vector Gauge::balanced(Vector x) const {
    for (const auto& [first, second, third] : parts_) {
        const double mean3 = mean_over(third, x);
        const double apart = 0.5 * (mean_over(first, x) - mean_over(second, x));
        shift(x, first, 0.5 * mean3 - apart);
        shift(x, second, 0.5 * mean3 + apart);
        shift(x, third, -mean3);
    }
    return x;
}

std::vector<SparseVector> Gauge::null_vectors(const Vector& column_scale) const {
    std::vector<SparseVector> directions;
    for (const auto& [first, second, third] : parts_) {
        SparseVector pair;
        append(pair, first, column_scale, 1.0);
        append(pair, second, column_scale, -1.0);
        directions.push_back(of_unit_length(std::move(pair)));
        if (third.empty()) continue;
        // Coefficients a1, a2, a3 that sum to 0, orthogonal to (1, -1, 0) in lengths D.
        const double n1 = square_over(first, column_scale);
        const double n2 = square_over(second, column_scale);
        SparseVector triple;
        append(triple, first, column_scale, n2 / (n1 + n2));
        append(triple, second, column_scale, n1 / (n1 + n2));
        append(triple, third, column_scale, -1.0);
        directions.push_back(of_unit_length(std::move(triple)));
    }
    return directions;
}

Vector without(Vector y, const std::vector<SparseVector>& directions) {
    for (const SparseVector& d : directions) {
        if (d.index.size() == y.size()) {  // ascending: all of them
            const double along = dot(d.value, y);
            y = plus_scaled(std::move(y), -along, d.value);
            continue;
        }
        const double along =
            ordered_sum(d.index.size(), [&](std::size_t k) { return d.value[k] * y[d.index[k]]; });
        for (std::size_t k = 0; k < d.index.size(); ++k) y[d.index[k]] += -along * d.value[k];
    }
    return y;
}

}  // namespace twofold
