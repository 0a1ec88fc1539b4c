#pragma once
#include <array>
#include <cstdint>

#include "raster/pass.hpp"
#include "texunit/linear.hpp"
#include "texunit/numeric_model.hpp"

namespace twofold {

/// A vertex behind the vertex stage, before clipping. Held in binary64 whatever the preset: every
/// number of a narrower format is exact in it, so clipping is written once.
struct ClipVertex {
    /// x, y, z, w with the viewport's scale already applied to x, y, z: x / w + offset is in
    /// pixels.
    Vec4 clip;
    Vec4 color;                          ///< r, g, b, a before any clamp
    Vec4 secondary_color;                ///< r, g, b; the fourth is the fog factor
    std::array<Vec4, max_units> coords;  ///< s, t, r, q of each unit behind its texture matrix
};

/// A vertex in the window: what set-up and interpolation need, in the preset's formats.
template <NumericModel M>
struct WindowVertex {
    using Real = typename M::Real;
    using Channel = typename M::Channel;

    std::int64_t x, y;  ///< in snap units, y down
    double z;           ///< window depth, 0 near to 1 far
    Real inverse_w;     ///< 1 where the pass asks for no perspective correction
    Color<Channel> color;
    Color<Channel> secondary_color;  ///< its alpha is the fog factor
    /// s, t, r, q of each unit, over w where the model's vertex stage multiplies them by 1/w.
    std::array<std::array<Real, 4>, max_units> coords;
};

/// The viewport of a picture of width x height pixels with y down and depth range [0, 1].
constexpr Viewport viewport_of(int width, int height, SnapRule snap) {
    return {Vec3{0.5 * width, -0.5 * height, 0.5},
            Vec3{0.5 * width + snap.bias, 0.5 * height + snap.bias, 0.5}};
}

}  // namespace twofold
