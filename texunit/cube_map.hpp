#pragma once
#include <cstddef>

#include "texunit/texel_address.hpp"

/// Where a direction meets a cube map. @source OpenGL 1.3, 3.8.6 and table 3.20
namespace twofold {

/// In the order of OpenGL's constants, in which Texture stores the images.
enum class CubeFace : std::size_t {
    positive_x,
    negative_x,
    positive_y,
    negative_y,
    positive_z,
    negative_z
};

/// The face of the direction (s, t, r): that of its component of largest magnitude. OpenGL leaves
/// ties open; here x comes before y and y before z. The zero vector is on positive_x.
template <class Real>
CubeFace cube_face(const ProjectiveCoordinates<Real>& direction) {
    const auto magnitude = [](Real x) { return x < Real{0} ? -x : x; };
    const Real x = magnitude(direction.s), y = magnitude(direction.t), z = magnitude(direction.r);
    if (x >= y && x >= z)
        return direction.s < Real{0} ? CubeFace::negative_x : CubeFace::positive_x;
    if (y >= z) return direction.t < Real{0} ? CubeFace::negative_y : CubeFace::positive_y;
    return direction.r < Real{0} ? CubeFace::negative_z : CubeFace::positive_z;
}

/// The table's coordinates s = (sc / |ma| + 1) / 2 and t likewise, written over one divisor:
/// (sc + |ma|) / (2 |ma|). The direction's own q would cancel and is not used.
template <class Real>
ProjectiveCoordinates<Real> over_face(Real sc, Real tc, Real ma) {
    const Real length = ma < Real{0} ? -ma : ma;
    return {sc + length, tc + length, Real{0}, length + length};
}

/// The direction's coordinates on `face`, whether or not it is the direction's own face: neighbours
/// of a fragment are laid on the fragment's face, so that differences mean something.
/// @source OpenGL 1.3, table 3.20
template <class Real>
ProjectiveCoordinates<Real> on_face(CubeFace face, const ProjectiveCoordinates<Real>& direction) {
    const auto [x, y, z, q] = direction;
    switch (face) {
        case CubeFace::positive_x:
            return over_face(-z, -y, x);
        case CubeFace::negative_x:
            return over_face(z, -y, x);
        case CubeFace::positive_y:
            return over_face(x, z, y);
        case CubeFace::negative_y:
            return over_face(x, -z, y);
        case CubeFace::positive_z:
            return over_face(x, -y, z);
        case CubeFace::negative_z:
            break;
    }
    return over_face(-x, -y, z);
}

/// The direction of a point of a face, |ma| = 1; past the edge the face's plane runs on.
/// @source OpenGL 1.3, table 3.20, solved for the direction
constexpr Vec3 from_cube(CubeFace face, Vec2 st) {
    const double sc = 2.0 * st.x - 1.0, tc = 2.0 * st.y - 1.0;
    switch (face) {
        case CubeFace::positive_x:
            return {1.0, -tc, -sc};
        case CubeFace::negative_x:
            return {-1.0, -tc, sc};
        case CubeFace::positive_y:
            return {sc, 1.0, tc};
        case CubeFace::negative_y:
            return {sc, -1.0, -tc};
        case CubeFace::positive_z:
            return {sc, -tc, 1.0};
        case CubeFace::negative_z:
            break;
    }
    return {-sc, -tc, -1.0};
}

/// Lookups stay on their face, whose edge the unit's wrap modes treat as that of any image.
/// @source OpenGL 1.3, 3.8.6: "using the rules given in sections 3.8.7 and 3.8.8"
constexpr Addressing cube_addressing(const TextureUnitState& unit) {
    return {unit.wrap_s, unit.wrap_t, true, false};
}

}  // namespace twofold
