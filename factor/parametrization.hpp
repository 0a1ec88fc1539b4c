#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "factor/samples.hpp"
#include "factor/settings.hpp"
#include "texunit/paraboloid.hpp"

/// The two parametrisations of the model L_o(v, n) ~ t1(pi_1) t2(pi_2), and what a direction
/// touches in a factor map. A map is two paraboloid or six cube faces of R x R texels, or one
/// image; its texels, the unknowns, are numbered face * R^2 + y * R + x, row 0 at t = 0, the front
/// paraboloid first and cube faces in OpenGL's order.
/// @source seed paper, equation 5 and section 3.1; cube maps: OpenGL 1.3, table 3.20; sphere maps:
///         2.10.4
namespace twofold {

/// The shape of a factor map.
struct MapShape {
    int size = 64;         ///< R
    double guard = 0.875;  ///< g, of paraboloids
    MapForm form = MapForm::dual_paraboloid;

    std::size_t faces() const {
        if (form == MapForm::dual_paraboloid) return 2;
        return form == MapForm::cube ? 6 : 1;
    }
    std::size_t texels() const { return faces() * face_texels(); }
    std::size_t face_texels() const {
        return static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    }
    bool operator==(const MapShape&) const = default;
};

/// The shape that settings ask for.
inline MapShape shape_of(const FactorSettings& settings) {
    return {settings.map_size, settings.guard, settings.map_form};
}

/// One texel of a map.
struct MapTexel {
    std::size_t face = 0;
    int x = 0, y = 0;
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

/// What texture coordinates touch in a map of one image.
TexelFootprint footprint_at(Vec2 st, const MapShape& shape);

/// The texel with a number.
MapTexel texel_at(std::size_t index, const MapShape& shape);

/// Number of a texel.
std::uint32_t texel_index(const MapTexel& texel, const MapShape& shape);

/// The unit vector of a texel's centre.
Vec3 texel_direction(const MapTexel& texel, const MapShape& shape);

/// Whether a texel's direction belongs to its own face; a paraboloid has texels beyond its rim, and
/// so has a sphere map.
bool within_face(const MapTexel& texel, const MapShape& shape);

/// Whether a texel's binary alpha is 1: texel_is_opaque() of two paraboloids, all of other forms,
/// which need no test.
bool is_opaque(const MapTexel& texel, const MapShape& shape);

/// The texel a step of one column or row away, or none past the edge of an image. Past the edge
/// of a cube's face it is the one across the edge.
std::optional<MapTexel> beside(const MapTexel& texel, int columns, int rows, const MapShape& shape);

/// The map's value under a footprint: weights times texels, left to right.
double filtered(std::span<const double> texels, const TexelFootprint& footprint);

}  // namespace twofold
