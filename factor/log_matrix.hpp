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
    /// @param beside beside() is other work, no longer than a part's, that a thread does meanwhile
    template <class Value, class AddPart, std::invocable Beside>
    std::vector<Value> sum_samples(const AddPart& add_part, const Beside& beside,
                                   int threads) const;

    /// The sums of the sample rows cut to the columns, plus term(entry) of the regulariser's rows.
    template <class Value, class Term>
    std::vector<Value> with_rest(std::vector<Value> sums, const Term& term) const;

  private:
    std::size_t size() const { return static_cast<std::size_t>(shape_.size); }

    SampleRows samples_;
    MapShape shape_;
    SparseMatrix regulariser_;
};

/// Columns over which the parts are added up at a time: their sums stay in the cache.
inline constexpr std::size_t tree_columns = 256;

/// Adds up the columns [first, end) of all parts, in place, into those of the first: the tree,
/// level by level; an odd last part moves up unchanged.
template <class Value>
void add_up(std::vector<std::vector<Value>>& parts, std::size_t first, std::size_t end) {
    for (std::size_t step = 1; step < parts.size(); step *= 2)
        for (std::size_t left = 0; left + step < parts.size(); left += 2 * step) {
            Value* const sums = parts[left].data();
            const Value* const more = parts[left + step].data();
            for (std::size_t j = first; j < end; ++j) sums[j] += more[j];
        }
}

template <class Value, class AddPart, std::invocable Beside>
std::vector<Value> LogMatrix::sum_samples(const AddPart& add_part, const Beside& beside,
                                          int threads) const {
    const RowParts parts = row_parts(samples(), columns());
    std::vector<std::vector<Value>> sums(parts.count);
    parallel_for(parts.count + 1, threads, [&](std::size_t task) {
        if (task == 0) return beside();
        const std::size_t p = task - 1;
        sums[p].resize(padded_columns());
        const std::size_t end = (p + 1) * parts.length;
        add_part(p * parts.length, end < samples() ? end : samples(), sums[p].data());
    });
    const std::size_t runs = parts.count > 1 ? (columns() - 1) / tree_columns + 1 : 0;
    parallel_for(runs, threads, [&](std::size_t run) {
        const std::size_t end = (run + 1) * tree_columns;
        add_up(sums, run * tree_columns, end < columns() ? end : columns());
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
        [] {}, threads);
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
