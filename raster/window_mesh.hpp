#pragma once
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "raster/assemble.hpp"
#include "raster/coverage.hpp"
#include "raster/mesh_triangle.hpp"
#include "raster/pass_group.hpp"
#include "raster/transform.hpp"
#include "raster/vertex_lanes.hpp"
#include "texunit/parallel.hpp"

/// The geometry of a pass group in the window, as the fast pipeline keeps it from the vertex stage
/// to the tiles.
namespace twofold {

/// A vertex in the window without its coordinate sets.
template <NumericModel M>
struct PlacedVertex {
    std::int32_t x, y;  ///< in snap units
    double z;
    typename M::Real inverse_w;
    Color<typename M::Channel> color, secondary_color;
};

template <NumericModel M>
using CoordinateList = std::vector<std::array<typename M::Real, 4>>;

template <NumericModel M>
struct WindowMesh {
    std::vector<PlacedVertex<M>> vertices;  ///< the mesh's, then those that clipping made
    std::array<CoordinateList<M>, max_units> coords;
    std::vector<VertexFlags> flags;
    std::vector<Outcode> outcodes;  ///< of the mesh's vertices
    std::vector<MeshTriangle> triangles;
    bool flat = false;
    bool one_color = false;  ///< all vertices have the same
};

/// A pass group with what its vertices and triangles are made from.
template <NumericModel M>
struct GroupGeometry {
    const Mesh& mesh;
    PassState state;  ///< the first pass's, with the coordinate sets in the places of the units
    WindowRules rules;
    VertexConstants<typename M::Vertex> constants;
    std::vector<AssembledTriangle> assembled;
    std::size_t sets;
};

template <NumericModel M>
GroupGeometry<M> group_geometry(const M& m, const Frame& frame, const PassGroup& group) {
    const Pass& first = frame.passes[group.passes.front()];
    PassState state = normalized(first.state);
    for (auto& unit : state.units) unit.reset();
    for (std::size_t k = 0; k < group.sets.size(); ++k) {
        state.units[k].emplace();
        state.units[k]->texgen = group.sets[k].texgen;
        state.units[k]->matrix = group.sets[k].matrix;
    }
    const WindowRules rules = window_rules(state, {frame.width, frame.height}, m.snap());
    auto constants = vertex_constants<typename M::Vertex>(state, rules.viewport);
    for (std::size_t k = 0; k < group.sets.size(); ++k) constants.own[k] = group.sets[k].unit;
    const Mesh& mesh = frame.meshes[first.mesh];
    return {mesh,
            std::move(state),
            rules,
            std::move(constants),
            assemble(mesh.primitive, mesh.indices, state.provoking_vertex),
            group.sets.size()};
}

using lanes::largest_coordinate;
using lanes::smallest_q;

template <NumericModel M>
VertexFlags flags_of(const PlacedVertex<M>& v,
                     const std::array<std::array<typename M::Real, 4>, max_units>& coords,
                     std::size_t sets) {
    const auto within = [](double x, double limit) { return x >= -limit && x <= limit; };
    VertexFlags flags;
    const auto rw = static_cast<double>(v.inverse_w);
    flags.finite = within(v.z, largest_coordinate) && rw >= smallest_q && rw <= largest_coordinate;
    for (std::size_t k = 0; k < sets; ++k) {
        const auto bit = static_cast<std::uint8_t>(1u << k);
        const auto s = static_cast<double>(coords[k][0]), t = static_cast<double>(coords[k][1]);
        const auto q = static_cast<double>(coords[k][3]);
        if (q >= smallest_q) flags.positive_q |= bit;
        if (q <= -smallest_q) flags.negative_q |= bit;
        const double limit = largest_coordinate;
        if (within(s, limit) && within(t, limit) && within(q, limit)) flags.bounded |= bit;
    }
    return flags;
}

/// Room for so many vertices.
template <NumericModel M>
void resize(WindowMesh<M>& out, std::size_t size, std::size_t sets) {
    out.vertices.resize(size);
    out.flags.resize(size);
    for (std::size_t k = 0; k < sets; ++k) out.coords[k].resize(size);
}

template <NumericModel M>
void put(WindowMesh<M>& out, std::size_t i, const WindowVertex<M>& v, std::size_t sets) {
    out.vertices[i] = {static_cast<std::int32_t>(v.x),
                       static_cast<std::int32_t>(v.y),
                       v.z,
                       v.inverse_w,
                       v.color,
                       v.secondary_color};
    for (std::size_t k = 0; k < sets; ++k) out.coords[k][i] = v.coords[k];
    out.flags[i] = flags_of<M>(out.vertices[i], v.coords, sets);
}

/// The vertex stage for one vertex. One outside a clip plane is not projected: only clip() reads
/// it, and flat triangles its colours.
template <NumericModel M>
void place_vertex(const M& m, const GroupGeometry<M>& g, std::size_t i, WindowMesh<M>& out) {
    const ClipVertex v = transform_vertex<typename M::Vertex>(g.constants, g.state, g.mesh, i);
    const bool perspective = g.rules.perspective;
    if (g.rules.window_space)
        out.outcodes[i] = inside_guard_band(v) ? 0 : unusable_vertex;
    else
        out.outcodes[i] = outcode(v.clip, g.rules.viewport, g.rules.size);
    if ((out.outcodes[i] & (outside_planes | unusable_vertex)) == 0) {
        put(out, i,
            g.rules.window_space ? place(m, v, perspective)
                                 : project(m, v, g.rules.viewport, perspective),
            g.sets);
    } else {
        out.vertices[i].color = m.vertex_color(words_of<typename M::Vertex>(v.color));
        out.vertices[i].secondary_color =
            m.vertex_color(words_of<typename M::Vertex>(v.secondary_color));
    }
}

/// What one block of triangles adds to a mesh. Vertices that clipping made are numbered from
/// `first_new_vertex`.
template <NumericModel M>
struct TriangleBlock {
    WindowMesh<M> made;
    std::vector<MeshTriangle> triangles;
};
inline constexpr std::uint32_t first_new_vertex = 1u << 31;

/// Keeps a triangle if it can cover a pixel.
template <NumericModel M>
void keep_if_visible(const GroupGeometry<M>& g, int bits,
                     const std::array<const PlacedVertex<M>*, 3>& v, MeshTriangle triangle,
                     std::vector<MeshTriangle>& out) {
    const auto [a, b, c] = v;
    const std::int64_t area = doubled_area({a->x, a->y}, {b->x, b->y}, {c->x, c->y});
    if (area == 0 || is_culled(g.rules.cull, area < 0)) return;
    const auto first = [bits](std::int64_t x) {
        return std::max<std::int64_t>(first_pixel(x, bits), 0);
    };
    const auto end = [bits](std::int64_t x, int size) {
        return std::min<std::int64_t>(last_pixel(x, bits) + 1, size);
    };
    const auto x0 = first(std::min({a->x, b->x, c->x})), y0 = first(std::min({a->y, b->y, c->y}));
    const auto x1 = end(std::max({a->x, b->x, c->x}), g.rules.size.width);
    const auto y1 = end(std::max({a->y, b->y, c->y}), g.rules.size.height);
    if (x0 >= x1 || y0 >= y1) return;
    triangle.x0 = static_cast<std::int16_t>(x0);
    triangle.y0 = static_cast<std::int16_t>(y0);
    triangle.x1 = static_cast<std::int16_t>(x1);
    triangle.y1 = static_cast<std::int16_t>(y1);
    out.push_back(triangle);
}

/// A triangle that a clip plane cuts, as a fan of what remains.
template <NumericModel M>
void keep_clipped(const M& m, const GroupGeometry<M>& g, const AssembledTriangle& t,
                  TriangleBlock<M>& block) {
    std::array<ClipVertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] =
            transform_vertex<typename M::Vertex>(g.constants, g.state, g.mesh, t.vertex[k]);
    if (g.rules.flat) {
        const ClipVertex from =
            transform_vertex<typename M::Vertex>(g.constants, g.state, g.mesh, t.provoking);
        for (ClipVertex& v : corners) wear_colors(v, from);
    }
    const ClippedPolygon polygon = clip(corners, g.rules.viewport, g.rules.size);
    const std::size_t first = block.made.vertices.size();
    resize(block.made, first + polygon.size, g.sets);
    for (std::size_t k = 0; k < polygon.size; ++k)
        put(block.made, first + k,
            project(m, polygon.vertices[k], g.rules.viewport, g.rules.perspective), g.sets);
    for (std::size_t k = 2; k < polygon.size; ++k) {
        const std::array<std::size_t, 3> corner{first, first + k - 1, first + k};
        MeshTriangle made{};
        made.flags =
            block.made.flags[corner[0]] & block.made.flags[corner[1]] & block.made.flags[corner[2]];
        for (std::size_t i = 0; i < 3; ++i)
            made.vertex[i] = first_new_vertex + static_cast<std::uint32_t>(corner[i]);
        made.provoking = made.vertex[2];
        const auto& v = block.made.vertices;
        keep_if_visible<M>(g, m.snap().fraction_bits, {&v[corner[0]], &v[corner[1]], &v[corner[2]]},
                           made, block.triangles);
    }
}

template <NumericModel M>
void keep_triangle(const M& m, const GroupGeometry<M>& g, const WindowMesh<M>& mesh,
                   const AssembledTriangle& t, TriangleBlock<M>& block) {
    const auto [a, b, c] = t.vertex;
    const ClipResult result = classify(mesh.outcodes[a], mesh.outcodes[b], mesh.outcodes[c]);
    if (result == ClipResult::cut) keep_clipped(m, g, t, block);
    if (result != ClipResult::inside) return;
    MeshTriangle kept{};
    kept.vertex = t.vertex;
    kept.provoking = t.provoking;
    kept.flags = mesh.flags[a] & mesh.flags[b] & mesh.flags[c];
    keep_if_visible<M>(g, m.snap().fraction_bits,
                       {&mesh.vertices[a], &mesh.vertices[b], &mesh.vertices[c]}, kept,
                       block.triangles);
}

/// Appends a block's vertices and triangles to the mesh.
template <NumericModel M>
void append(WindowMesh<M>& mesh, const TriangleBlock<M>& block, std::size_t sets) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto add = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    add(mesh.vertices, block.made.vertices);
    add(mesh.flags, block.made.flags);
    for (std::size_t k = 0; k < sets; ++k) add(mesh.coords[k], block.made.coords[k]);
    if (block.made.vertices.empty()) return add(mesh.triangles, block.triangles);
    const auto renumbered = [&](std::uint32_t i) {
        return i < first_new_vertex ? i : i - first_new_vertex + first;
    };
    for (MeshTriangle t : block.triangles) {
        for (auto& i : t.vertex) i = renumbered(i);
        t.provoking = renumbered(t.provoking);
        mesh.triangles.push_back(t);
    }
}

/// Clips and sets up the triangles of a mesh whose vertices are placed, in blocks, whose memory is
/// kept.
template <NumericModel M>
void place_triangles(const M& m, const GroupGeometry<M>& g, int threads,
                     std::vector<TriangleBlock<M>>& blocks, WindowMesh<M>& out) {
    constexpr std::size_t block_size = 2048;
    const std::size_t used = (g.assembled.size() + block_size - 1) / block_size;
    if (blocks.size() < used) blocks.resize(used);
    out.triangles.clear();
    out.flat = g.rules.flat;
    parallel_for(used, threads, [&](std::size_t b) {
        const std::size_t end = std::min(g.assembled.size(), (b + 1) * block_size);
        resize(blocks[b].made, 0, g.sets);
        blocks[b].triangles.clear();
        for (std::size_t i = b * block_size; i < end; ++i)
            keep_triangle(m, g, out, g.assembled[i], blocks[b]);
    });
    for (std::size_t b = 0; b < used; ++b) append(out, blocks[b], g.sets);
}

/// A triangle as the reference sees it.
template <NumericModel M>
WindowTriangle<M> window_triangle(const WindowMesh<M>& mesh, const MeshTriangle& t,
                                  const std::array<std::size_t, max_units>& set_of) {
    WindowTriangle<M> result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const PlacedVertex<M>& v = mesh.vertices[t.vertex[k]];
        const PlacedVertex<M>& colored = mesh.vertices[mesh.flat ? t.provoking : t.vertex[k]];
        result[k].x = v.x;
        result[k].y = v.y;
        result[k].z = v.z;
        result[k].inverse_w = v.inverse_w;
        result[k].color = colored.color;
        result[k].secondary_color = colored.secondary_color;
        result[k].secondary_color[3] = v.secondary_color[3];
        for (std::size_t u = 0; u < max_units; ++u)
            if (t.vertex[k] < mesh.coords[set_of[u]].size())
                result[k].coords[u] = mesh.coords[set_of[u]][t.vertex[k]];
    }
    return result;
}

}  // namespace twofold
