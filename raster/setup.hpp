#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

namespace twofold {

/// A point in snap units, y down.
struct WindowPoint {
    std::int64_t x, y;
};

/// E(p) = a p.x + b p.y + c, doubled area of the triangle (edge, p); positive inside. An edge that
/// holds its own points (top or left) counts E = 0 as inside.
struct EdgeFunction {
    std::int64_t a, b, c;
    bool holds_its_points;

    std::int64_t at(WindowPoint p) const { return a * p.x + b * p.y + c; }
    bool covers(std::int64_t value) const { return value >= (holds_its_points ? 0 : 1); }
};

/// Doubled areas opposite each vertex at one pixel centre.
using EdgeValues = std::array<std::int64_t, 3>;

/// Edge functions of a triangle; edge[k] lies opposite vertex k, so its value is that vertex's
/// weight.
struct TriangleSetup {
    std::array<EdgeFunction, 3> edge;
    std::int64_t doubled_area;  ///< > 0 unless the triangle is empty
    bool counter_clockwise;     ///< as seen with y up, i.e. OpenGL's front face
    WindowPoint low, high;      ///< bounding box in snap units, inclusive
};

/// Twice the area of a triangle in snap units squared; negative where the vertices run
/// counter-clockwise as seen with y up.
inline std::int64_t doubled_area(WindowPoint a, WindowPoint b, WindowPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Edge from a to b of a triangle whose doubled area is positive with y down. A top edge runs to
/// the right, a left edge runs up.
inline EdgeFunction edge_from(WindowPoint a, WindowPoint b) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool top = dy == 0 && dx > 0, left = dy < 0;
    return {-dy, dx, dy * a.x - dx * a.y, top || left};
}

/// The edge functions of three snapped vertices in either orientation. All terms are exact:
/// coordinates reach 2^27 in snap units, products 2^56 (R11, R12).
inline TriangleSetup set_up(const std::array<WindowPoint, 3>& p) {
    TriangleSetup t{};
    const std::int64_t area = doubled_area(p[0], p[1], p[2]);
    t.counter_clockwise = area < 0;
    t.doubled_area = area < 0 ? -area : area;
    for (std::size_t k = 0; k < 3; ++k) {
        const WindowPoint &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
        t.edge[k] = area < 0 ? edge_from(b, a) : edge_from(a, b);
    }
    t.low = {std::min({p[0].x, p[1].x, p[2].x}), std::min({p[0].y, p[1].y, p[2].y})};
    t.high = {std::max({p[0].x, p[1].x, p[2].x}), std::max({p[0].y, p[1].y, p[2].y})};
    return t;
}

}  // namespace twofold
