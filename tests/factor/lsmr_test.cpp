#include "factor/lsmr.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "dense_matrix.hpp"
#include "factor/qmr.hpp"
#include "factor/system.hpp"
#include "factor_cases.hpp"

using namespace twofold;

TEST_CASE("LSMR fits a line through four points") {
    // y = 3.5 + 1.4 t at t = 1..4 is the textbook least-squares line of 6, 5, 7, 10.
    const Solution s = solve_lsmr(cases::rectangular_operator({{1, 1}, {1, 2}, {1, 3}, {1, 4}}),
                                  {6, 5, 7, 10}, {0, 0}, {.tolerance = 1e-12});
    CHECK(s.report.status == SolverStatus::converged);
    CHECK(s.report.iterations == 2);
    CHECK(s.x[0] == Approx(3.5).epsilon(1e-13));
    CHECK(s.x[1] == Approx(1.4).epsilon(1e-13));
}

TEST_CASE("F23 LSMR from the solution, and on a right side of zeros, takes 0 iterations",
          "[hard][F23]") {
    const RectangularOperator a = cases::rectangular_operator({{1, 0}, {0, 2}, {0, 0}});
    const Solution exact = solve_lsmr(a, {3, 4, 5}, {3, 2}, {.tolerance = 1e-12});
    CHECK(exact.report.status == SolverStatus::converged);
    CHECK(exact.report.iterations == 0);
    CHECK(exact.x == Vector{3, 2});
    const Solution zero = solve_lsmr(a, {0, 0, 0}, {7, 7}, {.tolerance = 1e-12});
    CHECK(zero.report.status == SolverStatus::converged);
    CHECK(zero.report.iterations == 0);
    CHECK(zero.x == Vector{0, 0});
}

TEST_CASE("F16 LSMR stays finite at both ends of the range of b", "[hard][F16]") {
    const RectangularOperator a = cases::rectangular_operator({{1, 0}, {0, 2}});
    for (const double size : {1e-300, 1e300}) {
        const Solution s = solve_lsmr(a, {size, size}, {0, 0}, {.tolerance = 1e-12});
        CHECK(s.report.status == SolverStatus::converged);
        CHECK(s.x[0] == Approx(size).epsilon(1e-14));
        CHECK(s.x[1] == Approx(size / 2).epsilon(1e-14));
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(solve_lsmr(a, {nan, 1}, {0, 0}, {}).report.status == SolverStatus::non_finite);
}

TEST_CASE("the first ten iterates of QMR on the normal equations are LSMR's") {
    for (const double smoothness : {0.0, 1.0}) {
        FactorSettings settings;
        settings.map_size = 16;
        settings.smoothness = smoothness;
        const LightingSamples samples =
            cases::samples_of({0.3, 0.7, 20.0, cases::many_lights()}, 30000, 1);
        std::vector<double> radiance;
        for (const Rgb& rgb : samples.radiance) radiance.push_back(rgb.x);
        const LogRows left = log_rows(samples.at, settings);
        const ChannelRows right = channel_rows(left, radiance, settings, 1.0);
        const WeightedSystem system(left, right, settings, 1);
        const Vector b = system.right_side();
        const Vector zero(left.matrix.columns(), 0.0);
        for (int k = 1; k <= 10; ++k) {
            const StopRule rule{.tolerance = 1e-12, .iteration_limit = k};
            const Solution qmr = solve_qmr(normal_equations(system.problem()),
                                           system.apply_transpose(b), zero, rule);
            const Solution lsmr = solve_lsmr(system.problem().a, b, zero, rule);
            CAPTURE(k);
            REQUIRE(qmr.report.best_iteration == k);
            REQUIRE(lsmr.report.best_iteration == k);
            CHECK(norm(minus(qmr.x, lsmr.x)) <= 1e-11 * norm(lsmr.x));
        }
    }
}

TEST_CASE("LSMR's gradient falls in every iteration and is the true one") {
    FactorSettings settings;
    settings.map_size = 8;
    const LightingSamples samples = cases::samples_of({}, 5000, 1);
    std::vector<double> radiance;
    for (const Rgb& rgb : samples.radiance) radiance.push_back(rgb.x);
    const LogRows left = log_rows(samples.at, settings);
    const ChannelRows right = channel_rows(left, radiance, settings, 1.0);
    const WeightedSystem system(left, right, settings, 1);
    const Solution s = solve_lsmr(system.problem().a, system.right_side(),
                                  Vector(left.matrix.columns(), 0.0), {.tolerance = 1e-8});
    REQUIRE(s.report.status == SolverStatus::converged);
    for (std::size_t i = 1; i < s.report.history.size(); ++i) {
        CHECK(s.report.history[i] < s.report.history[i - 1]);
    }
    CHECK(s.report.relative_residual == Approx(s.report.history.back()).epsilon(1e-3));
}
