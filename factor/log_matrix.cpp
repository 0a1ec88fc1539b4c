#include "factor/log_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twofold {

namespace {

/// More parts would only add to the memory of their sums.
constexpr std::size_t most_parts = 32;

/// The least number of rows in a part, also as a multiple of the unknowns: else adding up the parts
/// would cost more than the rows.
constexpr std::size_t least_rows = 4096;

void square(RunWeights& w, std::size_t k) {
    for (auto& row : w.first) row[k] *= row[k];
    for (auto& row : w.second) row[k] *= row[k];
    for (auto& row : w.view) row[k] *= row[k];
}

}  // namespace

RowParts row_parts(std::size_t rows, std::size_t columns) {
    const std::size_t least = std::max(least_rows, 4 * columns);
    std::size_t count = std::clamp<std::size_t>(rows / least, 1, most_parts);
    if (count >= 2) count &= ~std::size_t{1};  // an even share for two threads
    const std::size_t each = (rows + count - 1) / count;
    const std::size_t length = (each + sum_block - 1) / sum_block * sum_block;
    return {std::max<std::size_t>((rows + length - 1) / std::max<std::size_t>(length, 1), 1),
            length};
}

LogMatrix::LogMatrix(SampleRows samples, const MapShape& shape, SparseMatrix regulariser)
    : samples_(std::move(samples)), shape_(shape), regulariser_(std::move(regulariser)) {}

RowEntries LogMatrix::row(std::size_t i) const {
    RowEntries entries;
    const auto put = [&](std::size_t column, double value) {
        if (value != 0.0) entries.add(column, value);
    };
    if (i >= samples()) {
        for (const MatrixEntry& e : regulariser_.row(i - samples())) put(e.column, e.value);
        return entries;
    }
    const std::array<std::size_t, 4> offset{0, 1, size(), size() + 1};
    for (std::size_t map = 0; map < 2; ++map) {
        const auto weight =
            corner_weights(samples_.fraction[2 * map][i], samples_.fraction[2 * map + 1][i]);
        for (std::size_t k = 0; k < 4; ++k) put(samples_.texel[map][i] + offset[k], weight[k]);
    }
    if (samples_.knot.empty()) return entries;
    const std::size_t knot = 2 * shape_.texels() + samples_.knot[i];
    const double fraction = samples_.knot_fraction[i] * 0x1p-16;
    put(knot, 1.0 - fraction);
    put(knot + 1, fraction);
    return entries;
}

Vector LogMatrix::multiply(std::span<const double> x, int threads) const {
    Vector padded(x.begin(), x.end());
    padded.resize(padded_columns());
    Vector product(samples());
    const RowReader read = reader();
    parallel_for((samples() + least_rows - 1) / least_rows, threads, [&](std::size_t task) {
        const std::size_t end = std::min((task + 1) * least_rows, samples());
        for_rows(read, task * least_rows, end,
                 [&](std::size_t i, const RunWeights& w, std::size_t k) {
                     product[i] = read.times(i, w, k, padded.data());
                 });
    });
    const Vector rest = regulariser_.multiply(x, threads);
    product.insert(product.end(), rest.begin(), rest.end());
    return product;
}

Vector LogMatrix::multiply_transpose(std::span<const double> y, int threads) const {
    return multiply_transpose([y](std::size_t i) { return y[i]; }, threads);
}

Vector LogMatrix::column_norms(std::span<const double> row_weight, int threads) const {
    const RowReader read = reader();
    Vector sums = sum_samples<double>(
        [&](std::size_t first, std::size_t end, double* part) {
            for_rows(read, first, end, [&](std::size_t i, RunWeights& w, std::size_t k) {
                square(w, k);
                read.add(i, w, k, row_weight[i] * row_weight[i], part);
            });
        },
        [] {}, threads);
    Vector norms = with_rest(std::move(sums), [&](const MatrixEntry& e) {
        const double weighted = row_weight[samples() + e.column] * e.value;
        return weighted * weighted;
    });
    for (double& norm : norms) norm = std::sqrt(norm);
    return norms;
}

}  // namespace twofold
