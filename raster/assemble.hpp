#pragma once
#include <span>
#include <vector>

#include "raster/clip.hpp"
#include "raster/framebuffer.hpp"
#include "raster/primitive.hpp"
#include "raster/project.hpp"
#include "raster/setup.hpp"

namespace twofold {

template <NumericModel M>
using WindowTriangle = std::array<WindowVertex<M>, 3>;

/// What is the same for every triangle of a pass on its way into the window.
struct WindowRules {
    Viewport viewport;
    PictureSize size;
    CullFace cull;
    bool window_space;
    bool perspective;
    bool flat;
};

inline WindowRules window_rules(const PassState& state, PictureSize size, SnapRule snap) {
    return {state.viewport.value_or(viewport_of(size.width, size.height, snap)),
            size,
            state.cull,
            state.window_space,
            state.perspective_correction,
            state.shade_model == ShadeModel::flat};
}

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

/// Gives a vertex another's colours but leaves it its own fog.
inline void wear_colors(ClipVertex& v, const ClipVertex& from) {
    v.color = from.color;
    v.secondary_color = Vec4{Vec3{from.secondary_color}, v.secondary_color.w};
}

/// The corners of a triangle; under flat shading all of them wear the provoking vertex's colours,
/// but each its own fog.
inline std::array<ClipVertex, 3> corners_of(const AssembledTriangle& t,
                                            std::span<const ClipVertex> vertices, bool flat) {
    std::array<ClipVertex, 3> corners{vertices[t.vertex[0]], vertices[t.vertex[1]],
                                      vertices[t.vertex[2]]};
    if (!flat) return corners;
    for (ClipVertex& v : corners) wear_colors(v, vertices[t.provoking]);
    return corners;
}

/// A triangle whose vertices are window coordinates already: not clipped, dropped outside the guard
/// band.
template <NumericModel M, class Draw>
void draw_placed(const M& m, const std::array<ClipVertex, 3>& v, const WindowRules& rules,
                 DrawCounters& counters, Draw&& draw) {
    const bool drawable =
        inside_guard_band(v[0]) && inside_guard_band(v[1]) && inside_guard_band(v[2]);
    count(drawable ? ClipResult::inside : ClipResult::not_finite, counters);
    if (drawable)
        draw_unless_culled<M>({place(m, v[0], rules.perspective), place(m, v[1], rules.perspective),
                               place(m, v[2], rules.perspective)},
                              rules.cull, counters, draw);
}

/// Clips a triangle, projects what remains and draws it as a fan.
template <NumericModel M, class Draw>
void draw_clipped(const M& m, const std::array<ClipVertex, 3>& v, const WindowRules& rules,
                  DrawCounters& counters, Draw&& draw) {
    const ClippedPolygon polygon = clip(v, rules.viewport, rules.size);
    count(polygon.result, counters);
    const auto corner = [&](std::size_t k) {
        return project(m, polygon.vertices[k], rules.viewport, rules.perspective);
    };
    for (std::size_t k = 2; k < polygon.size; ++k)
        draw_unless_culled<M>({corner(0), corner(k - 1), corner(k)}, rules.cull, counters, draw);
}

/// Brings every triangle into the window and calls `draw(k, triangle, setup)` for what is to be
/// covered, with the number k of the assembled triangle.
template <NumericModel M, class Draw>
void for_each_window_triangle(const M& m, std::span<const ClipVertex> vertices,
                              std::span<const AssembledTriangle> triangles,
                              const WindowRules& rules, DrawCounters& counters, Draw&& draw) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const auto corners = corners_of(triangles[k], vertices, rules.flat);
        const auto drawn = [&](const WindowTriangle<M>& t, const TriangleSetup& s) {
            draw(k, t, s);
        };
        if (rules.window_space)
            draw_placed(m, corners, rules, counters, drawn);
        else
            draw_clipped(m, corners, rules, counters, drawn);
    }
}

}  // namespace twofold
