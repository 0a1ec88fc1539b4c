#include "factor/parametrization.hpp"

#include <cmath>

#include "texunit/fixed.hpp"

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

}  // namespace

Vec3 pi_2(const SurfaceView& at) { return 2.0 * dot(at.n, at.v) * at.n - at.v; }

TexelFootprint footprint_of(Vec3 d, const MapShape& shape) {
    const ParaboloidPoint point = to_paraboloid(d, shape.guard);
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

ParaboloidTexel texel_at(std::size_t index, const MapShape& shape) {
    const std::size_t in_face = index % shape.face_texels();
    const auto size = static_cast<std::size_t>(shape.size);
    return {index < shape.face_texels() ? Face::front : Face::back,
            static_cast<int>(in_face % size), static_cast<int>(in_face / size)};
}

std::uint32_t texel_index(const ParaboloidTexel& texel, const MapShape& shape) {
    const int row = (texel.face == Face::front ? 0 : shape.size) + texel.y;
    return static_cast<std::uint32_t>(row * shape.size + texel.x);
}

double filtered(std::span<const double> texels, const TexelFootprint& footprint) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) sum += footprint.weight[k] * texels[footprint.index[k]];
    return sum;
}

}  // namespace twofold
