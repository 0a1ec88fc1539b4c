#pragma once
#include "raster/lane_image.hpp"
#include "raster/level_bounds.hpp"
#include "raster/tile_edges.hpp"
#include "raster/window_mesh.hpp"

/// Triangles of a pass as tiles draw them, and as the vector loops take them.
namespace twofold {

/// A pass with all that its triangles share.
template <NumericModel M>
struct TilePass {
    BoundPass<M> bound;
    const WindowMesh<M>* mesh;
    std::size_t group, member;                  ///< number of its group, and of the pass in it
    std::array<std::size_t, max_units> set_of;  ///< the mesh's coordinate set that a unit reads
    PixelRectangle pixels;
    bool on_lanes, has_levels;
    unsigned bounded_sets, far_q_sets;  ///< what vectors need of its triangles' VertexFlags
    LaneShader<M> shader;
    std::array<double, lanes::lane_units> magnified_reach;  ///< of units that choose levels
    lanes::DepthRule depth;
};

/// One triangle of one pass on its way into one tile.
template <NumericModel M>
struct TileTriangle {
    const TilePass<M>& pass;
    const MeshTriangle& triangle;
    TriangleSetup setup;
    PixelRectangle pixels;  ///< of the picture
    bool certain;           ///< the alpha test is known to pass
};

template <NumericModel M>
const PlacedVertex<M>& corner(const TileTriangle<M>& t, std::size_t k) {
    return t.pass.mesh->vertices[t.triangle.vertex[k]];
}

template <NumericModel M>
const Color<typename M::Channel>& corner_color(const TileTriangle<M>& t, std::size_t k) {
    const WindowMesh<M>& mesh = *t.pass.mesh;
    return mesh.vertices[mesh.flat ? t.triangle.provoking : t.triangle.vertex[k]].color;
}

template <NumericModel M>
bool has_one_color(const TileTriangle<M>& t) {
    const auto& color = corner_color(t, 0);
    return t.pass.mesh->one_color || (color == corner_color(t, 1) && color == corner_color(t, 2));
}

/// Whether binary64 gives the integer quotients of Nv17::iterate_color: 256 times an area over an
/// area below 2^44 is an integer or 2^-44 from one; it is rounded by at most 2^-46.
template <NumericModel M>
bool color_weights_are_exact(const TileTriangle<M>& t) {
    return !M::is_integer || t.setup.doubled_area < std::int64_t{1} << 44 || has_one_color(t);
}

/// Whether vectors give this triangle's fragments the reference's bits: the pass is one they know
/// and no coordinate can overflow, vanish or be divided by 0.
template <NumericModel M>
bool on_lanes(const TileTriangle<M>& t) {
    const VertexFlags& f = t.triangle.flags;
    const unsigned far_q = f.positive_q | f.negative_q;
    return t.pass.on_lanes && f.finite && !(t.pass.bounded_sets & ~unsigned{f.bounded}) &&
           !(t.pass.far_q_sets & ~far_q) && color_weights_are_exact(t);
}

/// The triangle as the vector loops take it: depth.
template <NumericModel M>
void add_depth(const TileTriangle<M>& t, lanes::Triangle& out) {
    out.z0 = corner(t, 0).z;
    out.dz1 = corner(t, 1).z - out.z0;
    out.dz2 = corner(t, 2).z - out.z0;
    out.near_depth_usable = set_near_depth(t.pass.depth, out);
}

/// Whether fragments of a triangle may read other texels of unit u than the base's, magnified.
template <NumericModel M>
bool chooses_level(const TileTriangle<M>& t, std::size_t u,
                   const std::array<const std::array<typename M::Real, 4>*, 3>& coords) {
    const auto& unit = t.pass.shader.unit[u];
    if (unit.levels.empty()) return false;
    if (!unit.divide_by_q) return true;
    const int bits = t.pass.bound.m.snap().fraction_bits;
    const CoordinateSteps steps = coordinate_steps(*t.pass.mesh, t.triangle, t.setup, bits);
    const std::array<double, 2> size{unit.in_texels ? 1.0 : unit.image.width,
                                     unit.in_texels ? 1.0 : unit.image.height};
    return !(squared_scale_bound(steps, coords, size) <= t.pass.magnified_reach[u]);
}

template <NumericModel M>
lanes::Corners<typename M::Real, typename M::Channel> lane_corners(const TileTriangle<M>& t) {
    lanes::Corners<typename M::Real, typename M::Channel> out;
    out.choose_level.fill(false);
    out.over_w = M::coords_over_w;
    const auto& units = t.pass.bound.units;
    for (std::size_t u = 0; u < units.size(); ++u) {
        const auto& coords = t.pass.mesh->coords[t.pass.set_of[units[u].index]];
        for (std::size_t k = 0; k < 3; ++k) out.coords[u][k] = &coords[t.triangle.vertex[k]];
        if (t.pass.has_levels) out.choose_level[u] = chooses_level(t, u, out.coords[u]);
    }
    for (std::size_t k = 0; k < 3; ++k) out.colors[k] = &corner_color(t, k);
    out.one_color = has_one_color(t);
    return out;
}

}  // namespace twofold
