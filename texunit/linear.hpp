#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// Vectors and matrices in binary64. GLM is used as a container and for + - * / only: its functions
/// that call libm (perspective, rotate, slerp ...) differ between platforms (docs/exactness.md,
/// section 6).
namespace twofold {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

/// Linear radiance, irradiance or reflectance in the three channels red, green, blue.
using Rgb = glm::dvec3;

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double max_component(Rgb c) {
    const double rg = c.x < c.y ? c.y : c.x;
    return rg < c.z ? c.z : rg;
}

/// Unit vector along `a`, which must not be zero; sqrt and / are correctly rounded everywhere.
Vec3 normalized(Vec3 a);

/// Length of `a`.
double length(Vec3 a);

}  // namespace twofold
