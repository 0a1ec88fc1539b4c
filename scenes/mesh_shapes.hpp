#pragma once
#include "raster/mesh.hpp"

/// Meshes that need no file.
namespace twofold {

/// The unit sphere as a cube of n x n squares a face pushed outward: 12 n^2 triangles,
/// counter-clockwise seen from outside, normals equal to positions. Vertices are shared within a
/// face; along the cube's edges two faces have bit-equal ones. Made with / and sqrt only.
/// @throws Error(failure) unless 1 <= n <= 1024.
Mesh sphere_mesh(int n);

/// The square [-1, 1]^2 at z = 0: two counter-clockwise triangles, normal (0, 0, 1), s and t from 0
/// at the lower left to 1 at the upper right.
Mesh quad_mesh();

}  // namespace twofold
