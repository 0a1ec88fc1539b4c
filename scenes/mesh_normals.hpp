#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "texunit/linear.hpp"

namespace twofold {

/// One unit normal per position: the sum, over the triangles at that position in index order, of
/// the triangle's unit normal times its angle there, normalised. The angle makes the result
/// independent of how a flat part is cut into triangles; weights by area would point to the wrong
/// side of some corners of the teapot. A triangle of zero area adds nothing; where nothing was
/// added the normal is (0, 0, 1).
/// @param indices three per triangle, all below positions.size().
std::vector<Vec3> vertex_normals(std::span<const Vec3> positions,
                                 std::span<const std::uint32_t> indices);

/// False for the zero vector, and for one so short that its square is no normal number.
bool has_direction(Vec3 a);

/// `normal` as a unit vector, or `fallback` where it has no direction: some files write zero for
/// "none".
Vec3 unit_or(Vec3 normal, Vec3 fallback);

/// Twice the triangle's area along its normal; exactly zero for a degenerate triangle.
Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c);

}  // namespace twofold
