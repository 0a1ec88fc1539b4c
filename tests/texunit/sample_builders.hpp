#pragma once
#include <limits>
#include <tuple>
#include <vector>

#include "texunit/presets.hpp"
#include "texunit/sample.hpp"

/// Small textures, units and lookups for the tests of sampling.
namespace twofold {

using AllModels = std::tuple<Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom>;

inline constexpr std::array all_wraps{Wrap::repeat, Wrap::clamp, Wrap::clamp_to_edge,
                                      Wrap::clamp_to_border, Wrap::mirrored_repeat};

/// A texture whose red channel holds `reds` (bottom row first); the other channels are 255.
inline Texture red_texture(int width, int height, const std::vector<int>& reds) {
    std::vector<Rgba8> texels;
    for (const int r : reds) texels.push_back({static_cast<std::uint8_t>(r), 255, 255, 255});
    return {width, height, texels};
}

inline TextureUnitState unit_with(Wrap wrap, Filter filter) {
    TextureUnitState unit;
    unit.wrap_s = unit.wrap_t = wrap;
    unit.min_filter = unit.mag_filter = filter;
    return unit;
}

/// The byte that a model's channel is shown as.
template <NumericModel M>
int shown(const M& m, typename M::Channel channel) {
    return m.to_unorm8(m.finish(channel));
}

template <class Real>
ProjectiveCoordinates<Real> coordinates(double s, double t, double r, double q) {
    return {static_cast<Real>(s), static_cast<Real>(t), static_cast<Real>(r), static_cast<Real>(q)};
}

/// The red byte of a lookup at `at`; the border is 77.
template <NumericModel M>
int red_at(const M& m, const UploadedTexture<M>& texture, const TextureUnitState& unit,
           const SamplePoint<typename M::Real>& at) {
    return shown(m, sample(m, texture, unit, at, m.texel(Rgba8{77, 77, 77, 77}))[0]);
}

/// The same at (s, t, q), for units that need no derivatives.
template <NumericModel M>
int red_at(const M& m, const UploadedTexture<M>& texture, const TextureUnitState& unit, double s,
           double t, double q = 1.0) {
    const auto here = coordinates<typename M::Real>(s, t, 0.0, q);
    return red_at(m, texture, unit, {here, here, here});
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace twofold
