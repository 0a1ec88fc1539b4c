#pragma once
#include <cstdint>

#include "texunit/linear.hpp"

/// Dual paraboloid maps: the sphere of directions as two square texture images. A unit vector
/// d = (x, y, z) belongs to the front face where z >= 0 (minus zero is front) and to the back face
/// elsewhere; (a, b) = (x, y) / (1 + |z|) lies in the unit disc, whose edge, the rim, is z = 0. The
/// guard g <= 1 shrinks the disc within the map, (s, t) = (1 + g (a, b)) / 2, so that texels beyond
/// the rim exist and bilinear filtering finds them.
/// @source Heidrich & Seidel, View-independent Environment Maps, 1998; Waterloo's guard 7/8
namespace twofold {

enum class Face : std::uint8_t { front, back };

/// Where a direction lies in the pair of maps: its face and the texture coordinates there.
struct ParaboloidPoint {
    Face face = Face::front;
    Vec2 st{0.5};
};

/// One texel of the pair of maps, row 0 at t = 0.
struct ParaboloidTexel {
    Face face = Face::front;
    int x = 0;
    int y = 0;
};

/// The face that a direction belongs to.
Face face_of(Vec3 d);

/// The point of a unit vector on its own face, within the rim.
ParaboloidPoint to_paraboloid(Vec3 d, double guard);

/// The unit vector of a point of a face; beyond the rim the formula runs on into the other
/// hemisphere, which defines the direction of the guard texels.
Vec3 from_paraboloid(const ParaboloidPoint& point, double guard);

/// The unit vector of a texel's centre on faces of size x size texels.
Vec3 texel_direction(const ParaboloidTexel& texel, int size, double guard);

/// Distance of a texel's centre from the centre of the disc, in units of the rim's radius.
double texel_radius(int x, int y, int size, double guard);

/// Whether the binary alpha of a texel is 1: its centre lies within the rim and 1.5 texels. A
/// bilinear footprint reaches sqrt(2) texels, so every direction of a face finds alpha 1 in all
/// four of its texels and the alpha-tested passes leave no hole along the seam.
bool texel_is_opaque(int x, int y, int size, double guard);

/// OpenGL texture matrix of a face: takes (x, y, z, 1) of a world-space vector to (s, t, 0, q), and
/// (s/q, t/q) is the point on that face. The caller appends the inverse of the view's rotation.
Mat4 paraboloid_matrix(Face face, double guard);

}  // namespace twofold
