#include "factor/sparse_matrix.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "texunit/error.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// Rows or columns that one thread takes at a time.
constexpr std::size_t block = 512;

/// result[i] = value(i) for all i below n, blocks of i on the threads.
template <class Value>
std::vector<double> fill_blocks(std::size_t n, int threads, const Value& value) {
    std::vector<double> result(n);
    parallel_for((n + block - 1) / block, threads, [&](std::size_t b) {
        const std::size_t end = (b + 1) * block < n ? (b + 1) * block : n;
        for (std::size_t i = b * block; i < end; ++i) result[i] = value(i);
    });
    return result;
}

}  // namespace

SparseMatrix::SparseMatrix(std::size_t columns, std::vector<std::size_t> row_start,
                           std::vector<MatrixEntry> entries)
    : row_start_(std::move(row_start)),
      entries_(std::move(entries)),
      column_start_(columns + 1, 0),
      transposed_(entries_.size()) {
    for (const MatrixEntry& entry : entries_) {
        if (entry.column >= columns) {
            throw Error(ExitCode::failure,
                        fmt::format("sparse matrix: column {} of {}", entry.column, columns));
        }
        ++column_start_[entry.column + 1];
    }
    for (std::size_t j = 0; j < columns; ++j) column_start_[j + 1] += column_start_[j];

    // Counting sort by column: rows stay in ascending order within a column.
    std::vector<std::size_t> next(column_start_.begin(), column_start_.end() - 1);
    for (std::size_t i = 0; i < rows(); ++i) {
        for (const MatrixEntry& entry : row(i)) {
            transposed_[next[entry.column]++] = {static_cast<std::uint32_t>(i), entry.value};
        }
    }
}

std::vector<double> SparseMatrix::multiply(std::span<const double> x, int threads) const {
    return fill_blocks(rows(), threads, [&](std::size_t i) {
        double sum = 0.0;
        for (const MatrixEntry& entry : row(i)) sum += entry.value * x[entry.column];
        return sum;
    });
}

template <class Term>
std::vector<double> SparseMatrix::sum_columns(const Term& term, int threads) const {
    return fill_blocks(columns(), threads, [&](std::size_t j) {
        const auto entries = column(j);
        const std::size_t count = entries.size();
        const auto of_column = [&](std::size_t k) { return term(entries[k]); };
        // A column of one block needs no tree; the bits are those of ordered_sum either way.
        return count <= sum_block ? ordered_block_sum(0, count, of_column)
                                  : ordered_sum(count, of_column);
    });
}

std::vector<double> SparseMatrix::multiply_transpose(std::span<const double> y, int threads) const {
    return sum_columns([&](const MatrixEntry& e) { return e.value * y[e.column]; }, threads);
}

std::vector<double> SparseMatrix::column_norms(std::span<const double> row_weight,
                                               int threads) const {
    std::vector<double> norms = sum_columns(
        [&](const MatrixEntry& e) {
            const double weighted = row_weight[e.column] * e.value;
            return weighted * weighted;
        },
        threads);
    for (double& norm : norms) norm = std::sqrt(norm);
    return norms;
}

void RowBuilder::add(std::span<const MatrixEntry> row) {
    entries_.insert(entries_.end(), row.begin(), row.end());
    row_start_.push_back(entries_.size());
}

SparseMatrix RowBuilder::build(std::size_t columns) {
    std::vector<std::size_t> starts = std::exchange(row_start_, {0});
    return {columns, std::move(starts), std::exchange(entries_, {})};
}

}  // namespace twofold
