#include "raster/clip.hpp"

namespace twofold {
namespace {

/// Signed distances of a vertex from the seven planes; inside is >= 0. The plane of w comes first:
/// behind it all w are positive.
std::array<double, 7> distances(const Vec4& c, const Viewport& view) {
    const double x = c.x + view.offset.x * c.w, y = c.y + view.offset.y * c.w;
    const double z = c.z + view.offset.z * c.w;
    return {c.w - smallest_w,
            z,
            c.w - z,
            guard_band * c.w + x,
            guard_band * c.w - x,
            guard_band * c.w + y,
            guard_band * c.w - y};
}

/// Signed distances from the window's four sides, one pixel outside them: a triangle beyond one
/// side is not worth setting up. Sides only reject; coverage cuts at the window's edge exactly.
std::array<double, 4> side_distances(const Vec4& c, const Viewport& view, PictureSize size) {
    const double x = c.x + view.offset.x * c.w, y = c.y + view.offset.y * c.w;
    return {c.w + x, (size.width + 1.0) * c.w - x, c.w + y, (size.height + 1.0) * c.w - y};
}

bool usable(const Vec4& c) {
    for (int k = 0; k < 4; ++k)
        if (!(c[k] >= -largest_clip_coordinate && c[k] <= largest_clip_coordinate)) return false;
    return true;
}

/// `c`, which rounding left beside the plane it was cut at, moved onto that plane: w is never 0 or
/// less and x / w, y / w, z / w keep within their bounds even where ends lie 2^64 apart.
Vec4 on_plane(Vec4 c, std::size_t plane, const Viewport& view) {
    switch (plane) {
        case 0:
            c.w = smallest_w;
            break;
        case 1:
        case 2:
            c.z = ((plane == 1 ? 0.0 : 1.0) - view.offset.z) * c.w;
            break;
        case 3:
        case 4:
            c.x = ((plane == 3 ? -guard_band : guard_band) - view.offset.x) * c.w;
            break;
        default:
            c.y = ((plane == 5 ? -guard_band : guard_band) - view.offset.y) * c.w;
    }
    return c;
}

/// The point where an edge meets a plane, from the distances of its ends. The place is a sum of
/// weighted ends, which is accurate beside the larger of the two however far apart they are;
/// attributes are an offset from the inside end, so that a constant stays exact.
ClipVertex between(const ClipVertex& inside, const ClipVertex& outside, double inside_distance,
                   double outside_distance) {
    const double span = inside_distance - outside_distance;
    const double t = inside_distance / span;
    ClipVertex v;
    v.clip = (-outside_distance / span) * inside.clip + t * outside.clip;
    v.color = inside.color + t * (outside.color - inside.color);
    v.secondary_color =
        inside.secondary_color + t * (outside.secondary_color - inside.secondary_color);
    for (std::size_t u = 0; u < max_units; ++u)
        v.coords[u] = inside.coords[u] + t * (outside.coords[u] - inside.coords[u]);
    return v;
}

/// Rounding can make the outline of a sliver cross a plane more than twice; corners that the array
/// has no room for are left out.
void append(ClippedPolygon& polygon, const ClipVertex& v) {
    if (polygon.size < polygon.vertices.size()) polygon.vertices[polygon.size++] = v;
}

/// Sutherland and Hodgman's step: the part of the polygon inside one plane.
ClippedPolygon cut(const ClippedPolygon& in, std::size_t plane, const Viewport& view) {
    ClippedPolygon out;
    for (std::size_t i = 0; i < in.size; ++i) {
        const ClipVertex& a = in.vertices[i];
        const ClipVertex& b = in.vertices[(i + 1) % in.size];
        const double da = distances(a.clip, view)[plane], db = distances(b.clip, view)[plane];
        if (da >= 0.0) append(out, a);
        if ((da >= 0.0) == (db >= 0.0)) continue;
        ClipVertex v = da >= 0.0 ? between(a, b, da, db) : between(b, a, db, da);
        v.clip = on_plane(v.clip, plane, view);
        append(out, v);
    }
    return out;
}

}  // namespace

bool inside_guard_band(const ClipVertex& v) {
    const auto bounded = [](double x) { return x >= -guard_band && x <= guard_band; };
    return bounded(v.clip.x) && bounded(v.clip.y) && usable(v.clip) && v.clip.w != 0.0;
}

Outcode outcode(const Vec4& c, const Viewport& view, PictureSize size) {
    if (!usable(c)) return unusable_vertex;
    Outcode code = 0;
    const auto planes = distances(c, view);
    for (std::size_t k = 0; k < planes.size(); ++k)
        if (planes[k] < 0.0) code |= static_cast<Outcode>(1u << k);
    const auto sides = side_distances(c, view, size);
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (sides[k] < 0.0) code |= static_cast<Outcode>(1u << (planes.size() + k));
    return code;
}

ClipResult classify(Outcode a, Outcode b, Outcode c) {
    const auto any = static_cast<Outcode>(a | b | c), all = static_cast<Outcode>(a & b & c);
    if (any & unusable_vertex) return ClipResult::not_finite;
    if (all != 0) return ClipResult::rejected;
    return (any & outside_planes) != 0 ? ClipResult::cut : ClipResult::inside;
}

ClippedPolygon clip(const std::array<ClipVertex, 3>& triangle, const Viewport& view,
                    PictureSize size) {
    ClippedPolygon polygon{ClipResult::inside, 3, {triangle[0], triangle[1], triangle[2]}};
    const auto code = [&](std::size_t k) { return outcode(triangle[k].clip, view, size); };
    polygon.result = classify(code(0), code(1), code(2));
    if (polygon.result == ClipResult::inside) return polygon;
    if (polygon.result != ClipResult::cut) return {polygon.result, 0, {}};
    for (std::size_t plane = 0; plane < 7; ++plane) {
        if (polygon.size < 3) return {ClipResult::rejected, 0, {}};
        polygon = cut(polygon, plane, view);
    }
    polygon.result = polygon.size < 3 ? ClipResult::rejected : ClipResult::cut;
    return polygon;
}

}  // namespace twofold
