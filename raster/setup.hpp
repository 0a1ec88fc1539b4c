#pragma once
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
    bool covers(std::int64_t value) const { return value > 0 || (value == 0 && holds_its_points); }
};

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

/// The edge functions of three snapped vertices in either orientation. All terms are exact:
/// coordinates reach 2^27 in snap units, products 2^56 (R11, R12).
TriangleSetup set_up(const std::array<WindowPoint, 3>& p);

}  // namespace twofold
