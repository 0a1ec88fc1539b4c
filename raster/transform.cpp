#include "raster/transform.hpp"

#include <glm/matrix.hpp>

namespace twofold {

bool invertible(const Mat3& m) {
    const double volume = dot(m[0], cross(m[1], m[2]));
    const double extent = length(m[0]) * length(m[1]) * length(m[2]);
    return std::fabs(volume) > 1e-12 * extent;  // false for 0, NaN and infinity / infinity too
}

Mat3 normal_matrix(const Mat4& modelview) {
    const Mat3 linear{modelview};
    if (!invertible(linear))
        throw Error(ExitCode::failure, "modelview: singular, so it transforms no normals");
    return glm::transpose(glm::inverse(linear));
}

bool needs_normals(const PassState& state) {
    for (const auto& unit : state.units)
        if (unit && unit->texgen != TexGen::none) return true;
    return false;
}

}  // namespace twofold
