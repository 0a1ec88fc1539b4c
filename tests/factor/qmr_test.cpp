#include "factor/qmr.hpp"

#include <gmm/gmm.h>

#include <catch2/catch.hpp>
#include <limits>

#include "dense_matrix.hpp"
#include "texunit/random.hpp"

using namespace twofold;
using cases::Dense;

namespace {

using Status = SolverStatus;

constexpr StopRule strict{.tolerance = 1e-12, .iteration_limit = 30};

/// One line of the table of ends and breakdowns.
struct End {
    const char* title;
    Dense a;
    Vector b;
    Status status;
    int iterations;
    Vector x;
};

}  // namespace

TEST_CASE("F14 QMR ends as the table of ends and breakdowns says", "[hard][F14]") {
    const std::vector<End> table{
        {"b = 0", {{4, 1}, {1, 3}}, {0, 0}, Status::converged, 0, {0, 0}},
        {"regular", {{4, 1}, {1, 3}}, {1, 2}, Status::converged, 2, {1.0 / 11, 7.0 / 11}},
        {"diagonal", {{2, 0}, {0, 3}}, {1, 0}, Status::converged, 1, {0.5, 0}},
        {"singular, consistent", {{1, 1}, {1, 1}}, {2, 2}, Status::converged, 1, {1, 1}},
        {"skew", {{0, 1}, {-1, 0}}, {1, 0}, Status::breakdown_epsilon, 1, {0, 0}},
        {"indefinite", {{1, 0}, {0, -1}}, {1, 1}, Status::breakdown_epsilon, 1, {0, 0}},
        {"cyclic shift",
         {{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}},
         {1, 0, 0, 0},
         Status::breakdown_epsilon,
         1,
         {0, 0, 0, 0}},
        {"zero matrix", {{0, 0}, {0, 0}}, {1, 1}, Status::breakdown_epsilon, 1, {0, 0}},
        {"inconsistent", {{-1, -1}, {-1, -1}}, {0, -1}, Status::breakdown_epsilon, 2, {0, 0.5}},
        {"delta",
         {{-1, 1, -1}, {-1, -1, -1}, {-1, -1, -1}},
         {0, -1, 0},
         Status::breakdown_delta,
         2,
         {0, 1.0 / 3, 0}},
        {"xi", {{-1, 0}, {-1, -1}}, {-1, 0}, Status::breakdown_xi, 2, {0.5, 0}},
        {"rho by exact tests, 4",
         {{-1, -1, 1}, {1, -1, -1}, {-1, -1, -1}},
         {-1, -1, 0},
         Status::breakdown_epsilon,
         2,
         {0.25, 0.25, 0}},
        {"runs away by exact tests",
         {{1, 0, 0}, {1, -1, -1}, {-1, -1, -1}},
         {1, 0, -1},
         Status::breakdown_rho,
         4,
         {0.741425, 0.664908, -0.408971}},
        {"cap by exact tests",
         {{0, 0, -1}, {-1, -1, -1}, {-1, -1, -1}},
         {1, 1, -1},
         Status::breakdown_xi,
         3,
         {1, 0.5, -1}},
        {"NaN by exact tests",
         {{1, 1, 1}, {-1, -1, 0}, {-1, -1, 0}},
         {1, 0, -1},
         Status::breakdown_epsilon,
         3,
         {0.08716, 0.4817, 0.3945}},
        {"price of the threshold",
         {{1, 0}, {0, 1e-16}},
         {1, 1},
         Status::breakdown_rho,
         3,
         {1.205, 9.558e15}},
    };
    for (const End& end : table) {
        INFO(end.title);
        const Solution s =
            solve_qmr(cases::square_operator(end.a), end.b, Vector(end.b.size(), 0.0), strict);
        CHECK(name_of(s.report.status) == std::string(name_of(end.status)));
        CHECK(s.report.iterations == end.iterations);
        for (std::size_t i = 0; i < end.x.size(); ++i) {
            CHECK(s.x[i] == Approx(end.x[i]).epsilon(1e-3).margin(1e-6));
        }
    }
}

TEST_CASE("F14 QMR from the solution is converged in 0 iterations", "[hard][F14]") {
    const Solution s = solve_qmr(cases::square_operator({{2, 0}, {0, 2}}), {2, 4}, {1, 2}, strict);
    CHECK(s.report.status == Status::converged);
    CHECK(s.report.iterations == 0);
    CHECK(s.x == Vector{1, 2});
}

TEST_CASE("F14 QMR refuses input that is not finite before it begins", "[hard][F14]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SquareOperator identity = cases::square_operator({{1, 0}, {0, 1}});
    const Solution bad_b = solve_qmr(identity, {nan, 1}, {3, 4}, strict);
    CHECK(bad_b.report.status == Status::non_finite);
    CHECK(bad_b.report.iterations == 0);
    CHECK(bad_b.x == Vector{3, 4});
    CHECK(solve_qmr(identity, {1, 1}, {nan, 1}, strict).x == Vector{0, 0});
}

TEST_CASE("F22 a recurrence that has lost the residual does not count as converged",
          "[hard][F22]") {
    const SquareOperator a = cases::square_operator({{1, 0, 0}, {1, -1, -1}, {-1, -1, -1}});
    const Solution relative = solve_qmr(a, {-1, -1, 0}, Vector(3, 0.0), strict);
    CHECK(relative.report.status != Status::converged);
    const StopRule exact_zero{.tolerance = 1e-12, .iteration_limit = 30, .breakdown = 0.0};
    const Solution mutant = solve_qmr(a, {-1, -1, 0}, Vector(3, 0.0), exact_zero);
    CHECK(mutant.report.status != Status::converged);
    CHECK(mutant.report.relative_residual > 0.1);
    CHECK(mutant.report.relative_residual <= 1.0);
}

TEST_CASE("F16 powers of two keep QMR exact at both ends of the exponent range", "[hard][F16]") {
    const Solution tiny = solve_qmr(cases::square_operator({{1e-300, 0}, {0, 1e-300}}),
                                    {1e-300, 1e-300}, {0, 0}, strict);
    CHECK(tiny.report.status == Status::converged);
    CHECK(tiny.report.iterations == 1);
    CHECK(tiny.x == Vector{1, 1});
}

TEST_CASE("F17 QMR reports a result beyond the range and stores no infinity", "[hard][F17]") {
    const Solution huge =
        solve_qmr(cases::square_operator({{1e200, 0}, {0, 2e200}}), {1e200, 1e200}, {0, 0}, strict);
    CHECK(huge.report.status == Status::converged);
    CHECK(huge.report.iterations == 2);
    CHECK(huge.x[0] == Approx(1.0).epsilon(4.5e-16));
    CHECK(huge.x[1] == Approx(0.5).epsilon(4.5e-16));

    const Solution beyond = solve_qmr(cases::square_operator({{1e-300, 0}, {0, 1e-300}}),
                                      {1e200, 1e200}, {0, 0}, strict);
    CHECK(beyond.report.status == Status::non_finite);
    CHECK(beyond.x == Vector{0, 0});
}

TEST_CASE("F14 each scalar that vanishes has its own name", "[hard][F14]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto of = [](QmrScalars s) { return breakdown_of(s, 1e-12); };
    CHECK_FALSE(of({}).has_value());
    CHECK(of({.rho = 1e-13}) == Status::breakdown_rho);
    CHECK(of({.xi = 1e-13}) == Status::breakdown_xi);
    CHECK(of({.delta = -1e-13}) == Status::breakdown_delta);
    CHECK(of({.epsilon = 1e-10, .epsilon_scale = 1e3}) == Status::breakdown_epsilon);
    CHECK(of({.beta = 0.0}) == Status::breakdown_beta);
    CHECK(of({.beta = nan}) == Status::breakdown_beta);
    CHECK(of({.gamma = 0.0}) == Status::breakdown_gamma);
    CHECK(of({.rho = nan}) == Status::non_finite);
    CHECK(of({.epsilon = nan}) == Status::non_finite);
}

TEST_CASE("QMR agrees with GMM++'s QMR on a system without symmetry") {
    const std::size_t n = 40;
    Dense a(n, Vector(n));
    gmm::dense_matrix<double> peer(n, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i][j] = random_unit(3, i * n + j) - 0.5 + (i == j ? 6.0 : 0.0);
            peer(i, j) = a[i][j];
        }
    }
    Vector b(n);
    for (std::size_t i = 0; i < n; ++i) b[i] = random_unit(4, i);
    Vector peer_x(n, 0.0);
    gmm::iteration peer_stop(1e-13);
    gmm::qmr(peer, peer_x, b, gmm::identity_matrix(), peer_stop);

    const Solution s = solve_qmr(cases::square_operator(a), b, Vector(n, 0.0),
                                 {.tolerance = 1e-13, .iteration_limit = 100});
    CHECK(s.report.status == Status::converged);
    CHECK(std::abs(s.report.iterations - static_cast<int>(peer_stop.get_iteration())) <= 2);
    CHECK(largest_magnitude(minus(s.x, peer_x)) < 1e-12);
}
