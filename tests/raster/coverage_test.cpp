#include "raster/coverage.hpp"

#include <catch2/catch.hpp>
#include <set>

namespace {
using namespace twofold;

std::set<std::pair<int, int>> covered(const std::array<WindowPoint, 3>& p, int bits, int width,
                                      int height) {
    std::set<std::pair<int, int>> pixels;
    for_each_covered_pixel(set_up(p), bits, {0, 0, width, height},
                           [&](int x, int y, const std::array<std::int64_t, 3>&) {
                               pixels.insert({x, y});
                           });
    return pixels;
}
}  // namespace

TEST_CASE("the first and last pixel are those whose centres lie within the box", "[coverage]") {
    for (const int bits : {1, 4, 7}) {
        const std::int64_t one = std::int64_t{1} << bits;
        for (std::int64_t x = -3 * one; x <= 3 * one; ++x) {
            const std::int64_t first = first_pixel(x, bits), last = last_pixel(x, bits);
            CHECK(first * one + one / 2 >= x);
            CHECK((first - 1) * one + one / 2 < x);
            CHECK(last * one + one / 2 <= x);
            CHECK((last + 1) * one + one / 2 > x);
        }
    }
}

TEST_CASE("a triangle covers the pixels whose centres it holds, on the grid of any preset",
          "[coverage]") {
    for (const int bits : {4, 12}) {
        const std::int64_t one = std::int64_t{1} << bits;
        // The slope runs through the centres of the diagonal, which it does not hold.
        CHECK(covered({WindowPoint{0, 0}, {3 * one, 0}, {0, 3 * one}}, bits, 8, 8) ==
              std::set<std::pair<int, int>>{{0, 0}, {1, 0}, {0, 1}});
        // The triangle on the other side holds them, for its slope is a left edge.
        CHECK(covered({WindowPoint{3 * one, 0}, {3 * one, 3 * one}, {0, 3 * one}}, bits, 8, 8)
                  .size() == 6);
    }
}

TEST_CASE("pixels are visited by rows from the top, left to right, within the target",
          "[coverage]") {
    std::vector<int> order;
    for_each_covered_pixel(set_up({WindowPoint{-800, -800}, {8000, -800}, {-800, 8000}}), 4,
                           {0, 0, 5, 3},
                           [&](int x, int y, const auto&) { order.push_back(5 * y + x); });
    REQUIRE(order.size() == 15);
    for (int i = 0; i < 15; ++i) CHECK(order[static_cast<std::size_t>(i)] == i);
}

TEST_CASE("edge values handed out are those at the pixel's centre", "[coverage]") {
    const TriangleSetup t = set_up({WindowPoint{0, 0}, {160, 0}, {0, 160}});
    for_each_covered_pixel(t, 4, {0, 0, 16, 16},
                           [&](int x, int y, const std::array<std::int64_t, 3>& e) {
                               for (std::size_t k = 0; k < 3; ++k)
                                   CHECK(e[k] == t.edge[k].at({16 * x + 8, 16 * y + 8}));
                           });
}

TEST_CASE("a target without pixels is never visited", "[coverage]") {
    CHECK(covered({WindowPoint{0, 0}, {320, 0}, {0, 320}}, 4, 0, 0).empty());
    CHECK(covered({WindowPoint{0, 0}, {320, 0}, {0, 320}}, 4, 0, 9).empty());
}
