#pragma once
#include "texunit/linear.hpp"

/// Angles of directions in the frame of the surface, normal +z.
namespace twofold {

/// Angle between a unit vector and +z, in [0, pi]; by its chord near the axis, where the cosine has
/// no digits left.
double polar_angle(Vec3 d);

/// Angle of (x, y) from +x in (-pi, pi]; 0 for the zero vector.
double azimuth(double x, double y);

}  // namespace twofold
