#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "raster/pass.hpp"
#include "raster/vertex.hpp"
#include "texunit/error.hpp"
#include "texunit/texgen.hpp"

/// Vertex stage: object space to clip space, and the texture coordinates of each enabled unit. The
/// order of work is that of the NV1x transform engine for every preset; the arithmetic is the
/// preset's.
namespace twofold {

/// The matrices of one pass in the preset's words, row by row.
template <class Arithmetic>
struct VertexConstants {
    using Word = typename Arithmetic::Word;
    using Row = std::array<Word, 4>;

    std::array<Row, 4> composite;  ///< viewport scale x projection x modelview
    std::array<Row, 4> modelview;
    std::array<std::array<Word, 3>, 3> normal;  ///< inverse transpose of the modelview
    std::array<std::array<Row, 4>, max_units> texture;
    /// The unit of the mesh whose own coordinates unit u starts from.
    std::array<std::size_t, max_units> own{0, 1, 2, 3};
};

/// True when `m` has an inverse that can be used: its determinant is neither zero nor lost beside
/// the product of its columns' lengths.
bool invertible(const Mat3& m);

/// Inverse transpose of the upper left 3 x 3.
/// @throws Error naming the matrix when it is singular (R18).
Mat3 normal_matrix(const Mat4& modelview);

/// Whether any enabled unit of the pass needs eye-space normals.
bool needs_normals(const PassState& state);

/// Whether a unit's coordinates or the fog need the vertex in eye space.
bool needs_eye_position(const PassState& state);

/// The fog factor f at an eye-space position, 0 all fog to 1 none, by the distance |z / w|.
/// @source OpenGL 1.3, 3.10, equations 3.24 to 3.26
double fog_factor(const Fog& fog, const Vec4& eye);

inline Vec4 position_of(const Mesh& mesh, std::size_t i) {
    return Vec4{mesh.positions[i], mesh.position_w.empty() ? 1.0 : mesh.position_w[i]};
}

template <class Arithmetic>
std::array<std::array<typename Arithmetic::Word, 4>, 4> rows_of(const Mat4& m) {
    std::array<std::array<typename Arithmetic::Word, 4>, 4> rows;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                Arithmetic::from_double(m[j][i]);
    return rows;
}

template <class Arithmetic>
VertexConstants<Arithmetic> vertex_constants(const PassState& state, const Viewport& viewport) {
    VertexConstants<Arithmetic> c{};
    Mat4 scale{1.0};
    for (int i = 0; i < 3; ++i) scale[i][i] = viewport.scale[i];
    c.composite = rows_of<Arithmetic>(scale * state.projection * state.modelview);
    c.modelview = rows_of<Arithmetic>(state.modelview);
    if (needs_normals(state)) {
        const Mat3 normal = normal_matrix(state.modelview);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                c.normal[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                    Arithmetic::from_double(normal[j][i]);
    }
    for (std::size_t u = 0; u < max_units; ++u)
        if (state.units[u]) c.texture[u] = rows_of<Arithmetic>(state.units[u]->matrix);
    return c;
}

/// Four dot products: the matrix with these rows times the vector.
template <class Arithmetic>
std::array<typename Arithmetic::Word, 4> multiply(
    const std::array<std::array<typename Arithmetic::Word, 4>, 4>& rows,
    const std::array<typename Arithmetic::Word, 4>& v) {
    return {dot4<Arithmetic>(rows[0], v), dot4<Arithmetic>(rows[1], v),
            dot4<Arithmetic>(rows[2], v), dot4<Arithmetic>(rows[3], v)};
}

template <class Arithmetic>
std::array<typename Arithmetic::Word, 4> words_of(const Vec4& v) {
    return {Arithmetic::from_double(v.x), Arithmetic::from_double(v.y),
            Arithmetic::from_double(v.z), Arithmetic::from_double(v.w)};
}

template <class Arithmetic>
Vec4 to_vec4(const std::array<typename Arithmetic::Word, 4>& w) {
    return {Arithmetic::to_double(w[0]), Arithmetic::to_double(w[1]), Arithmetic::to_double(w[2]),
            Arithmetic::to_double(w[3])};
}

/// Eye-space normal of vertex i, unit length only if NORMALIZE is on.
template <class Arithmetic>
Vector3<Arithmetic> eye_normal(const VertexConstants<Arithmetic>& c, const PassState& state,
                               const Mesh& mesh, std::size_t i) {
    const Vec3 n = mesh.normals.empty() ? Vec3{0.0, 0.0, 1.0} : mesh.normals[i];
    const Vector3<Arithmetic> object{Arithmetic::from_double(n.x), Arithmetic::from_double(n.y),
                                     Arithmetic::from_double(n.z)};
    const Vector3<Arithmetic> eye{dot3<Arithmetic>(c.normal[0], object),
                                  dot3<Arithmetic>(c.normal[1], object),
                                  dot3<Arithmetic>(c.normal[2], object)};
    return state.normalize ? unit<Arithmetic>(eye) : eye;
}

/// The vertex's own coordinates for a unit: the unit's set, or that of unit 0, or (0, 0, 0, 1).
inline Vec4 own_coords(const Mesh& mesh, std::size_t unit, std::size_t i) {
    for (const auto* set : {&mesh.texcoords[unit], &mesh.texcoords[0]})
        if (!set->empty()) return (*set)[i];
    return Vec4{0.0, 0.0, 0.0, 1.0};
}

/// What the vertex stage knows of a vertex before texture coordinates are made.
template <class Arithmetic>
struct EyeVertex {
    std::array<typename Arithmetic::Word, 4> object, eye;
    Vector3<Arithmetic> normal;
};

template <class Arithmetic>
EyeVertex<Arithmetic> eye_vertex(const VertexConstants<Arithmetic>& c, const PassState& state,
                                 const Mesh& mesh, std::size_t i) {
    EyeVertex<Arithmetic> v{};
    v.object = words_of<Arithmetic>(position_of(mesh, i));
    if (needs_eye_position(state)) v.eye = multiply<Arithmetic>(c.modelview, v.object);
    if (needs_normals(state)) v.normal = eye_normal<Arithmetic>(c, state, mesh, i);
    return v;
}

/// The texture coordinates of every enabled unit behind its matrix.
template <class Arithmetic>
void transform_coords(const VertexConstants<Arithmetic>& c, const PassState& state,
                      const Mesh& mesh, std::size_t i, const EyeVertex<Arithmetic>& v,
                      ClipVertex& out) {
    for (std::size_t u = 0; u < max_units; ++u) {
        if (!state.units[u]) continue;
        const auto own = words_of<Arithmetic>(own_coords(mesh, c.own[u], i));
        const auto made =
            generate<Arithmetic>(state.units[u]->texgen, own, v.object, v.eye, v.normal);
        out.coords[u] = to_vec4<Arithmetic>(multiply<Arithmetic>(c.texture[u], made));
    }
}

/// The whole vertex stage for vertex i of the mesh. Window-space positions are passed on as they
/// are.
template <class Arithmetic>
ClipVertex transform_vertex(const VertexConstants<Arithmetic>& c, const PassState& state,
                            const Mesh& mesh, std::size_t i) {
    ClipVertex out{};
    const EyeVertex<Arithmetic> v = eye_vertex<Arithmetic>(c, state, mesh, i);
    out.clip = state.window_space
                   ? position_of(mesh, i)
                   : to_vec4<Arithmetic>(multiply<Arithmetic>(c.composite, v.object));
    out.color = mesh.colors.empty() ? state.color : mesh.colors[i];
    if (!mesh.secondary_colors.empty()) out.secondary_color = mesh.secondary_colors[i];
    if (state.fog) out.secondary_color.w = fog_factor(*state.fog, to_vec4<Arithmetic>(v.eye));
    transform_coords<Arithmetic>(c, state, mesh, i, v, out);
    return out;
}

template <class Arithmetic>
std::vector<ClipVertex> transform_mesh(const PassState& state, const Mesh& mesh,
                                       const Viewport& viewport) {
    const auto constants = vertex_constants<Arithmetic>(state, viewport);
    std::vector<ClipVertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back(transform_vertex<Arithmetic>(constants, state, mesh, i));
    return vertices;
}

}  // namespace twofold
