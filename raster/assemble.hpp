#pragma once
#include <span>
#include <vector>

#include "raster/clip.hpp"
#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"
#include "raster/setup.hpp"
#include "raster/transform.hpp"

namespace twofold {

template <NumericModel M>
using WindowTriangle = std::array<WindowVertex<M>, 3>;

inline bool is_culled(CullFace cull, bool front) {
    return cull != CullFace::none && front == (cull == CullFace::front);
}

inline void count(ClipResult result, DrawCounters& counters) {
    ++counters.triangles;
    if (result == ClipResult::not_finite) ++counters.not_finite;
    if (result == ClipResult::rejected) ++counters.rejected;
    if (result == ClipResult::cut) ++counters.clipped;
}

/// Sets one window triangle up and hands it to `draw(triangle, setup)` unless it is empty or faces
/// away.
template <NumericModel M, class Draw>
void draw_unless_culled(const WindowTriangle<M>& triangle, CullFace cull, DrawCounters& counters,
                        Draw&& draw) {
    const TriangleSetup setup = set_up({WindowPoint{triangle[0].x, triangle[0].y},
                                        WindowPoint{triangle[1].x, triangle[1].y},
                                        WindowPoint{triangle[2].x, triangle[2].y}});
    if (setup.doubled_area == 0) {
        ++counters.zero_area;
    } else if (is_culled(cull, setup.counter_clockwise)) {
        ++counters.culled;
    } else {
        ++counters.set_up;
        draw(triangle, setup);
    }
}

/// Primitive assembly: clips each triangle of the index list, projects what remains and draws it as
/// a fan. Calls `draw(k, triangle, setup)` with the number k of the mesh's triangle.
template <NumericModel M, class Draw>
void for_each_window_triangle(std::span<const ClipVertex> vertices,
                              std::span<const std::uint32_t> indices, const Viewport& viewport,
                              CullFace cull, DrawCounters& counters, Draw&& draw) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const ClippedPolygon polygon = clip(
            {vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]}, viewport);
        count(polygon.result, counters);
        for (std::size_t k = 2; k < polygon.size; ++k)
            draw_unless_culled<M>(
                {project<M>(polygon.vertices[0], viewport),
                 project<M>(polygon.vertices[k - 1], viewport),
                 project<M>(polygon.vertices[k], viewport)},
                cull, counters,
                [&](const WindowTriangle<M>& t, const TriangleSetup& s) { draw(i / 3, t, s); });
    }
}

}  // namespace twofold
