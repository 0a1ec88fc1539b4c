#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twofold {

/// One stored entry of a row.
struct MatrixEntry {
    std::uint32_t column = 0;
    double value = 0.0;
};

/// A matrix in compressed rows, and its transpose stored beside it, so that either product reads
/// memory in order and gives each result to one thread: the same bits at any number of threads
/// (docs/exactness.md, section 3). Entries of a row keep the order they were added in; a column may
/// occur twice in a row and then counts twice.
class SparseMatrix {
  public:
    /// Takes finished rows. @param row_start where each row begins, and past the last one its end
    /// @throws Error if a column is not below `columns`
    SparseMatrix(std::size_t columns, std::vector<std::size_t> row_start,
                 std::vector<MatrixEntry> entries);

    std::size_t rows() const { return row_start_.size() - 1; }
    std::size_t columns() const { return column_start_.size() - 1; }

    /// The entries of a row, in the order they were added.
    std::span<const MatrixEntry> row(std::size_t i) const {
        return std::span(entries_).subspan(row_start_[i], row_start_[i + 1] - row_start_[i]);
    }

    /// The entries of a column, rows ascending; `column` of an entry holds the row.
    std::span<const MatrixEntry> column(std::size_t j) const {
        return std::span(transposed_)
            .subspan(column_start_[j], column_start_[j + 1] - column_start_[j]);
    }

    /// A x, each row summed left to right. @param x `columns` values
    std::vector<double> multiply(std::span<const double> x, int threads) const;

    /// A^T y, each column in the ordered sum over ascending rows. @param y `rows` values
    std::vector<double> multiply_transpose(std::span<const double> y, int threads) const;

    /// Euclidean norm of each column of diag(row_weight) A; entries that repeat a column in a row
    /// are squared one by one.
    std::vector<double> column_norms(std::span<const double> row_weight, int threads) const;

  private:
    template <class Term>
    std::vector<double> sum_columns(const Term& term, int threads) const;

    std::vector<std::size_t> row_start_;
    std::vector<MatrixEntry> entries_;
    std::vector<std::size_t> column_start_;
    std::vector<MatrixEntry> transposed_;  ///< entries by column; `column` holds the row
};

/// Collects the rows of a matrix one after another.
class RowBuilder {
  public:
    /// Appends one row.
    void add(std::span<const MatrixEntry> row);

    std::size_t rows() const { return row_start_.size() - 1; }

    /// The matrix; the builder is empty afterwards.
    SparseMatrix build(std::size_t columns);

  private:
    std::vector<std::size_t> row_start_{0};
    std::vector<MatrixEntry> entries_;
};

}  // namespace twofold
