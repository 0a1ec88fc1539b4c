#pragma once
#include <array>
#include <cstddef>

#include "texunit/unit_state.hpp"

/// Texture coordinate generation in the vertex stage's arithmetic. Eye space: the eye is at the
/// origin.
namespace twofold {

template <class Arithmetic>
using Vector3 = std::array<typename Arithmetic::Word, 3>;

template <class Arithmetic>
typename Arithmetic::Word dot3(const Vector3<Arithmetic>& a, const Vector3<Arithmetic>& b) {
    return Arithmetic::sum(Arithmetic::mul(a[0], b[0]), Arithmetic::mul(a[1], b[1]),
                           Arithmetic::mul(a[2], b[2]));
}

template <class Arithmetic>
typename Arithmetic::Word dot4(const std::array<typename Arithmetic::Word, 4>& a,
                               const std::array<typename Arithmetic::Word, 4>& b) {
    return Arithmetic::sum(Arithmetic::mul(a[0], b[0]), Arithmetic::mul(a[1], b[1]),
                           Arithmetic::mul(a[2], b[2]), Arithmetic::mul(a[3], b[3]));
}

template <class Arithmetic>
Vector3<Arithmetic> unit(const Vector3<Arithmetic>& v) {
    const auto scale = Arithmetic::reciprocal_sqrt(dot3<Arithmetic>(v, v));
    return {Arithmetic::mul(v[0], scale), Arithmetic::mul(v[1], scale),
            Arithmetic::mul(v[2], scale)};
}

/// What the reflection vector r = n (e.2n) - e is made of: the normal times e.2n, and e, the unit
/// vector from the vertex to the eye. Kept apart because SPHERE_MAP adds (0, 0, 1) before e is
/// taken off.
template <class Arithmetic>
struct ReflectionTerms {
    Vector3<Arithmetic> scaled, to_eye;
};

/// @param eye     vertex in eye space, homogeneous
/// @param normal  eye-space normal, used as it is
template <class Arithmetic>
ReflectionTerms<Arithmetic> reflection_terms(const std::array<typename Arithmetic::Word, 4>& eye,
                                             const Vector3<Arithmetic>& normal) {
    using A = Arithmetic;
    const auto over_w = A::negate(A::reciprocal(eye[3]));
    const Vector3<A> to_eye =
        unit<A>(Vector3<A>{A::mul(eye[0], over_w), A::mul(eye[1], over_w), A::mul(eye[2], over_w)});
    const Vector3<A> twice{A::sum(normal[0], normal[0]), A::sum(normal[1], normal[1]),
                           A::sum(normal[2], normal[2])};
    const auto d = dot3<A>(to_eye, twice);
    return {{A::mul(normal[0], d), A::mul(normal[1], d), A::mul(normal[2], d)}, to_eye};
}

template <class Arithmetic>
Vector3<Arithmetic> reflected(const ReflectionTerms<Arithmetic>& terms) {
    using A = Arithmetic;
    return {A::reflect(terms.scaled[0], terms.to_eye[0], false),
            A::reflect(terms.scaled[1], terms.to_eye[1], false),
            A::reflect(terms.scaled[2], terms.to_eye[2], true)};
}

/// REFLECTION_MAP: r = u - 2 n (n.u) with u the unit vector from the eye to the vertex. Written
/// with e = -u, as the NV1x transform engine does: r = n (e.2n) - e.
/// @param eye     vertex in eye space, homogeneous
/// @param normal  eye-space normal, used as it is
/// @source OpenGL 1.3, 2.10.4
template <class Arithmetic>
Vector3<Arithmetic> reflection_map(const std::array<typename Arithmetic::Word, 4>& eye,
                                   const Vector3<Arithmetic>& normal) {
    return reflected<Arithmetic>(reflection_terms<Arithmetic>(eye, normal));
}

/// SPHERE_MAP: (s, t) = (r_x, r_y) / m + 1/2 with m = 2 |r + (0, 0, 1)|, as the NV1x transform
/// engine does it: h = r + (0, 0, 1), then h/2 x 1/|h| + 1/2. The third coordinate is r_z, which
/// OpenGL leaves out and the chips supply (measured on NV2A). For r = (0, 0, -1) the point is
/// undefined.
/// @source OpenGL 1.3, 2.10.4; public NV1x model of envytools
template <class Arithmetic>
Vector3<Arithmetic> sphere_map(const ReflectionTerms<Arithmetic>& terms) {
    using A = Arithmetic;
    const auto half = A::from_double(0.5);
    const auto [x, y, z] = terms.scaled;
    const auto [ex, ey, ez] = terms.to_eye;
    const Vector3<A> h{A::sum(x, A::negate(ex)), A::sum(y, A::negate(ey)),
                       A::sum(A::sum(z, A::from_double(1.0)), A::negate(ez))};
    const auto over_length = A::reciprocal_sqrt(dot3<A>(h, h));
    return {A::sum(A::mul(A::mul(h[0], half), over_length), half),
            A::sum(A::mul(A::mul(h[1], half), over_length), half), A::reflect(z, ez, true)};
}

/// A vertex as texture coordinate generation sees it.
template <class Arithmetic>
struct TexGenInput {
    std::array<typename Arithmetic::Word, 4> own;     ///< current texture coordinates s, t, r, q
    std::array<typename Arithmetic::Word, 4> object;  ///< position in object space
    std::array<typename Arithmetic::Word, 4> eye;     ///< position in eye space
    Vector3<Arithmetic> normal;                       ///< in eye space
};

/// OBJECT_LINEAR and EYE_LINEAR: the plane's four coefficients times the position's.
template <class Arithmetic>
typename Arithmetic::Word linear_coordinate(
    const Vec4& plane, const std::array<typename Arithmetic::Word, 4>& position) {
    using A = Arithmetic;
    return dot4<A>({A::from_double(plane.x), A::from_double(plane.y), A::from_double(plane.z),
                    A::from_double(plane.w)},
                   position);
}

/// The vectors that two of the modes read their coordinates from.
template <class Arithmetic>
struct TexGenVectors {
    Vector3<Arithmetic> sphere{}, reflection{};
};

template <class Arithmetic>
TexGenVectors<Arithmetic> texgen_vectors(const TexGenState& state,
                                         const TexGenInput<Arithmetic>& vertex) {
    if (!uses_reflection(state)) return {};
    const auto terms = reflection_terms<Arithmetic>(vertex.eye, vertex.normal);
    TexGenVectors<Arithmetic> vectors{{}, reflected<Arithmetic>(terms)};
    if (any_mode(state, TexGen::sphere_map, TexGen::sphere_map, TexGen::sphere_map))
        vectors.sphere = sphere_map<Arithmetic>(terms);
    return vectors;
}

/// Coordinate i of s, t, r, q. The modes that give a vector have no fourth component: OpenGL does
/// not allow them for q, which stays the vertex's own.
template <class Arithmetic>
typename Arithmetic::Word generated_coordinate(const TexGenState& state, std::size_t i,
                                               const TexGenInput<Arithmetic>& vertex,
                                               const TexGenVectors<Arithmetic>& vectors) {
    const auto component = [&](const Vector3<Arithmetic>& v) {
        return i < 3 ? v[i] : vertex.own[3];
    };
    switch (state.mode[i]) {
        case TexGen::object_linear:
            return linear_coordinate<Arithmetic>(state.object_plane[i], vertex.object);
        case TexGen::eye_linear:
            return linear_coordinate<Arithmetic>(state.eye_plane[i], vertex.eye);
        case TexGen::sphere_map:
            return component(vectors.sphere);
        case TexGen::normal_map:
            return component(vertex.normal);
        case TexGen::reflection_map:
            return component(vectors.reflection);
        case TexGen::none:
            break;
    }
    return vertex.own[i];
}

/// The texture coordinates s, t, r, q of a vertex before the texture matrix. The reflection vector
/// is computed only if a coordinate asks for it; eye position and normal are read only as
/// uses_eye_position() and uses_normal() say.
/// @param own     the vertex's current texture coordinates
/// @param object  its position in object space
/// @param eye     its position in eye space
/// @param normal  its normal in eye space, used as it is
/// @source OpenGL 1.3, 2.10.4
template <class Arithmetic>
std::array<typename Arithmetic::Word, 4> generate(
    const TexGenState& state, const std::array<typename Arithmetic::Word, 4>& own,
    const std::array<typename Arithmetic::Word, 4>& object,
    const std::array<typename Arithmetic::Word, 4>& eye, const Vector3<Arithmetic>& normal) {
    const TexGenInput<Arithmetic> vertex{own, object, eye, normal};
    const auto vectors = texgen_vectors<Arithmetic>(state, vertex);
    return {generated_coordinate(state, 0, vertex, vectors),
            generated_coordinate(state, 1, vertex, vectors),
            generated_coordinate(state, 2, vertex, vectors),
            generated_coordinate(state, 3, vertex, vectors)};
}

}  // namespace twofold
