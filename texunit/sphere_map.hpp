#pragma once
#include <cmath>

#include "texunit/linear.hpp"

/// OpenGL's sphere map: all directions in one square image, that of +z in the middle and that of -z
/// along the whole rim of the disc, where the map is singular.
namespace twofold {

/// (s, t) = (x, y) / m + 1/2 with m = 2 |d + (0, 0, 1)|; of -z, which has no point of its own, the
/// rim at s = 1.
/// @param d unit vector @source OpenGL 1.3, 2.10.4
inline Vec2 to_sphere_map(Vec3 d) {
    const double m = 2.0 * std::sqrt(d.x * d.x + d.y * d.y + (d.z + 1.0) * (d.z + 1.0));
    if (!(m > 0.0)) return {1.0, 0.5};
    return {d.x / m + 0.5, d.y / m + 0.5};
}

/// The unit vector of a point; beyond the rim that of the rim, -z.
inline Vec3 from_sphere_map(Vec2 st) {
    const double a = 2.0 * st.x - 1.0, b = 2.0 * st.y - 1.0;
    const double square = a * a + b * b;
    if (!(square < 1.0)) return {0.0, 0.0, -1.0};
    // (a, b, c) halves the angle between d and +z.
    const double c = std::sqrt(1.0 - square);
    return {2.0 * a * c, 2.0 * b * c, 2.0 * c * c - 1.0};
}

}  // namespace twofold
