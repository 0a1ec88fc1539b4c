#include "study/outline.hpp"

namespace twofold {
namespace {

const SurfacePoint* point_at(const VisibleSurface& surface, std::size_t pixel) {
    const std::int32_t index = surface.point_of_pixel[pixel];
    return index < 0 ? nullptr : &surface.points[static_cast<std::size_t>(index)];
}

Vec3 corner(const Frame& frame, const SurfacePoint& p, std::size_t k) {
    const Mesh& mesh = frame.meshes[frame.passes[p.pass].mesh];
    return mesh.positions[p.vertex[k]];
}

/// Corners are compared by place: a seam of normals or texture coordinates has two vertices at one
/// place.
bool share_a_corner(const Frame& frame, const SurfacePoint& a, const SurfacePoint& b) {
    if (a.pass != b.pass) return false;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (corner(frame, a, i) == corner(frame, b, j)) return true;
    return false;
}

}  // namespace

std::vector<bool> outline_pixels(const Frame& frame, const VisibleSurface& fine, SnapRule snap) {
    const VisibleSurface snapped = visible_surface(frame, snap);
    std::vector<bool> outline(fine.point_of_pixel.size(), false);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const SurfacePoint *a = point_at(fine, i), *b = point_at(snapped, i);
        const bool same = a && b ? share_a_corner(frame, *a, *b) : a == b;
        outline[i] = !same;
    }
    return outline;
}

ByteImage without_outline(ByteImage picture, const std::vector<bool>& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (outline[i]) picture.pixels[i].a = 0;
    return picture;
}

}  // namespace twofold
