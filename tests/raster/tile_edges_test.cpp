#include "raster/tile_edges.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/raster/random/dice.hpp"

using namespace twofold;

namespace {

/// A triangle about a tile of 128 pixels, in snap units; some reach far beyond.
std::array<WindowPoint, 3> random_triangle(test::Dice& dice, int bits) {
    const std::int64_t reach = std::int64_t{1} << (bits + 5 + dice.integer(0, 5));
    std::array<WindowPoint, 3> p;
    for (WindowPoint& v : p)
        v = {static_cast<std::int64_t>(dice.index(static_cast<std::size_t>(reach))) - reach / 4,
             static_cast<std::int64_t>(dice.index(static_cast<std::size_t>(reach))) - reach / 4};
    return p;
}

bool covered(const TileEdges& edges, std::int64_t x, std::int64_t y) {
    for (const lanes::CoverEdge& e : edges.triangle.cover)
        if (e.first + e.dx * x + e.dy * y < 0) return false;
    return true;
}

}  // namespace

TEST_CASE("The edges in a tile cover the pixels that the edge functions cover", "[raster]") {
    test::Dice dice(41, 0);
    int usable = 0, covering = 0;
    for (int k = 0; k < 600; ++k) {
        const int bits = std::array{4, 8, 12}[static_cast<std::size_t>(k % 3)];
        const TriangleSetup setup = set_up(random_triangle(dice, bits));
        const PixelRectangle pixels = covered_rectangle(setup, bits, {0, 0, 128, 128});
        if (setup.doubled_area == 0 || pixels.x0 >= pixels.x1 || pixels.y0 >= pixels.y1) continue;
        const TileEdges edges = edges_in_tile(setup, pixels, bits);
        int expected = 0, wrong = 0;
        std::vector<char> inside(128 * 128, 0);
        for_each_covered_pixel(setup, bits, pixels, [&](int x, int y, const auto& e) {
            ++expected;
            inside[static_cast<std::size_t>(y * 128 + x)] = 1;
            for (std::size_t i = 0; i < 3; ++i) {
                const lanes::Plane& p = edges.triangle.e[i];
                const double value = p.first + static_cast<double>(x - pixels.x0) * p.dx +
                                     static_cast<double>(y - pixels.y0) * p.dy;
                wrong += edges.usable && value != static_cast<double>(e[i]);
            }
        });
        if (edges.none_covered) CHECK(expected == 0);
        if (!edges.usable || edges.none_covered) continue;
        ++usable;
        covering += expected > 0;
        for (auto y = pixels.y0; y < pixels.y1; ++y)
            for (auto x = pixels.x0; x < pixels.x1; ++x)
                wrong += covered(edges, x - pixels.x0, y - pixels.y0) !=
                         (inside[static_cast<std::size_t>(y * 128 + x)] != 0);
        CHECK(wrong == 0);
    }
    CHECK(usable > 300);
    CHECK(covering > 250);
}

TEST_CASE("An edge that has all pixels of a tile on its inner side takes no part in coverage",
          "[raster]") {
    const TriangleSetup setup =
        set_up({WindowPoint{-16000, -16000}, {32000, -16000}, {-16000, 32000}});
    const TileEdges edges = edges_in_tile(setup, {0, 0, 128, 128}, 4);
    CHECK(edges.usable);
    for (const lanes::CoverEdge& e : edges.triangle.cover) {
        CHECK(e.first == 0);
        CHECK(e.dx == 0);
        CHECK(e.dy == 0);
    }
}

TEST_CASE("An edge that 31 bits do not hold makes a triangle unusable only where it cuts the tile",
          "[raster]") {
    // On the grid of 1/4096 pixel an edge of 2^13 pixels steps by 2^25 from pixel to pixel.
    const std::int64_t far = std::int64_t{1} << 24;
    const TriangleSetup setup = set_up({WindowPoint{-far, -far}, {far, far}, {-far, far}});
    CHECK_FALSE(edges_in_tile(setup, {0, 0, 128, 128}, 12).usable);
    CHECK(edges_in_tile(setup, {0, 512, 128, 640}, 12).usable);
}

TEST_CASE("A depth plane that calls itself usable is within 2^-20 of a step of the quotient",
          "[raster]") {
    test::Dice dice(42, 0);
    lanes::DepthRule rule;
    rule.steps = 0xffffff;
    double worst = 0.0;
    int usable = 0;
    for (int k = 0; k < 300; ++k) {
        const TriangleSetup setup = set_up(random_triangle(dice, 4));
        const PixelRectangle pixels = covered_rectangle(setup, 4, {0, 0, 128, 128});
        if (setup.doubled_area == 0 || pixels.x0 >= pixels.x1 || pixels.y0 >= pixels.y1) continue;
        const TileEdges edges = edges_in_tile(setup, pixels, 4);
        lanes::Triangle t{};
        t.e = edges.triangle.e;
        t.area = static_cast<double>(setup.doubled_area);
        t.x1 = static_cast<int>(pixels.x1 - pixels.x0);
        t.y1 = static_cast<int>(pixels.y1 - pixels.y0);
        t.z0 = dice.unit();
        t.dz1 = dice.unit() - t.z0;
        t.dz2 = dice.unit() - t.z0;
        if (!set_near_depth(rule, t)) continue;
        ++usable;
        for_each_covered_pixel(setup, 4, pixels, [&](int x, int y, const auto& e) {
            const long double quotient =
                (static_cast<long double>(e[1]) * t.dz1 + static_cast<long double>(e[2]) * t.dz2) /
                static_cast<long double>(t.area);
            const long double exact = (t.z0 + quotient) * rule.steps;
            const lanes::Plane& p = t.near_depth;
            const double near = p.first + static_cast<double>(x - pixels.x0) * p.dx +
                                static_cast<double>(y - pixels.y0) * p.dy;
            worst = std::max(worst, std::fabs(static_cast<double>(near - exact)));
        });
    }
    CHECK(usable > 100);
    CHECK(worst < 0x1p-20);
    CHECK(worst > 0.0);
}

TEST_CASE("Where all corners have one depth its plane is never in doubt", "[raster]") {
    lanes::DepthRule rule;
    rule.steps = 0xffffff;
    rule.half = 0.5;
    for (const double z : {0.0, 0.25, 0.5, 1.0}) {
        lanes::Triangle t{};
        t.z0 = z;
        t.area = 1.0;
        CHECK(set_near_depth(rule, t));
        CHECK(t.near_depth.first == std::floor(z * 0xffffff + 0.5) + 0.5);
        CHECK(t.near_depth.dx == 0.0);
        CHECK(t.near_depth.dy == 0.0);
    }
    lanes::Triangle outside{};
    outside.z0 = 1.5;
    CHECK_FALSE(set_near_depth(rule, outside));
}
