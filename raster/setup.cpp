#include "raster/setup.hpp"

#include <algorithm>

namespace twofold {
namespace {

/// Edge from a to b of a triangle whose doubled area is positive with y down. A top edge runs to
/// the right, a left edge runs up.
EdgeFunction edge_from(WindowPoint a, WindowPoint b) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool top = dy == 0 && dx > 0, left = dy < 0;
    return {-dy, dx, dy * a.x - dx * a.y, top || left};
}

}  // namespace

TriangleSetup set_up(const std::array<WindowPoint, 3>& p) {
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
