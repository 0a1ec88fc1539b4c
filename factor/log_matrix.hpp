#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "factor/sample_rows.hpp"
#include "factor/solver.hpp"
#include "factor/sparse_matrix.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

/// The entries of one row, in order.
class RowEntries {
  public:
    void add(std::size_t column, double value) {
        entries_[size_++] = {static_cast<std::uint32_t>(column), value};
    }
    std::size_t size() const { return size_; }
    const MatrixEntry& operator[](std::size_t k) const { return entries_[k]; }
    const MatrixEntry* begin() const { return entries_.data(); }
    const MatrixEntry* end() const { return entries_.data() + size_; }

  private:
    std::array<MatrixEntry, 10> entries_;
    std::size_t size_ = 0;
};

/// How the sample rows are parted for sums over columns: by their number and that of the unknowns
/// alone, never by threads.
struct RowParts {
    std::size_t count = 1;
    std::size_t length = 0;  ///< rows of a part, a multiple of sum_block; the last may be shorter
};

RowParts row_parts(std::size_t rows, std::size_t columns);

/// The left side of the system: sample rows as places in the maps, then the few rows of the
/// regulariser as a stored matrix. Sums over a column take the sample rows part by part, ascending
/// in a part, the parts as a tree, and add the regulariser's rows, ascending, at the end
/// (docs/exactness.md, section 3): the same bits at any number of threads.
class LogMatrix {
  public:
    LogMatrix(SampleRows samples, const MapShape& shape, SparseMatrix regulariser);

    std::size_t rows() const { return samples() + regulariser_.rows(); }
    std::size_t columns() const { return regulariser_.columns(); }
    std::size_t samples() const { return samples_.size(); }

    /// The entries of a row that are not 0.
    RowEntries row(std::size_t i) const;

    /// A x. @param x `columns` values
    Vector multiply(std::span<const double> x, int threads) const;

    /// A^T y. @param y `rows` values
    Vector multiply_transpose(std::span<const double> y, int threads) const;

    /// The same for values that need not be stored. @param y y(i) of each row
    template <std::invocable<std::size_t> RowValue>
    Vector multiply_transpose(const RowValue& y, int threads) const;

    /// Euclidean norm of each column of diag(row_weight) A.
    Vector column_norms(std::span<const double> row_weight, int threads) const;

    const SampleRows& places() const { return samples_; }
    /// The unknown of the first knot of g.
    std::uint32_t first_knot() const { return static_cast<std::uint32_t>(2 * shape_.texels()); }
    RowReader reader() const { return {samples_, shape_}; }
    const SparseMatrix& regulariser() const { return regulariser_; }
    /// Length of a vector of unknowns that sample rows may be multiplied with.
    std::size_t padded_columns() const { return columns() + size() + 1; }

    /// Sums over the columns of the sample rows.
    /// @param add_part add_part(first, end, sums) adds the rows [first, end) to sums, which has
    ///        padded_columns() values and is 0 before
    template <class Value, class AddPart>
    std::vector<Value> sum_samples(const AddPart& add_part, int threads) const;

    /// The sums of the sample rows cut to the columns, plus term(entry) of the regulariser's rows.
    template <class Value, class Term>
    std::vector<Value> with_rest(std::vector<Value> sums, const Term& term) const;

  private:
    std::size_t size() const { return static_cast<std::size_t>(shape_.size); }

    SampleRows samples_;
    MapShape shape_;
    SparseMatrix regulariser_;
};

template <class Value, class AddPart>
std::vector<Value> LogMatrix::sum_samples(const AddPart& add_part, int threads) const {
    const RowParts parts = row_parts(samples(), columns());
    std::vector<std::vector<Value>> sums(parts.count);
    parallel_for(parts.count, threads, [&](std::size_t p) {
        sums[p].resize(padded_columns());
        const std::size_t end = (p + 1) * parts.length;
        add_part(p * parts.length, end < samples() ? end : samples(), sums[p].data());
    });
    // The tree, level by level, in place; an odd last part moves up unchanged.
    for (std::size_t step = 1; step < parts.count; step *= 2)
        parallel_for((parts.count - 1) / (2 * step) + 1, threads, [&](std::size_t pair) {
            const std::size_t left = 2 * step * pair;
            if (left + step >= parts.count) return;
            for (std::size_t j = 0; j < columns(); ++j) sums[left][j] += sums[left + step][j];
        });
    return std::move(sums[0]);
}

template <std::invocable<std::size_t> RowValue>
Vector LogMatrix::multiply_transpose(const RowValue& y, int threads) const {
    const RowReader read = reader();
    Vector sums = sum_samples<double>(
        [&](std::size_t first, std::size_t end, double* part) {
            for_rows(read, first, end, [&](std::size_t i, const RunWeights& w, std::size_t k) {
                read.add(i, w, k, y(i), part);
            });
        },
        threads);
    return with_rest(std::move(sums),
                     [&](const MatrixEntry& e) { return e.value * y(samples() + e.column); });
}

template <class Value, class Term>
std::vector<Value> LogMatrix::with_rest(std::vector<Value> sums, const Term& term) const {
    sums.resize(columns());
    for (std::size_t j = 0; j < columns(); ++j) {
        Value rest{};
        for (const MatrixEntry& entry : regulariser_.column(j)) rest += term(entry);
        sums[j] += rest;
    }
    return sums;
}

}  // namespace twofold
