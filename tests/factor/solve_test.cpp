#include "factor/solve.hpp"

#include <catch2/catch.hpp>

// Independent implementations to hold ours against; their headers are not free of warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#include <gmm/gmm.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#pragma GCC diagnostic pop

#include "dense_matrix.hpp"
#include "factor/system.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

constexpr std::array solvers{Solver::qmr, Solver::lsmr, Solver::cgls, Solver::qmr_augmented};

LogRows small_rows() {
    FactorSettings settings;
    settings.map_size = 8;
    return log_rows(cases::samples_of({}, 3000, 1).at, settings);
}

/// The regularised system of a Phong lobe, 256 unknowns.
struct SmallSystem {
    FactorSettings settings;
    LogRows left = small_rows();
    ChannelRows right;
    SmallSystem() {
        settings.map_size = 8;
        const LightingSamples samples = cases::samples_of({}, 3000, 1);
        right = channel_rows(left, channel_of(samples.radiance), settings, 1.0);
    }
    static std::vector<double> channel_of(const std::vector<Rgb>& radiance) {
        std::vector<double> red;
        for (const Rgb& rgb : radiance) red.push_back(rgb.x);
        return red;
    }
};

/// The rows of a problem, found column by column from its product.
Eigen::SparseMatrix<double> eigen_matrix(const LeastSquaresProblem& problem, std::size_t columns) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t j = 0; j < columns; ++j) {
        Vector unit(columns, 0.0);
        unit[j] = 1.0;
        const Vector column = problem.a.apply(unit);
        for (std::size_t i = 0; i < column.size(); ++i)
            if (column[i] != 0.0)
                entries.emplace_back(static_cast<int>(i), static_cast<int>(j), column[i]);
    }
    Eigen::SparseMatrix<double> matrix(static_cast<int>(problem.b.size()),
                                       static_cast<int>(columns));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

TEST_CASE("every solver reaches the solution that Eigen's conjugate gradients find") {
    const SmallSystem small;
    const WeightedSystem system(small.left, small.right, small.settings, 1);
    const LeastSquaresProblem problem = system.problem();
    const std::size_t columns = small.left.matrix.columns();
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> oracle;
    oracle.setTolerance(1e-14);
    oracle.setMaxIterations(2000);
    const Eigen::SparseMatrix<double> matrix = eigen_matrix(problem, columns);
    oracle.compute(matrix);
    const Eigen::VectorXd found = oracle.solve(
        Eigen::Map<const Eigen::VectorXd>(problem.b.data(), static_cast<int>(problem.b.size())));
    const Vector wanted =
        system.gauge().balanced(system.unknowns(Vector(found.data(), found.data() + found.size())));
    for (const Solver solver : solvers) {
        const Solution s = solve(solver, problem, Vector(columns, 0.0),
                                 {.tolerance = 1e-10, .iteration_limit = 3000});
        CAPTURE(static_cast<int>(solver), name_of(s.report.status), s.report.iterations);
        CHECK(s.report.status == SolverStatus::converged);
        const Vector x = system.gauge().balanced(system.unknowns(s.x));
        CHECK(largest_magnitude(minus(x, wanted)) < 1e-7);
    }
}

TEST_CASE("QMR takes the iterations that GMM's QMR takes on the normal equations") {
    const SmallSystem small;
    const WeightedSystem system(small.left, small.right, small.settings, 1);
    const LeastSquaresProblem problem = system.problem();
    const std::size_t columns = small.left.matrix.columns();
    gmm::dense_matrix<double> normal(columns, columns);
    for (std::size_t j = 0; j < columns; ++j) {
        Vector unit(columns, 0.0);
        unit[j] = 1.0;
        const Vector column = problem.a.apply_transpose(problem.a.apply(unit));
        for (std::size_t i = 0; i < columns; ++i) normal(i, j) = column[i];
    }
    const Vector b = problem.a.apply_transpose(problem.b);
    Vector found(columns, 0.0);
    gmm::iteration iteration(1e-6);
    iteration.set_maxiter(500);
    gmm::qmr(normal, found, b, gmm::identity_matrix(), iteration);
    const Solution s = solve(Solver::qmr, problem, Vector(columns, 0.0), {.tolerance = 1e-6});
    CHECK(s.report.status == SolverStatus::converged);
    CHECK(std::abs(s.report.iterations - static_cast<int>(iteration.get_iteration())) <= 2);
    CHECK(largest_magnitude(minus(system.gauge().balanced(system.unknowns(found)),
                                  system.gauge().balanced(system.unknowns(s.x)))) < 1e-4);
}

TEST_CASE("the augmented system needs more iterations than the normal equations") {
    const SmallSystem small;
    const WeightedSystem system(small.left, small.right, small.settings, 1);
    const Vector zero(small.left.matrix.columns(), 0.0);
    const StopRule rule{.tolerance = 1e-6, .iteration_limit = 2000};
    const Solution normal = solve(Solver::qmr, system.problem(), zero, rule);
    const Solution augmented = solve(Solver::qmr_augmented, system.problem(), zero, rule);
    CHECK(augmented.report.status == SolverStatus::converged);
    CHECK(augmented.report.iterations > normal.report.iterations);
    CHECK(augmented.report.iterations < 3 * normal.report.iterations);
}

TEST_CASE("F23 CGLS fits a line through four points and survives constant data", "[hard][F23]") {
    const RectangularOperator line = cases::rectangular_operator({{1, 1}, {1, 2}, {1, 3}, {1, 4}});
    const Solution s = solve(Solver::cgls, {line, {6, 5, 7, 10}}, {0, 0}, {.tolerance = 1e-12});
    CHECK(s.report.status == SolverStatus::converged);
    CHECK(s.report.iterations == 2);
    CHECK(s.x[0] == Approx(3.5).epsilon(1e-12));
    CHECK(s.x[1] == Approx(1.4).epsilon(1e-12));
    const Solution zero = solve(Solver::cgls, {line, {0, 0, 0, 0}}, {7, 7}, {});
    CHECK(zero.report.status == SolverStatus::converged);
    CHECK(zero.x == Vector{0, 0});
}

TEST_CASE("F14 right sides of zeros and non-finite ones end by name in every solver",
          "[hard][F14]") {
    const RectangularOperator a = cases::rectangular_operator({{1, 0}, {0, 2}, {0, 0}});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Solver solver : solvers) {
        const Solution zero = solve(solver, {a, {0, 0, 0}}, {0, 0}, {});
        CHECK(zero.report.status == SolverStatus::converged);
        CHECK(zero.report.iterations == 0);
        const Solution bad = solve(solver, {a, {nan, 0, 0}}, {0, 0}, {});
        CHECK(bad.report.status == SolverStatus::non_finite);
        CHECK(all_finite(bad.x));
    }
}
