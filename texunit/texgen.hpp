#pragma once
#include <array>

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

/// REFLECTION_MAP: r = u - 2 n (n.u) with u the unit vector from the eye to the vertex. Written
/// with e = -u, as the NV1x transform engine does: r = n (e.2n) - e.
/// @param eye     vertex in eye space, homogeneous
/// @param normal  eye-space normal, used as it is
/// @source OpenGL 1.3, 2.10.4
template <class Arithmetic>
Vector3<Arithmetic> reflection_map(const std::array<typename Arithmetic::Word, 4>& eye,
                                   const Vector3<Arithmetic>& normal) {
    using A = Arithmetic;
    const auto over_w = A::negate(A::reciprocal(eye[3]));
    const Vector3<A> to_eye =
        unit<A>(Vector3<A>{A::mul(eye[0], over_w), A::mul(eye[1], over_w), A::mul(eye[2], over_w)});
    const Vector3<A> twice{A::sum(normal[0], normal[0]), A::sum(normal[1], normal[1]),
                           A::sum(normal[2], normal[2])};
    const auto d = dot3<A>(to_eye, twice);
    return {A::reflect(A::mul(normal[0], d), to_eye[0], false),
            A::reflect(A::mul(normal[1], d), to_eye[1], false),
            A::reflect(A::mul(normal[2], d), to_eye[2], true)};
}

}  // namespace twofold
