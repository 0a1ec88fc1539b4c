#include "scenes/mesh_normals.hpp"

#include <array>

#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

/// The angle between two edges in radians, 0 if one has no length. Rounding may carry the cosine of
/// parallel edges just past 1, where acos has no value.
double angle_between(Vec3 a, Vec3 b) {
    const double lengths = length(a) * length(b);
    if (lengths == 0.0) return 0.0;
    const double cosine = dot(a, b) / lengths;
    return exact::acos(cosine > 1.0 ? 1.0 : cosine < -1.0 ? -1.0 : cosine);
}

std::array<double, 3> corner_angles(Vec3 a, Vec3 b, Vec3 c) {
    return {angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)};
}

}  // namespace

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a); }

bool has_direction(Vec3 a) { return dot(a, a) >= 0x1p-1000; }

Vec3 unit_or(Vec3 normal, Vec3 fallback) {
    return has_direction(normal) ? normalized(normal) : fallback;
}

std::vector<Vec3> vertex_normals(std::span<const Vec3> positions,
                                 std::span<const std::uint32_t> indices) {
    std::vector<Vec3> normals(positions.size(), Vec3(0.0));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vec3 a = positions[indices[i]];
        const Vec3 b = positions[indices[i + 1]];
        const Vec3 c = positions[indices[i + 2]];
        const Vec3 normal = unit_or(area_vector(a, b, c), Vec3(0.0));
        const auto angles = corner_angles(a, b, c);
        for (std::size_t k = 0; k < 3; ++k) normals[indices[i + k]] += normal * angles[k];
    }
    for (Vec3& normal : normals) normal = unit_or(normal, {0.0, 0.0, 1.0});
    return normals;
}

}  // namespace twofold
