#include "factor/parametrization.hpp"

#include <cmath>

#include "texunit/cube_map.hpp"
#include "texunit/fixed.hpp"
#include "texunit/sphere_map.hpp"

namespace twofold {

namespace {

/// The two texels of a coordinate along one edge and the weight of the second.
struct Taps {
    int first;
    int second;
    double fraction;
};

Taps taps_of(double coordinate, int size) {
    const double position = coordinate * size - 0.5;
    const double whole = std::floor(position);
    return {to_fixed(whole, 0, size - 1), to_fixed(whole + 1.0, 0, size - 1), position - whole};
}

/// Where a direction lies: the face and the texture coordinates there.
struct MapPoint {
    std::size_t face;
    Vec2 st;
};

MapPoint point_of(Vec3 d, const MapShape& shape) {
    if (shape.form == MapForm::sphere) return {0, to_sphere_map(d)};
    if (shape.form != MapForm::cube) {
        const ParaboloidPoint point = to_paraboloid(d, shape.guard);
        return {static_cast<std::size_t>(point.face), point.st};
    }
    const ProjectiveCoordinates<double> direction{d.x, d.y, d.z, 1.0};
    const CubeFace face = cube_face(direction);
    const auto on = on_face(face, direction);
    return {static_cast<std::size_t>(face), {on.s / on.q, on.t / on.q}};
}

TexelFootprint footprint_of(const MapPoint& point, const MapShape& shape) {
    const Taps x = taps_of(point.st.x, shape.size);
    const Taps y = taps_of(point.st.y, shape.size);
    const auto index = [&](int column, int row) {
        return texel_index({point.face, column, row}, shape);
    };
    return {{index(x.first, y.first), index(x.second, y.first), index(x.first, y.second),
             index(x.second, y.second)},
            {(1.0 - x.fraction) * (1.0 - y.fraction), x.fraction * (1.0 - y.fraction),
             (1.0 - x.fraction) * y.fraction, x.fraction * y.fraction}};
}

ParaboloidTexel on_paraboloid(const MapTexel& texel) {
    return {texel.face == 0 ? Face::front : Face::back, texel.x, texel.y};
}

bool outside(const MapTexel& texel, int size) {
    return texel.x < 0 || texel.y < 0 || texel.x >= size || texel.y >= size;
}

}  // namespace

Vec3 pi_2(const SurfaceView& at) { return 2.0 * dot(at.n, at.v) * at.n - at.v; }

TexelFootprint footprint_of(Vec3 d, const MapShape& shape) {
    return footprint_of(point_of(d, shape), shape);
}

TexelFootprint footprint_at(Vec2 st, const MapShape& shape) {
    return footprint_of(MapPoint{0, st}, shape);
}

MapTexel texel_at(std::size_t index, const MapShape& shape) {
    const std::size_t in_face = index % shape.face_texels();
    const auto size = static_cast<std::size_t>(shape.size);
    return {index / shape.face_texels(), static_cast<int>(in_face % size),
            static_cast<int>(in_face / size)};
}

std::uint32_t texel_index(const MapTexel& texel, const MapShape& shape) {
    const int row = static_cast<int>(texel.face) * shape.size + texel.y;
    return static_cast<std::uint32_t>(row * shape.size + texel.x);
}

Vec3 texel_direction(const MapTexel& texel, const MapShape& shape) {
    const Vec2 st{(texel.x + 0.5) / shape.size, (texel.y + 0.5) / shape.size};
    if (shape.form == MapForm::sphere) return from_sphere_map(st);
    if (shape.form != MapForm::cube)
        return texel_direction(on_paraboloid(texel), shape.size, shape.guard);
    return normalized(from_cube(static_cast<CubeFace>(texel.face), st));
}

bool within_face(const MapTexel& texel, const MapShape& shape) {
    if (shape.form == MapForm::cube) return true;
    const double guard = shape.form == MapForm::sphere ? 1.0 : shape.guard;
    return texel_radius(texel.x, texel.y, shape.size, guard) <= 1.0;
}

bool is_opaque(const MapTexel& texel, const MapShape& shape) {
    return shape.form != MapForm::dual_paraboloid ||
           texel_is_opaque(texel.x, texel.y, shape.size, shape.guard);
}

std::optional<MapTexel> beside(const MapTexel& texel, int columns, int rows,
                               const MapShape& shape) {
    const MapTexel next{texel.face, texel.x + columns, texel.y + rows};
    if (!outside(next, shape.size)) return next;
    if (shape.form != MapForm::cube) return std::nullopt;
    // One step past the edge the plane of the face is nearest to its neighbour's texel.
    const MapPoint point = point_of(texel_direction(next, shape), shape);
    return MapTexel{point.face, to_fixed(std::floor(point.st.x * shape.size), 0, shape.size - 1),
                    to_fixed(std::floor(point.st.y * shape.size), 0, shape.size - 1)};
}

double filtered(std::span<const double> texels, const TexelFootprint& footprint) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) sum += footprint.weight[k] * texels[footprint.index[k]];
    return sum;
}

}  // namespace twofold
