#include "raster/setup.hpp"

#include <catch2/catch.hpp>

#include "texunit/random.hpp"

namespace {
using namespace twofold;

WindowPoint random_point(std::uint64_t index, std::int64_t reach) {
    const auto draw = [&](std::uint64_t k) {
        return static_cast<std::int64_t>(random_u64(11, 2 * index + k) %
                                         static_cast<std::uint64_t>(reach));
    };
    const std::int64_t x = draw(0), y = draw(1);
    return {x, y};
}
}  // namespace

TEST_CASE("an edge function is the weight of the vertex that it faces", "[setup]") {
    const std::array<WindowPoint, 3> p{WindowPoint{0, 0}, {160, 16}, {32, 320}};
    const TriangleSetup t = set_up(p);
    CHECK(t.doubled_area == 160 * 320 - 16 * 32);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j)
            CHECK(t.edge[k].at(p[j]) == (j == k ? t.doubled_area : 0));
    CHECK(t.low.x == 0);
    CHECK(t.low.y == 0);
    CHECK(t.high.x == 160);
    CHECK(t.high.y == 320);
}

TEST_CASE("weights sum to the doubled area at every point and in either orientation", "[setup]") {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const auto a = random_point(4 * i, 1 << 27), b = random_point(4 * i + 1, 1 << 27);
        const auto c = random_point(4 * i + 2, 1 << 27), p = random_point(4 * i + 3, 1 << 27);
        const TriangleSetup t = set_up({a, b, c}), mirror = set_up({a, c, b});
        CHECK(t.edge[0].at(p) + t.edge[1].at(p) + t.edge[2].at(p) == t.doubled_area);
        CHECK(mirror.doubled_area == t.doubled_area);
        CHECK(mirror.counter_clockwise != t.counter_clockwise);
        CHECK(mirror.edge[0].at(p) == t.edge[0].at(p));
        CHECK(mirror.edge[1].at(p) == t.edge[2].at(p));
        CHECK(mirror.edge[0].holds_its_points == t.edge[0].holds_its_points);
    }
}

TEST_CASE("front is counter-clockwise as seen with y up", "[setup]") {
    CHECK(set_up({WindowPoint{0, 16}, {16, 16}, {16, 0}}).counter_clockwise);
    CHECK_FALSE(set_up({WindowPoint{0, 16}, {16, 0}, {16, 16}}).counter_clockwise);
}

TEST_CASE("only top and left edges hold their points", "[setup]") {
    const TriangleSetup t = set_up({WindowPoint{0, 0}, {16, 0}, {0, 16}});
    CHECK(t.edge[2].holds_its_points);        // the top edge lies opposite the lower vertex
    CHECK(t.edge[1].holds_its_points);        // left
    CHECK_FALSE(t.edge[0].holds_its_points);  // the slope faces down and right
    const TriangleSetup under = set_up({WindowPoint{16, 16}, {0, 16}, {16, 0}});
    CHECK_FALSE(under.edge[2].holds_its_points);  // bottom
    CHECK_FALSE(under.edge[1].holds_its_points);  // right
    CHECK(under.edge[0].holds_its_points);
}

TEST_CASE("collinear and coinciding points have no area", "[setup]") {
    CHECK(set_up({WindowPoint{0, 0}, {128, 128}, {256, 256}}).doubled_area == 0);
    CHECK(set_up({WindowPoint{5, 7}, {5, 7}, {90, 2}}).doubled_area == 0);
    CHECK(set_up({WindowPoint{5, 7}, {5, 7}, {5, 7}}).doubled_area == 0);
}
