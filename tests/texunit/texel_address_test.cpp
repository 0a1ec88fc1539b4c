#include "texunit/texel_address.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

namespace {
using namespace twofold;

constexpr std::array all_wraps{Wrap::repeat, Wrap::clamp, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirrored_repeat};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEMPLATE_TEST_CASE("T02 a coordinate with q = 0 is the farthest texel by its sign, and 0 for 0 / 0",
                   "[hard][T02]", float, double) {
    using Real = TestType;
    const auto at = [](double s, double q) {
        return texel_coordinate(static_cast<Real>(s), static_cast<Real>(q), 64);
    };
    for (const double s : {0.0, -0.0, not_a_number}) {
        CHECK(at(s, 0.0) == 0);
        CHECK(at(s, -0.0) == 0);
    }
    for (const double s : {0.5, infinity}) {
        CHECK(at(s, 0.0) == farthest_texel);
        CHECK(at(s, -0.0) == -farthest_texel);
        CHECK(at(-s, 0.0) == -farthest_texel);
    }
}

TEMPLATE_TEST_CASE("T06 the wrap modes differ at the rim as the text of OpenGL says", "[hard][T06]",
                   float, double) {
    using Real = TestType;
    struct Row {
        Wrap wrap;
        int where;  ///< of s: 0, 1/2N, 1 - 1/2N, 1
        int i0, i1;
        double fraction;
        int nearest;
    };
    constexpr int border = border_before, past = border_behind;
    for (const int n : {1, 2, 4, 64}) {
        const int last = n - 1, second = n > 1 ? 1 : 0;
        const std::vector<Row> rows{
            {Wrap::repeat, 0, last, 0, 0.5, 0},
            {Wrap::repeat, 1, 0, second, 0.0, 0},
            {Wrap::repeat, 2, last, 0, 0.0, last},
            {Wrap::repeat, 3, last, 0, 0.5, 0},
            {Wrap::clamp, 0, border, 0, 0.5, 0},
            {Wrap::clamp, 1, 0, n > 1 ? 1 : past, 0.0, 0},
            {Wrap::clamp, 2, last, past, 0.0, last},
            {Wrap::clamp, 3, last, past, 0.5, last},
            {Wrap::clamp_to_edge, 0, 0, second, 0.0, 0},
            {Wrap::clamp_to_edge, 1, 0, second, 0.0, 0},
            {Wrap::clamp_to_edge, 2, last, last, 0.0, last},
            {Wrap::clamp_to_edge, 3, last, last, 0.0, last},
            {Wrap::clamp_to_border, 0, border, 0, 0.5, 0},
            {Wrap::clamp_to_border, 1, 0, n > 1 ? 1 : past, 0.0, 0},
            {Wrap::clamp_to_border, 2, last, past, 0.0, last},
            {Wrap::clamp_to_border, 3, last, past, 0.5, past},
            {Wrap::mirrored_repeat, 0, 0, second, 0.0, 0},
            {Wrap::mirrored_repeat, 1, 0, second, 0.0, 0},
            {Wrap::mirrored_repeat, 2, last, last, 0.0, last},
            {Wrap::mirrored_repeat, 3, last, last, 0.0, last},
        };
        const std::array<double, 4> us{0.0, 0.5, n - 0.5, 1.0 * n};
        for (const Row& row : rows) {
            CAPTURE(n, static_cast<int>(row.wrap), row.where);
            const auto u = static_cast<Real>(us[static_cast<std::size_t>(row.where)]);
            const auto footprint = linear_footprint(u, n, row.wrap);
            CHECK(footprint.i0 == row.i0);
            CHECK(footprint.i1 == row.i1);
            CHECK(static_cast<double>(footprint.fraction) == row.fraction);
            CHECK(nearest_texel(u, n, row.wrap) == row.nearest);
        }
    }
}

TEST_CASE("T06 only clamp_to_border goes half a texel beyond the image", "[hard][T06]") {
    for (const int n : {1, 2, 4, 64}) {
        const auto edge = linear_footprint(-0.5, n, Wrap::clamp_to_border);
        CHECK(edge.i0 == border_before);
        CHECK(edge.fraction == 0.0);
        CHECK(linear_footprint(-0.5, n, Wrap::clamp).fraction == 0.5);
        CHECK(linear_footprint(n + 0.5, n, Wrap::clamp_to_border).i0 == border_behind);
        CHECK(nearest_texel(-1e-9, n, Wrap::clamp_to_border) == border_before);
        CHECK(nearest_texel(-1e-9, n, Wrap::clamp) == 0);
    }
}

TEMPLATE_TEST_CASE("T09 every coordinate names a texel or the border", "[hard][T09]", float,
                   double) {
    using Real = TestType;
    int outside = 0;
    for (const int n : {1, 2, 3, 64, 1000})
        for (const Wrap wrap : all_wraps)
            for (int k = -4000; k <= 4000; ++k)
                for (const double nudge : {0.0, 1e-7, -1e-7, 1e-20, -1e-20}) {
                    const auto u = static_cast<Real>(k * n * 0.001 + nudge);
                    const auto f = linear_footprint(u, n, wrap);
                    const int i = nearest_texel(u, n, wrap);
                    const bool has_border = wrap == Wrap::clamp || wrap == Wrap::clamp_to_border;
                    const int least = has_border ? border_behind : 0;
                    outside += f.i0 < least || f.i0 >= n || f.i1 < least || f.i1 >= n;
                    outside += i < least || i >= n;
                    outside += !(f.fraction >= Real{0} && f.fraction <= Real{1});
                }
    CHECK(outside == 0);
}

TEMPLATE_TEST_CASE("mirrored_repeat counts texels forwards and backwards in turn", "[sample]",
                   float, double) {
    using Real = TestType;
    for (const int n : {1, 2, 3, 4, 64})
        for (int i = -5 * n; i < 5 * n; ++i) {
            const int turn = (i % (2 * n) + 2 * n) % (2 * n);
            const int expected = turn < n ? turn : 2 * n - 1 - turn;
            const auto centre = static_cast<Real>(i) + Real{0.5};
            CAPTURE(n, i);
            CHECK(nearest_texel(centre, n, Wrap::mirrored_repeat) == expected);
            const auto footprint = linear_footprint(centre, n, Wrap::mirrored_repeat);
            CHECK(footprint.i0 == expected);
            CHECK(footprint.fraction == Real{0});
        }
}

TEMPLATE_TEST_CASE("repeat counts texels again from the first", "[sample]", float, double) {
    using Real = TestType;
    for (const int n : {1, 2, 3, 4, 64})
        for (int i = -5 * n; i < 5 * n; ++i) {
            const auto centre = static_cast<Real>(i) + Real{0.5};
            CHECK(nearest_texel(centre, n, Wrap::repeat) == (i % n + n) % n);
        }
}

TEMPLATE_TEST_CASE("a unit's state says what its coordinates are divided and multiplied by",
                   "[sample]", float, double) {
    using Real = TestType;
    TextureUnitState unit;
    const ProjectiveCoordinates<Real> at{3, 5, 99, 2};
    const auto point = [&] { return texel_point(addressing_of(unit), at, 16, 4); };
    CHECK(point().u == Real{24});
    CHECK(point().v == Real{10});
    unit.divide_by_q = false;
    CHECK(point().u == Real{48});
    CHECK(point().v == Real{20});
    unit.target = TextureTarget::rectangle;
    CHECK(point().u == Real{3});
    CHECK(point().v == Real{5});
    unit.divide_by_q = true;
    CHECK(point().u == Real{1.5});
    CHECK(point().v == Real{2.5});
}
