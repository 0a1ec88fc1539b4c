#include "texunit/paraboloid.hpp"

#include <cmath>

namespace twofold {

namespace {

/// (a, b) of a texel's centre: 1 is the rim.
Vec2 disc_position(int x, int y, int size, double guard) {
    const double scale = guard * size;
    return {(2 * x + 1 - size) / scale, (2 * y + 1 - size) / scale};
}

Vec3 direction_of(Face face, Vec2 ab) {
    const double square = ab.x * ab.x + ab.y * ab.y;
    const double z = (1.0 - square) / (1.0 + square);
    return {2.0 * ab.x / (1.0 + square), 2.0 * ab.y / (1.0 + square), face == Face::front ? z : -z};
}

}  // namespace

Face face_of(Vec3 d) { return d.z >= 0.0 ? Face::front : Face::back; }

ParaboloidPoint to_paraboloid(Vec3 d, double guard) {
    const double half_over_q = 0.5 * guard / (1.0 + std::fabs(d.z));
    return {face_of(d), {0.5 + d.x * half_over_q, 0.5 + d.y * half_over_q}};
}

Vec3 from_paraboloid(const ParaboloidPoint& point, double guard) {
    return direction_of(point.face,
                        {(2.0 * point.st.x - 1.0) / guard, (2.0 * point.st.y - 1.0) / guard});
}

Vec3 texel_direction(const ParaboloidTexel& texel, int size, double guard) {
    return direction_of(texel.face, disc_position(texel.x, texel.y, size, guard));
}

double texel_radius(int x, int y, int size, double guard) {
    const Vec2 ab = disc_position(x, y, size, guard);
    return std::sqrt(ab.x * ab.x + ab.y * ab.y);
}

bool texel_is_opaque(int x, int y, int size, double guard) {
    const double texel = 2.0 / (guard * size);
    return texel_radius(x, y, size, guard) <= 1.0 + 1.5 * texel;
}

Mat4 paraboloid_matrix(Face face, double guard) {
    const double sign = face == Face::front ? 1.0 : -1.0;
    // GLM's constructor takes columns: the images of x, y, z and 1.
    return {0.5 * guard, 0.0,         0.0, 0.0,   //
            0.0,         0.5 * guard, 0.0, 0.0,   //
            0.5 * sign,  0.5 * sign,  0.0, sign,  //
            0.5,         0.5,         0.0, 1.0};
}

}  // namespace twofold
