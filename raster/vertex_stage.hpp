#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "raster/lanes.hpp"
#include "raster/vertex_lanes.hpp"
#include "raster/window_mesh.hpp"

/// The vertex stage of the fast pipeline: whole blocks on vectors where the pass allows it, vertex
/// by vertex where not.
namespace twofold {

template <class Arithmetic>
constexpr lanes::VertexArithmetic vertex_arithmetic() {
    if (std::is_same_v<Arithmetic, Nv2xArithmetic>) return lanes::VertexArithmetic::nv2x;
    if (std::is_same_v<Arithmetic, Nv1xArithmetic>) return lanes::VertexArithmetic::nv1x;
    if (std::is_same_v<Arithmetic, IeeeArithmetic<float>>) return lanes::VertexArithmetic::binary32;
    return lanes::VertexArithmetic::binary64;
}

/// A number as the arithmetic holds it: the chips count denormals as zero.
template <class Arithmetic>
double held(double x) {
    const double word = Arithmetic::to_double(Arithmetic::from_double(x));
    const bool chip = std::is_base_of_v<Nv1xArithmetic, Arithmetic>;
    return chip && std::fabs(word) < 0x1p-126 ? 0.0 : word;
}

inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// A mesh's vertices by component, as VertexInput points at them, and what is made of them.
struct VertexColumns {
    std::vector<std::vector<double>> columns;
    lanes::VertexInput input;
    lanes::VertexRule rule;
    bool usable = false;  ///< vectors know what the group asks for
};

/// Adds the column of value(i) for every vertex, and a full vector more; one vector where all have
/// the same.
template <class Arithmetic, class Value>
lanes::VertexSource add_column(VertexColumns& out, std::size_t vertices, Value&& value) {
    auto& column = out.columns.emplace_back(vertices + lanes::widest, 0.0);
    bool constant = true;
    for (std::size_t i = 0; i < vertices; ++i) {
        column[i] = held<Arithmetic>(value(i));
        if (!std::isfinite(column[i])) out.usable = false;
        constant = constant && same_bits(column[i], column[0]);
    }
    if (!constant) return {column.data(), 1};
    const double only = column[0];
    column = std::vector<double>(lanes::widest, only);
    return {column.data(), 0};
}

template <class Arithmetic>
lanes::Rows lane_rows(const std::array<std::array<typename Arithmetic::Word, 4>, 4>& rows) {
    lanes::Rows out;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            out[i][j] = held<Arithmetic>(Arithmetic::to_double(rows[i][j]));
    return out;
}

inline bool is_finite(const lanes::Rows& rows) {
    for (const auto& row : rows)
        for (const double x : row)
            if (!std::isfinite(x)) return false;
    return true;
}

template <class Arithmetic>
lanes::SetRule set_rule(const TexGenState& texgen, const lanes::Rows& matrix) {
    lanes::SetRule rule{texgen.mode, {}, matrix};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec4& plane =
            texgen.mode[k] == TexGen::object_linear ? texgen.object_plane[k] : texgen.eye_plane[k];
        for (int j = 0; j < 4; ++j)
            rule.plane[k][static_cast<std::size_t>(j)] = held<Arithmetic>(plane[j]);
    }
    return rule;
}

template <NumericModel M>
lanes::VertexRule vertex_rule(const M& m, const GroupGeometry<M>& g) {
    using A = typename M::Vertex;
    lanes::VertexRule rule{};
    rule.composite = lane_rows<A>(g.constants.composite);
    rule.modelview = lane_rows<A>(g.constants.modelview);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            rule.normal[i][j] = held<A>(A::to_double(g.constants.normal[i][j]));
    rule.needs_eye = needs_eye_position(g.state);
    rule.needs_normal = needs_normals(g.state);
    rule.normalize = g.state.normalize;
    rule.sets = g.sets;
    for (std::size_t k = 0; k < g.sets; ++k) {
        const TexGenState& texgen = g.state.units[k]->texgen;
        rule.set[k] = set_rule<A>(texgen, lane_rows<A>(g.constants.texture[k]));
        rule.needs_reflection = rule.needs_reflection || uses_reflection(texgen);
    }
    for (int k = 0; k < 3; ++k) {
        rule.offset[static_cast<std::size_t>(k)] = held<A>(g.rules.viewport.offset[k]);
        rule.offset_f64[static_cast<std::size_t>(k)] = g.rules.viewport.offset[k];
    }
    rule.snap = static_cast<double>(std::int64_t{1} << m.snap().fraction_bits);
    rule.perspective = g.rules.perspective;
    rule.over_w = M::coords_over_w && g.rules.perspective;
    rule.width = g.rules.size.width;
    rule.height = g.rules.size.height;
    return rule;
}

/// What of a group vectors do not know in the vertex stage; empty if they know it.
template <NumericModel M>
std::string why_not_on_lanes(const GroupGeometry<M>& g, const lanes::VertexRule& rule) {
    if (g.rules.window_space) return "window_space";
    if (g.state.fog) return "fog";
    if (!is_finite(rule.composite) || !is_finite(rule.modelview))
        return "a matrix that is not finite";
    for (std::size_t k = 0; k < g.sets; ++k) {
        const TexGenState& texgen = g.state.units[k]->texgen;
        if (any_mode(texgen, TexGen::sphere_map, TexGen::sphere_map, TexGen::sphere_map))
            return "sphere_map";
        if (!is_finite(rule.set[k].matrix) || !is_finite(rule.set[k].plane))
            return "a texture matrix or plane that is not finite";
    }
    return {};
}

template <NumericModel M>
void make_columns(const M& m, const GroupGeometry<M>& g, VertexColumns& out) {
    using A = typename M::Vertex;
    out.rule = vertex_rule(m, g);
    out.usable = why_not_on_lanes(g, out.rule).empty();
    if (!out.usable) return;
    const std::size_t n = g.mesh.positions.size();
    for (std::size_t k = 0; k < 4; ++k)
        out.input.position[k] = add_column<A>(
            out, n, [&](std::size_t i) { return position_of(g.mesh, i)[static_cast<int>(k)]; });
    for (std::size_t k = 0; k < 3; ++k)
        out.input.normal[k] = add_column<A>(out, out.rule.needs_normal ? n : 0, [&](std::size_t i) {
            return g.mesh.normals.empty() ? (k == 2 ? 1.0 : 0.0)
                                          : g.mesh.normals[i][static_cast<int>(k)];
        });
    for (std::size_t s = 0; s < g.sets; ++s)
        for (std::size_t k = 0; k < 4; ++k)
            out.input.own[s][k] = add_column<A>(out, n, [&](std::size_t i) {
                return own_coords(g.mesh, g.constants.own[s], i)[static_cast<int>(k)];
            });
}

/// Takes vertex i of the mesh from place k of a transformed block.
template <NumericModel M>
void take_vertex(const GroupGeometry<M>& g, const lanes::VertexOutput& from, std::size_t k,
                 std::size_t i, WindowMesh<M>& out) {
    using Real = typename M::Real;
    PlacedVertex<M>& v = out.vertices[i];
    v.x = from.x[k];
    v.y = from.y[k];
    v.z = from.z[k];
    v.inverse_w = static_cast<Real>(from.inverse_w[k]);
    for (std::size_t s = 0; s < g.sets; ++s)
        for (std::size_t c = 0; c < 4; ++c)
            out.coords[s][i][c] = static_cast<Real>(from.coords[s][c][k]);
    const std::uint64_t bits = from.flags[k];
    const auto four = [bits](int shift) { return static_cast<std::uint8_t>(bits >> shift & 15); };
    out.flags[i] = {four(0), four(4), four(8), (bits >> 12 & 1) != 0};
}

/// Vertices first to first + count - 1 of a mesh whose colours are in place.
template <NumericModel M>
void place_block(const M& m, const GroupGeometry<M>& g, const VertexColumns& columns,
                 std::size_t first, std::size_t count, WindowMesh<M>& out) {
    lanes::VertexOutput block;
    lanes::transform_block(vertex_arithmetic<typename M::Vertex>(), columns.rule, columns.input,
                           first, count, block);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        if (block.wild[k] != 0.0) {
            place_vertex(m, g, i, out);
            continue;
        }
        out.outcodes[i] = static_cast<Outcode>(block.outcode[k]);
        if ((out.outcodes[i] & (outside_planes | unusable_vertex)) == 0)
            take_vertex(g, block, k, i, out);
    }
}

/// Colours do not depend on where a vertex is: once for all frames.
template <NumericModel M>
void color_vertices(const M& m, const GroupGeometry<M>& g, WindowMesh<M>& out) {
    using A = typename M::Vertex;
    resize(out, g.mesh.positions.size(), g.sets);
    const auto& colors = g.mesh.colors;
    out.one_color =
        std::adjacent_find(colors.begin(), colors.end(), std::not_equal_to<>()) == colors.end();
    for (std::size_t i = 0; i < g.mesh.positions.size(); ++i) {
        const Vec4 color = g.mesh.colors.empty() ? g.state.color : g.mesh.colors[i];
        const Vec4 secondary =
            g.mesh.secondary_colors.empty() ? Vec4{0.0} : g.mesh.secondary_colors[i];
        out.vertices[i].color = m.vertex_color(words_of<A>(color));
        out.vertices[i].secondary_color = m.vertex_color(words_of<A>(secondary));
    }
}

/// All vertices of a mesh.
template <NumericModel M>
void place_vertices(const M& m, const GroupGeometry<M>& g, const VertexColumns& columns,
                    int threads, WindowMesh<M>& out) {
    const std::size_t vertices = g.mesh.positions.size();
    resize(out, vertices, g.sets);
    out.outcodes.resize(vertices);
    constexpr std::size_t size = lanes::vertex_block;
    parallel_for((vertices + size - 1) / size, threads, [&](std::size_t b) {
        const std::size_t first = b * size, count = std::min(vertices - first, size);
        if (columns.usable) return place_block(m, g, columns, first, count, out);
        for (std::size_t i = first; i < first + count; ++i) place_vertex(m, g, i, out);
    });
}

}  // namespace twofold
