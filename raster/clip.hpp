#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/vertex.hpp"

namespace twofold {

/// Window coordinates reach this far (pixels) in every direction; 2^15 with up to 12 snap bits
/// keeps edge functions exact in 64 bits.
inline constexpr double guard_band = 32768.0;

/// Vertices beyond this magnitude, in any clip coordinate, make their triangle unusable (R13).
inline constexpr double largest_clip_coordinate = 18446744073709551616.0;  // 2^64

/// Smallest w that is drawn: keeps 1/w and everything divided by it finite. @source chosen
inline constexpr double smallest_w = 1.0 / (1 << 30);

struct PictureSize {
    int width, height;  ///< pixels
};

enum class ClipResult {
    inside,     ///< no plane cuts the triangle
    cut,        ///< the polygon is what remains
    rejected,   ///< all of it lies outside one plane, or nothing remains
    not_finite  ///< a vertex is NaN, infinite or beyond largest_clip_coordinate
};

/// What a vertex lies outside of: one bit for each of the seven clip planes, then one for each side
/// of the window (a pixel further out).
using Outcode = std::uint16_t;
inline constexpr Outcode outside_planes = 0x7f;
inline constexpr Outcode unusable_vertex = 1 << 11;  ///< not finite or too large

Outcode outcode(const Vec4& clip, const Viewport& viewport, PictureSize size);

/// What clip() makes of a triangle whose vertices have these codes, before it cuts.
ClipResult classify(Outcode a, Outcode b, Outcode c);

/// A convex polygon: a triangle cut by seven planes has at most ten corners.
struct ClippedPolygon {
    ClipResult result = ClipResult::rejected;
    std::size_t size = 0;
    std::array<ClipVertex, 10> vertices;
};

/// Clips in homogeneous space, before the division: against depth 0 and 1, w > 0 and the guard band
/// (not the window, whose edges coverage handles exactly). A new vertex is computed from its edge's
/// inside end to its outside end, so two triangles that share the edge get the same vertex (R08).
/// @param size of the picture: a triangle wholly beyond one of its sides is rejected
ClippedPolygon clip(const std::array<ClipVertex, 3>& triangle, const Viewport& viewport,
                    PictureSize size);

/// Whether a vertex in window coordinates can be drawn as it is: finite, within the guard band, w
/// not 0.
bool inside_guard_band(const ClipVertex& window_vertex);

}  // namespace twofold
