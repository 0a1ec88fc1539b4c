#include <cmath>

#include "tests/raster/builders.hpp"
#include "tests/raster/random/random_parts.hpp"

/// Where meshes are seen, and colours and directions.
namespace twofold::test {
namespace {

constexpr double near_plane = 0.5, far_plane = 16.0;

/// The distance from the eye of a depth in [0, 1], linear so that planes stay planes nowhere.
double distance_of(double depth) { return near_plane + 4.0 * depth; }

/// The rotation of a unit quaternion, exactly orthogonal but for rounding.
Mat4 random_rotation(Dice& dice) {
    Vec4 q{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1), dice.real(0.1, 1)};
    q = q / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    Mat4 m{1.0};
    m[0] = {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.z * q.w),
            2 * (q.x * q.z - q.y * q.w), 0};
    m[1] = {2 * (q.x * q.y - q.z * q.w), 1 - 2 * (q.x * q.x + q.z * q.z),
            2 * (q.y * q.z + q.x * q.w), 0};
    m[2] = {2 * (q.x * q.z + q.y * q.w), 2 * (q.y * q.z - q.x * q.w),
            1 - 2 * (q.x * q.x + q.y * q.y), 0};
    return m;
}

/// The object-space point that the rigid modelview takes to `eye`.
Vec3 before(const Mat4& modelview, Vec3 eye) {
    const Vec3 d = eye - Vec3{modelview[3]};
    return {dot(Vec3{modelview[0]}, d), dot(Vec3{modelview[1]}, d), dot(Vec3{modelview[2]}, d)};
}

}  // namespace

Vec3 View::position_at(const Spot& spot) const {
    if (space != Space::perspective) return {spot.x, spot.y, spot.depth};
    const double d = distance_of(spot.depth);
    return before(modelview, {(2.0 * spot.x / width - 1.0) * d / 2.0,
                              (1.0 - 2.0 * spot.y / height) * d / 2.0, -d});
}

Vec3 random_direction(Dice& dice) {
    const Vec3 d{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)};
    return length(d) > 0.01 ? normalized(d) : Vec3{0.0, 0.0, -1.0};
}

Vec4 random_color(Dice& dice) {
    Vec4 color;
    for (int c = 0; c < 4; ++c)
        color[c] = dice.chance(0.3) ? dice.one_of({0.0, 1.0, 0.5}) : dice.unit();
    return color;
}

View random_view(Dice& dice, int width, int height, Space space) {
    View view{.width = width, .height = height, .space = space};
    if (space == Space::pixels) view.projection = pixel_projection(width, height);
    if (space != Space::perspective) return view;
    view.projection = frustum(near_plane, far_plane);
    if (dice.chance(0.3)) return view;
    view.modelview = random_rotation(dice);
    view.modelview[3] = {dice.real(-1, 1), dice.real(-1, 1), dice.real(-4, 0), 1.0};
    return view;
}

}  // namespace twofold::test
