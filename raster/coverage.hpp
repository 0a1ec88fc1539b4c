#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "raster/setup.hpp"

namespace twofold {

/// The first pixel whose centre is not left of `x` (snap units), and so for y.
constexpr std::int64_t first_pixel(std::int64_t x, int fraction_bits) {
    const std::int64_t half = std::int64_t{1} << (fraction_bits - 1);
    return (x - half + (std::int64_t{1} << fraction_bits) - 1) >> fraction_bits;
}

/// The last pixel whose centre is not right of `x`.
constexpr std::int64_t last_pixel(std::int64_t x, int fraction_bits) {
    const std::int64_t half = std::int64_t{1} << (fraction_bits - 1);
    return (x - half) >> fraction_bits;
}

/// Pixels x0 to x1 - 1, y0 to y1 - 1.
struct PixelRectangle {
    std::int64_t x0, y0, x1, y1;
};

/// Calls `visit(x, y, edge values)` for every pixel of the rectangle whose centre the triangle
/// covers, rows from the top, left to right.
template <class Visit>
void for_each_covered_pixel(const TriangleSetup& t, int fraction_bits, const PixelRectangle& target,
                            Visit&& visit) {
    const std::int64_t one = std::int64_t{1} << fraction_bits, half = one / 2;
    const auto x0 = std::max(target.x0, first_pixel(t.low.x, fraction_bits));
    const auto x1 = std::min(target.x1 - 1, last_pixel(t.high.x, fraction_bits));
    const auto y0 = std::max(target.y0, first_pixel(t.low.y, fraction_bits));
    const auto y1 = std::min(target.y1 - 1, last_pixel(t.high.y, fraction_bits));
    for (std::int64_t y = y0; y <= y1; ++y) {
        for (std::int64_t x = x0; x <= x1; ++x) {
            const WindowPoint centre{x * one + half, y * one + half};
            const std::array<std::int64_t, 3> e{t.edge[0].at(centre), t.edge[1].at(centre),
                                                t.edge[2].at(centre)};
            if (t.edge[0].covers(e[0]) && t.edge[1].covers(e[1]) && t.edge[2].covers(e[2]))
                visit(static_cast<int>(x), static_cast<int>(y), e);
        }
    }
}

}  // namespace twofold
