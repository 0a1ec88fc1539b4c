#include "study/sweep/curves.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>

#include "study/sweep/timing.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

bool beats(const CurvePoint& a, const CurvePoint& b) {
    return a.x <= b.x && a.y <= b.y && (a.x < b.x || a.y < b.y);
}

/// Small whole numbers, so that many coordinates are equal.
std::vector<CurvePoint> random_points(std::uint64_t seed) {
    std::vector<CurvePoint> points;
    for (std::uint64_t i = 0; i < 40; ++i)
        points.push_back({static_cast<double>(random_u64(seed, 2 * i) % 12),
                          static_cast<double>(random_u64(seed, 2 * i + 1) % 12)});
    return points;
}

/// Takes a little more than so much processor time.
void be_busy(double seconds) {
    const std::clock_t start = std::clock();
    while (static_cast<double>(std::clock() - start) <= seconds * CLOCKS_PER_SEC) {
    }
}

}  // namespace

TEST_CASE("the Pareto front is what no other point beats, as a search over all pairs finds it") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto points = random_points(seed);
        const auto front = pareto_front(points);
        std::size_t unbeaten_different = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            bool beaten = false, seen = false;
            for (std::size_t j = 0; j < points.size(); ++j) {
                beaten = beaten || beats(points[j], points[i]);
                seen = seen || (j < i && points[j].x == points[i].x && points[j].y == points[i].y);
            }
            unbeaten_different += !beaten && !seen ? 1U : 0U;
        }
        REQUIRE(front.size() == unbeaten_different);
        for (std::size_t k = 0; k + 1 < front.size(); ++k) {
            CHECK(points[front[k]].x < points[front[k + 1]].x);
            CHECK(points[front[k]].y > points[front[k + 1]].y);
        }
    }
    CHECK(pareto_front({}).empty());
}

TEST_CASE("a power law's exponent and a halving's rate are found from their points") {
    std::vector<CurvePoint> power, halving, scattered{{1, 1}, {2, 3}, {3, 2}, {4, 6}};
    for (const double x : {1.0, 2.0, 5.0, 40.0}) power.push_back({x, 3.0 / (x * x)});
    for (const double x : {4.0, 6.0, 7.0, 12.0}) halving.push_back({x, 5.0 * std::pow(0.5, x)});
    CHECK(*fitted_power(power) == Approx(-2.0).epsilon(1e-12));
    CHECK(*fitted_doublings(halving) == Approx(-1.0).epsilon(1e-12));
    CHECK(*fitted_slope(scattered) == Approx(1.4).epsilon(1e-12));  // by hand: 7 / 5
    CHECK_FALSE(fitted_slope(std::vector<CurvePoint>{{2, 1}, {2, 5}}));
    CHECK_FALSE(fitted_power(std::vector<CurvePoint>{{1, 1}, {2, 0}}));
    CHECK_FALSE(fitted_doublings(std::vector<CurvePoint>{{1, 1}, {2, -1}}));
}

TEST_CASE("least, median and quartiles are values by their place in the order") {
    const Spread s = spread_of({5, 1, 4, 2, 3});
    CHECK(s.median == 3.0);
    CHECK(s.low == 2.0);
    CHECK(s.high == 4.0);
    CHECK(s.least == 1.0);
    CHECK(spread_of({7}).high == 7.0);
}

TEST_CASE("frames are timed in turn, the common one first, each as often as it wants") {
    std::string order;
    const auto busy = [&order](char name, double seconds) {
        return [&order, name, seconds] {
            order += name;
            be_busy(seconds);
        };
    };
    const TimingRule thrice{.seconds = 0.0, .least_rounds = 3, .most_rounds = 9, .long_frame = 5.0};
    const TimingRule by_time{
        .seconds = 5.0, .least_rounds = 1, .most_rounds = 2, .long_frame = 5.0};
    const TimingRule long_ones{
        .seconds = 5.0, .least_rounds = 4, .most_rounds = 9, .long_frame = 0.0};
    TimedFrame common(busy('a', 0.009), thrice), slow(busy('s', 0.02), thrice),
        other(busy('o', 0.009), by_time), longer(busy('l', 0.009), long_ones);
    CHECK(order == "asol");  // once each to warm up
    order.clear();
    time_in_turn({&slow, &longer, &other}, common);
    CHECK(order == "asloasloas");
    CHECK(longer.rounds() == 3);
    CHECK(other.rounds() == 2);
    CHECK(common.rounds() == 3);
    CHECK(slow.processor().least >= 0.02);
    CHECK(slow.processor().least <= slow.processor().low);
    CHECK(slow.wall().low <= slow.wall().median);
}

TEST_CASE("a frame of less than some milliseconds is drawn several times a measurement") {
    int drawn = 0;
    const auto draw = [&drawn] {
        ++drawn;
        be_busy(0.003);
    };
    TimedFrame frame(draw, {});
    drawn = 0;
    frame.measure();
    CHECK(drawn == 3);  // 8 ms of frames of 3 ms
    CHECK(frame.processor().median >= 0.003);
    CHECK(frame.processor().median < 0.008);
}
