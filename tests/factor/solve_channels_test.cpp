#include "factor/solve_channels.hpp"

#include <catch2/catch.hpp>

#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"
#include "texunit/ordered_sum.hpp"

using namespace twofold;

namespace {

/// Three channels of a Phong material, each with another radiance, over one left side.
struct Channels {
    FactorSettings settings;
    LogRows left;
    std::array<ChannelRows, 3> right;
    std::vector<WeightedSystem> systems;
    std::vector<const WeightedSystem*> together;
    std::vector<Vector> start;

    explicit Channels(int view_knots)
        : settings(settings_of(view_knots)), left(log_rows(pairs().at, settings)) {
        systems.reserve(3);
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<double> radiance;
            for (const Rgb& rgb : pairs().radiance)
                radiance.push_back(c == 1 ? 0.2 : 0.1 * static_cast<double>(c) + rgb.x);
            right[c] = channel_rows(left, radiance, settings, 1.0);
            together.push_back(&systems.emplace_back(left, right[c], settings, 1));
            start.emplace_back(left.matrix.columns(), 0.0);
        }
    }

    static FactorSettings settings_of(int view_knots) {
        FactorSettings settings;
        settings.map_size = 16;
        settings.view_knots = view_knots;
        return settings;
    }
    /// Enough of them for several parts, the last one shorter.
    static const LightingSamples& pairs() {
        static const LightingSamples samples =
            cases::samples_of({0.3, 0.7, 20.0, cases::many_lights()}, 12345, 1);
        return samples;
    }
};

const StopRule rule{.tolerance = 1e-8, .iteration_limit = 300};

}  // namespace

TEST_CASE("three channels in lockstep end as each does alone") {
    const int knots = GENERATE(0, 24);
    const Channels three(knots);
    REQUIRE(row_parts(three.left.samples, three.left.matrix.columns()).count == 2);
    for (const Solver solver : {Solver::qmr, Solver::lsmr}) {
        const auto solved = solve_channels(solver, three.together, three.start, rule, 1);
        REQUIRE(solved.size() == 3);
        for (std::size_t c = 0; c < 3; ++c) {
            const Solution alone = solve(solver, three.systems[c].problem(), three.start[c], rule);
            CAPTURE(c, name_of(solver));
            CHECK(solved[c].report.status == SolverStatus::converged);
            CHECK(solved[c].report.iterations == alone.report.iterations);
            // LSMR's |u| is added up in another order.
            const double apart = norm(minus(solved[c].x, alone.x));
            CHECK(apart <= (solver == Solver::qmr ? 0.0 : 1e-10 * norm(alone.x)));
        }
        CHECK(solved[0].report.iterations != solved[1].report.iterations);
    }
}

TEST_CASE("a channel that starts at its solution waits while the others go on") {
    const Channels three(0);
    std::vector<Vector> start = three.start;
    const auto first = solve_channels(Solver::lsmr, three.together, start, rule, 1);
    start[1] = first[1].x;
    const auto again = solve_channels(Solver::lsmr, three.together, start, rule, 1);
    CHECK(again[1].report.iterations == 0);
    CHECK(again[1].x == first[1].x);
    CHECK(again[0].x == first[0].x);
    CHECK(again[2].x == first[2].x);
}

TEST_CASE("lockstep solves have the same bits at 1, 2 and 7 threads, and without one channel") {
    const Channels three(24);
    for (const Solver solver : {Solver::qmr, Solver::lsmr, Solver::cgls}) {
        const auto one = solve_channels(solver, three.together, three.start, rule, 1);
        for (const int threads : {2, 7}) {
            const auto many = solve_channels(solver, three.together, three.start, rule, threads);
            for (std::size_t c = 0; c < 3; ++c) CHECK(many[c].x == one[c].x);
        }
        const auto two = solve_channels(solver, {three.together[0], three.together[2]},
                                        {three.start[0], three.start[2]}, rule, 1);
        CHECK(two[0].x == one[0].x);
        CHECK(two[1].x == one[2].x);
    }
}

TEST_CASE("sums over columns take the parts as a tree and the regulariser last") {
    FactorSettings settings;
    settings.map_size = 8;
    const LogRows rows = log_rows(surface_views(20000, 1), settings);
    const RowParts parts = row_parts(rows.samples, rows.matrix.columns());
    REQUIRE(parts.count == 4);
    REQUIRE(parts.length % sum_block == 0);
    Vector y(rows.matrix.rows());
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = 1.0 / static_cast<double>(i + 1);
    std::vector<Vector> sum(5, Vector(rows.matrix.columns(), 0.0));
    for (std::size_t i = 0; i < y.size(); ++i) {
        const std::size_t part = i < rows.samples ? i / parts.length : 4;
        for (const MatrixEntry& e : rows.matrix.row(i)) sum[part][e.column] += e.value * y[i];
    }
    const Vector product = rows.matrix.multiply_transpose(y, 2);
    for (std::size_t j = 0; j < product.size(); ++j)
        CHECK(product[j] == ((sum[0][j] + sum[1][j]) + (sum[2][j] + sum[3][j])) + sum[4][j]);
}
