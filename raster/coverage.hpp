#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "raster/pass.hpp"
#include "raster/setup.hpp"

namespace twofold {

/// The first pixel whose centre is not left of `x` (snap units), and so for y.
constexpr std::int64_t first_pixel(std::int64_t x, int fraction_bits) {
    const std::int64_t half = (std::int64_t{1} << fraction_bits) / 2;
    return (x - half + (std::int64_t{1} << fraction_bits) - 1) >> fraction_bits;
}

/// The last pixel whose centre is not right of `x`.
constexpr std::int64_t last_pixel(std::int64_t x, int fraction_bits) {
    const std::int64_t half = (std::int64_t{1} << fraction_bits) / 2;
    return (x - half) >> fraction_bits;
}

/// Pixels x0 to x1 - 1, y0 to y1 - 1.
struct PixelRectangle {
    std::int64_t x0, y0, x1, y1;
};

/// The pixels of a picture that a pass may change.
inline PixelRectangle drawable_pixels(const PassState& state, int width, int height) {
    if (!state.scissor) return {0, 0, width, height};
    const Scissor& s = *state.scissor;
    return {std::max(0, s.x), std::max(0, s.y),
            std::min<std::int64_t>(width, std::int64_t{s.x} + s.width),
            std::min<std::int64_t>(height, std::int64_t{s.y} + s.height)};
}

/// The part of a rectangle that a triangle's bounding box meets.
inline PixelRectangle covered_rectangle(const TriangleSetup& t, int fraction_bits,
                                        const PixelRectangle& in) {
    return {std::max(in.x0, first_pixel(t.low.x, fraction_bits)),
            std::max(in.y0, first_pixel(t.low.y, fraction_bits)),
            std::min(in.x1, last_pixel(t.high.x, fraction_bits) + 1),
            std::min(in.y1, last_pixel(t.high.y, fraction_bits) + 1)};
}

inline bool inside(const TriangleSetup& t, const EdgeValues& e) {
    return t.edge[0].covers(e[0]) && t.edge[1].covers(e[1]) && t.edge[2].covers(e[2]);
}

/// Calls `visit(x, y, edge values)` for every pixel of the rectangle whose centre the triangle
/// covers, rows from the top, left to right.
template <class Visit>
void for_each_covered_pixel(const TriangleSetup& t, int fraction_bits, const PixelRectangle& target,
                            Visit&& visit) {
    const std::int64_t one = std::int64_t{1} << fraction_bits, half = one / 2;
    const PixelRectangle box = covered_rectangle(t, fraction_bits, target);
    const EdgeValues step{t.edge[0].a * one, t.edge[1].a * one, t.edge[2].a * one};
    for (std::int64_t y = box.y0; y < box.y1; ++y) {
        const WindowPoint first{box.x0 * one + half, y * one + half};
        EdgeValues e{t.edge[0].at(first), t.edge[1].at(first), t.edge[2].at(first)};
        for (std::int64_t x = box.x0; x < box.x1; ++x) {
            if (inside(t, e)) visit(static_cast<int>(x), static_cast<int>(y), e);
            for (std::size_t k = 0; k < 3; ++k) e[k] += step[k];
        }
    }
}

}  // namespace twofold
