#include "factor/sparse_matrix.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "texunit/error.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

/// A matrix of `rows` rows of five random entries, columns in no order and sometimes twice.
SparseMatrix random_matrix(std::size_t rows, std::uint32_t columns) {
    RowBuilder builder;
    std::uint64_t draw = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        std::vector<MatrixEntry> row;
        for (int k = 0; k < 5; ++k) {
            const std::uint32_t column = random_u32(7, draw++) % columns;
            const double value = random_unit(7, draw++) - 0.5;
            row.push_back({column, value});
        }
        builder.add(row);
    }
    return builder.build(columns);
}

std::vector<double> random_vector(std::size_t n, std::uint64_t seed) {
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = random_unit(seed, i) - 0.5;
    return x;
}

}  // namespace

TEST_CASE("a row is summed left to right in the order its entries were added") {
    RowBuilder builder;
    builder.add(std::vector<MatrixEntry>{{2, 1.0}, {0, 0x1p-53}, {1, 0x1p-53}});
    builder.add(std::vector<MatrixEntry>{{0, 0x1p-53}, {1, 0x1p-53}, {2, 1.0}});
    builder.add({});
    const SparseMatrix a = builder.build(3);
    const std::vector<double> ones(3, 1.0);
    CHECK(a.multiply(ones, 1) == std::vector<double>{1.0, 1.0 + 0x1p-52, 0.0});
}

TEST_CASE("a column is the ordered sum of its terms over ascending rows") {
    const std::size_t rows = 3000;
    const SparseMatrix a = random_matrix(rows, 4);
    const std::vector<double> y = random_vector(rows, 1);
    const std::vector<double> product = a.multiply_transpose(y, 1);
    for (std::uint32_t j = 0; j < 4; ++j) {
        std::vector<double> terms;
        for (std::size_t i = 0; i < rows; ++i) {
            for (const MatrixEntry& entry : a.row(i)) {
                if (entry.column == j) terms.push_back(entry.value * y[i]);
            }
        }
        REQUIRE(terms.size() > sum_block);
        CHECK(product[j] == ordered_sum(terms.size(), [&](std::size_t k) { return terms[k]; }));
    }
}

TEST_CASE("the two products are each other's transpose") {
    const SparseMatrix a = random_matrix(500, 60);
    const std::vector<double> x = random_vector(60, 2);
    const std::vector<double> y = random_vector(500, 3);
    const std::vector<double> ax = a.multiply(x, 1);
    const std::vector<double> aty = a.multiply_transpose(y, 1);
    const double left = ordered_sum(500, [&](std::size_t i) { return ax[i] * y[i]; });
    const double right = ordered_sum(60, [&](std::size_t j) { return x[j] * aty[j]; });
    CHECK(left == Approx(right).epsilon(1e-12));
}

TEST_CASE("products and norms have the same bits at 1, 2 and 7 threads") {
    const SparseMatrix a = random_matrix(20000, 2000);
    const std::vector<double> x = random_vector(2000, 4);
    const std::vector<double> y = random_vector(20000, 5);
    for (const int threads : {2, 7}) {
        CHECK(a.multiply(x, threads) == a.multiply(x, 1));
        CHECK(a.multiply_transpose(y, threads) == a.multiply_transpose(y, 1));
        CHECK(a.column_norms(y, threads) == a.column_norms(y, 1));
    }
}

TEST_CASE("column norms are those of the weighted rows, 0 for an empty column") {
    RowBuilder builder;
    builder.add(std::vector<MatrixEntry>{{0, 3.0}});
    builder.add(std::vector<MatrixEntry>{{0, 2.0}, {1, 1.0}});
    const SparseMatrix a = builder.build(3);
    CHECK(a.column_norms(std::vector<double>{1.0, 2.0}, 1) == std::vector<double>{5.0, 2.0, 0.0});
}

TEST_CASE("a column beyond the matrix is refused") {
    RowBuilder builder;
    builder.add(std::vector<MatrixEntry>{{3, 1.0}});
    CHECK_THROWS_AS(builder.build(3), Error);
}
