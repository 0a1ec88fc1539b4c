#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "factor/samples.hpp"
#include "texunit/paraboloid.hpp"

/// The two parametrisations of the model L_o(v, n) ~ t1(pi_1) t2(pi_2), and what a direction
/// touches in a factor map. A map is two paraboloid faces of R x R texels; its texels, the
/// unknowns, are numbered face * R^2 + y * R + x, front face first, row 0 at t = 0.
/// @source seed paper, equation 5 and section 3.1
namespace twofold {

/// The shape of a factor map.
struct MapShape {
    int size = 64;         ///< R
    double guard = 0.875;  ///< g

    std::size_t texels() const { return 2 * face_texels(); }
    std::size_t face_texels() const {
        return static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    }
    bool operator==(const MapShape&) const = default;
};

/// The four texels of a bilinear look-up in the order (x0, y0), (x1, y0), (x0, y1), (x1, y1), and
/// their weights, which sum to 1. At the edge of a face texels repeat.
struct TexelFootprint {
    std::array<std::uint32_t, 4> index{};
    std::array<double, 4> weight{};
};

/// pi_1: the surface normal.
inline Vec3 pi_1(const SurfaceView& at) { return at.n; }

/// pi_2: the viewing direction mirrored at the normal, r_v = 2 (n.v) n - v.
Vec3 pi_2(const SurfaceView& at);

/// What a unit vector touches: bilinear as OpenGL's LINEAR with CLAMP_TO_EDGE.
TexelFootprint footprint_of(Vec3 d, const MapShape& shape);

/// The texel with a number.
ParaboloidTexel texel_at(std::size_t index, const MapShape& shape);

/// Number of a texel.
std::uint32_t texel_index(const ParaboloidTexel& texel, const MapShape& shape);

/// The map's value under a footprint: weights times texels, left to right.
double filtered(std::span<const double> texels, const TexelFootprint& footprint);

}  // namespace twofold
