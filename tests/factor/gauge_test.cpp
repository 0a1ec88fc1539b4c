#include "factor/gauge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/factorize.hpp"
#include "factor/sparse_matrix.hpp"
#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

/// Samples within two small clusters of (n, r_v) whose texels nothing joins.
LightingSamples two_clusters() {
    LightingSamples samples;
    for (const SurfaceView& at : surface_views(40000, 1)) {
        const Vec3 r = pi_2(at);
        const double side = at.n.z > 0.9 && r.z > 0.9     ? 1.0
                            : at.n.z < -0.9 && r.z < -0.9 ? 2.0
                                                          : 0.0;
        if (side == 0.0) continue;
        samples.at.push_back(at);
        samples.radiance.push_back(Rgb(side * (1.0 + 0.3 * at.n.x + 0.2 * r.y)));
    }
    return samples;
}

}  // namespace

TEST_CASE("F08 two disjoint patches of texels have a gauge each", "[hard][F08]") {
    const LightingSamples samples = two_clusters();
    REQUIRE(samples.at.size() > 500);
    const FactorSettings settings = cases::unregularised(16, 0.875);
    const LogRows rows = log_rows(samples.at, settings);
    const Gauge gauge(rows.matrix, Vector(rows.matrix.rows(), 1.0), rows.starts());
    REQUIRE(gauge.components() == 2);
    const Vector scale(rows.matrix.columns(), 1.0);
    const std::vector<SparseVector> directions = gauge.null_vectors(scale);
    REQUIRE(directions.size() == 2);
    for (const SparseVector& d : directions) {
        Vector z(rows.matrix.columns(), 0.0);
        for (std::size_t k = 0; k < d.index.size(); ++k) z[d.index[k]] = d.value[k];
        CHECK(largest_magnitude(rows.matrix.multiply(z, 1)) < 1e-15);
    }

    const FactoredLighting result = factorize(samples, {}, settings, 1.0, 1);
    CHECK(result.fit[0].components == 2);
    CHECK(result.fit[0].solver.status == SolverStatus::converged);
    bool told = false;
    for (const std::string& warning : result.warnings)
        told = told || warning.find("2 components") != std::string::npos;
    CHECK(told);
}

TEST_CASE("A balanced component's factors have one mean, and no row moves") {
    const FactorSettings settings = cases::unregularised(16, 0.875);
    const LogRows rows = log_rows(two_clusters().at, settings);
    const Gauge gauge(rows.matrix, Vector(rows.matrix.rows(), 1.0), rows.starts());
    Vector x(rows.matrix.columns());
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = 0.01 * static_cast<double>(j % 37);
    const Vector balanced = gauge.balanced(x);
    // A null vector has weights of one sign on a factor and the other on the other: it is
    // orthogonal to unknowns whose means are equal.
    for (const SparseVector& d : gauge.null_vectors(Vector(x.size(), 1.0))) {
        double sum[2] = {0.0, 0.0}, count[2] = {0.0, 0.0};
        for (std::size_t k = 0; k < d.index.size(); ++k) {
            sum[d.value[k] > 0.0] += balanced[d.index[k]];
            count[d.value[k] > 0.0] += 1.0;
        }
        CHECK(sum[0] / count[0] == Approx(sum[1] / count[1]).margin(1e-12));
    }
    const Vector before = rows.matrix.multiply(x, 1), after = rows.matrix.multiply(balanced, 1);
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(after[i] == Approx(before[i]).margin(1e-12));
}

TEST_CASE("F07 a third factor adds a second null vector, orthogonal to the first", "[hard][F07]") {
    FactorSettings settings;
    settings.map_size = 8;
    settings.view_knots = 24;
    const LogRows rows = log_rows(surface_views(3000, 1), settings);
    const Gauge gauge(rows.matrix, Vector(rows.matrix.rows(), 1.0), rows.starts());
    CHECK(gauge.components() == 1);
    Vector scale(rows.matrix.columns());
    for (std::size_t j = 0; j < scale.size(); ++j)
        scale[j] = 1.0 + 0.01 * static_cast<double>(j % 7);
    const std::vector<SparseVector> directions = gauge.null_vectors(scale);
    REQUIRE(directions.size() == 2);
    std::vector<Vector> dense(2, Vector(scale.size(), 0.0));
    for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t k = 0; k < directions[d].index.size(); ++k)
            dense[d][directions[d].index[k]] = directions[d].value[k];
        CHECK(norm(dense[d]) == Approx(1.0));
        Vector z = dense[d];
        for (std::size_t j = 0; j < z.size(); ++j) z[j] /= scale[j];
        CHECK(largest_magnitude(rows.matrix.multiply(z, 1)) < 1e-14);
        CHECK(norm(without(dense[d], directions)) < 1e-14);
    }
    CHECK(std::fabs(dot(dense[0], dense[1])) < 1e-14);
    // Balancing changes no sample.
    Vector x(scale.size());
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = std::sin(static_cast<double>(j));
    const Vector moved =
        minus(rows.matrix.multiply(gauge.balanced(x), 1), rows.matrix.multiply(x, 1));
    CHECK(largest_magnitude(moved) < 1e-13);
}

TEST_CASE("the gauge of rows as places is that of the same rows as entries") {
    FactorSettings settings = cases::unregularised(GENERATE(4, 16, 40), 0.875);
    settings.view_knots = GENERATE(0, 5);
    const LogRows rows = log_rows(surface_views(600, 1), settings);
    RowBuilder builder;
    for (std::size_t i = 0; i < rows.matrix.rows(); ++i) {
        const RowEntries row = rows.matrix.row(i);
        builder.add(std::vector<MatrixEntry>(row.begin(), row.end()));
    }
    const SparseMatrix entries = builder.build(rows.matrix.columns());
    for (const std::size_t left_out : {0U, 2U, 50U, 500U}) {
        Vector weight(rows.matrix.rows(), 1.0);
        for (std::size_t i = 0; i < left_out; ++i) weight[i * 7919 % 600] = 0.0;
        const Gauge gauge(rows.matrix, weight, rows.starts());
        const Gauge expected(entries, weight, rows.starts());
        REQUIRE(gauge.components() == expected.components());
        const Vector scale(rows.matrix.columns(), 1.0);
        const auto found = gauge.null_vectors(scale), wanted = expected.null_vectors(scale);
        REQUIRE(found.size() == wanted.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            CHECK(found[k].index == wanted[k].index);
            CHECK(found[k].value == wanted[k].value);
        }
    }
}
