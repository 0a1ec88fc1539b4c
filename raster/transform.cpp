#include "raster/transform.hpp"

#include <glm/matrix.hpp>

#include "texunit/exact_math.hpp"

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
        if (unit && uses_normal(unit->texgen)) return true;
    return false;
}

bool needs_eye_position(const PassState& state) {
    for (const auto& unit : state.units)
        if (unit && uses_eye_position(unit->texgen)) return true;
    return state.fog.has_value();
}

double fog_factor(const Fog& fog, const Vec4& eye) {
    const double c = std::fabs(eye.z / eye.w);
    const double scaled = fog.density * c;
    double f = 0.0;
    switch (fog.mode) {
        case FogMode::linear:
            f = (fog.end - c) / (fog.end - fog.start);
            break;
        case FogMode::exp:
            f = exact::exp(-scaled);
            break;
        case FogMode::exp2:
            f = exact::exp(-(scaled * scaled));
            break;
    }
    return f > 0.0 ? (f < 1.0 ? f : 1.0) : 0.0;
}

}  // namespace twofold
