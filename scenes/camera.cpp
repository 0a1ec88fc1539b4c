#include "scenes/camera.hpp"

#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

double radians(double degrees) { return degrees * (exact::pi / 180.0); }

}  // namespace

Mat4 view_matrix(const Camera& camera) {
    const Vec3 forward = normalized(camera.target - camera.eye);
    const Vec3 right = normalized(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    Mat4 m{1.0};
    for (int i = 0; i < 3; ++i) {
        m[i][0] = right[i];
        m[i][1] = up[i];
        m[i][2] = -forward[i];
    }
    m[3] = Vec4{-dot(right, camera.eye), -dot(up, camera.eye), dot(forward, camera.eye), 1.0};
    return m;
}

Mat4 projection_matrix(const Camera& camera, double aspect) {
    const double half = radians(camera.vertical_fov_degrees) / 2.0;
    const double f = exact::cos(half) / exact::sin(half);
    const double n = camera.near_plane, z = camera.far_plane;
    Mat4 m{0.0};
    m[0][0] = f / aspect;
    m[1][1] = f;
    m[2][2] = (z + n) / (n - z);
    m[2][3] = -1.0;
    m[3][2] = 2.0 * z * n / (n - z);
    return m;
}

Mat4 model_matrix(const FactoredObject& object) {
    const double angle = radians(object.rotate_y_degrees);
    const double c = object.scale * exact::cos(angle), s = object.scale * exact::sin(angle);
    Mat4 m{1.0};
    m[0] = Vec4{c, 0.0, -s, 0.0};
    m[1] = Vec4{0.0, object.scale, 0.0, 0.0};
    m[2] = Vec4{s, 0.0, c, 0.0};
    m[3] = Vec4{object.translation, 1.0};
    return m;
}

}  // namespace twofold
