#pragma once
#include <array>
#include <cmath>

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
    std::array<std::array<Row, 4>, 2> texture;
};

/// True when `m` has an inverse that can be used: its determinant is neither zero nor lost beside
/// the product of its columns' lengths.
bool invertible(const Mat3& m);

/// Inverse transpose of the upper left 3 x 3.
/// @throws Error naming the matrix when it is singular (R18).
Mat3 normal_matrix(const Mat4& modelview);

/// Whether any enabled unit of the pass needs eye-space normals.
bool needs_normals(const PassState& state);

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
    for (std::size_t u = 0; u < 2; ++u)
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

/// The texture coordinates of one unit before its matrix: the vertex's own or generated ones, q
/// = 1.
template <class Arithmetic>
std::array<typename Arithmetic::Word, 4> unit_coords(const VertexConstants<Arithmetic>& c,
                                                     const PassState& state, TexGen texgen,
                                                     const Mesh& mesh, std::size_t i) {
    if (texgen == TexGen::none)
        return words_of<Arithmetic>(mesh.texcoords.empty() ? Vec4{0.0, 0.0, 0.0, 1.0}
                                                           : mesh.texcoords[i]);
    Vector3<Arithmetic> v = eye_normal<Arithmetic>(c, state, mesh, i);
    if (texgen == TexGen::reflection_map) {
        const auto position = words_of<Arithmetic>(Vec4{mesh.positions[i], 1.0});
        v = reflection_map<Arithmetic>(multiply<Arithmetic>(c.modelview, position), v);
    }
    return {v[0], v[1], v[2], Arithmetic::from_double(1.0)};
}

/// The whole vertex stage for vertex i of the mesh.
template <class Arithmetic>
ClipVertex transform_vertex(const VertexConstants<Arithmetic>& c, const PassState& state,
                            const Mesh& mesh, std::size_t i) {
    ClipVertex out;
    const auto position = words_of<Arithmetic>(Vec4{mesh.positions[i], 1.0});
    out.clip = to_vec4<Arithmetic>(multiply<Arithmetic>(c.composite, position));
    out.color = mesh.colors.empty() ? state.color : mesh.colors[i];
    for (std::size_t u = 0; u < 2; ++u) {
        if (!state.units[u]) continue;
        const auto coords = unit_coords<Arithmetic>(c, state, state.units[u]->texgen, mesh, i);
        out.coords[u] = to_vec4<Arithmetic>(multiply<Arithmetic>(c.texture[u], coords));
    }
    return out;
}

/// A window coordinate in snap units, cut toward zero.
constexpr std::int64_t snapped(double x, int fraction_bits) {
    return static_cast<std::int64_t>(x * static_cast<double>(std::int64_t{1} << fraction_bits));
}

/// Division by w and the snap. The vertex lies inside the guard band: |x|, |y| <= 2^15 pixels.
template <NumericModel M>
WindowVertex<M> project(const ClipVertex& v, const Viewport& viewport) {
    using A = typename M::Vertex;
    const auto clip = words_of<A>(v.clip);
    const auto rw = A::clip_reciprocal(clip[3]);
    const auto window = [&](std::size_t k, double offset) {
        return A::to_double(A::sum(A::mul(clip[k], rw), A::from_double(offset)));
    };
    WindowVertex<M> out;
    out.x = snapped(window(0, viewport.offset.x), M::snap.fraction_bits);
    out.y = snapped(window(1, viewport.offset.y), M::snap.fraction_bits);
    out.z = window(2, viewport.offset.z);
    out.inverse_w = static_cast<typename M::Real>(A::to_double(A::emitted_reciprocal(rw)));
    out.color = M::vertex_color(words_of<A>(v.color));
    for (std::size_t u = 0; u < 2; ++u) {
        const auto coords = words_of<A>(v.coords[u]);
        const std::array<std::size_t, 3> stq{0, 1, 3};
        for (std::size_t k = 0; k < 3; ++k)
            out.coords[u][k] =
                static_cast<typename M::Real>(A::to_double(A::mul(coords[stq[k]], rw)));
    }
    return out;
}

}  // namespace twofold
