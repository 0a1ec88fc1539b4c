#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "texunit/numeric_model.hpp"
#include "texunit/texture.hpp"
#include "texunit/unit_state.hpp"

/// A texture as a preset stores it, and how a texel is found. Addressing is the same for all
/// presets, in the preset's coordinate format; values come from the preset.
namespace twofold {

/// A texture image converted once into the preset's channels (OpenGL 1.3, 3.8.1). Rows bottom up.
template <NumericModel M>
struct UploadedTexture {
    int width = 1;
    int height = 1;
    std::vector<Color<typename M::Channel>> texels;
};

template <NumericModel M>
UploadedTexture<M> upload(const Texture& texture) {
    UploadedTexture<M> result{texture.width, texture.height, {}};
    std::visit(
        [&](const auto& texels) {
            result.texels.reserve(texels.size());
            for (const auto& t : texels) result.texels.push_back(M::texel(t));
        },
        texture.texels);
    return result;
}

/// Texture coordinates of one fragment before the division: s = S/Q, t = T/Q.
template <class Real>
struct ProjectiveCoordinates {
    Real s, t, q;
};

/// Texels beyond this distance from the origin are all the same texel (T03, T05): coordinates stop
/// here before they become integers.
inline constexpr int farthest_texel = 1 << 15;

/// numerator x size / q in texels, with a single division: an exact integer stays one. q = 0 and
/// results that are not numbers give 0 (T02).
template <class Real>
Real texel_coordinate(Real numerator, Real q, int size) {
    const Real u = numerator * static_cast<Real>(size) / q;
    constexpr Real limit{farthest_texel};
    if (q == Real{0} || !(u == u)) return Real{0};
    return u < -limit ? -limit : (u > limit ? limit : u);
}

/// The coordinate limited as the wrap mode says, in texels. @source OpenGL 1.3, 3.8.5
template <class Real>
Real limit_coordinate(Real u, int size, Wrap wrap) {
    const Real n = static_cast<Real>(size);
    constexpr Real half{0.5};
    const auto within = [u](Real lo, Real hi) { return u < lo ? lo : (u > hi ? hi : u); };
    switch (wrap) {
        case Wrap::repeat:
            return u - n * std::floor(u / n);
        case Wrap::clamp:
            return within(Real{0}, n);
        case Wrap::clamp_to_edge:
            return within(half, n - half);
        case Wrap::clamp_to_border:
            break;
    }
    return within(-half, n + half);
}

/// The texel index for an integer coordinate of -1..size; -1 stands for the border.
constexpr int wrap_index(int i, int size, Wrap wrap) {
    if (i >= 0 && i < size) return i;
    if (wrap == Wrap::repeat) return i < 0 ? i + size : i - size;
    if (wrap == Wrap::clamp_to_edge) return i < 0 ? 0 : size - 1;
    return -1;
}

/// The two texels that LINEAR blends along one axis, and the fraction of the second.
template <class Real>
struct LinearFootprint {
    int i0, i1;
    Real fraction;
};

/// @source OpenGL 1.3, 3.8.7: i0 = floor(u - 1/2)
template <class Real>
LinearFootprint<Real> linear_footprint(Real u, int size, Wrap wrap) {
    const Real shifted = limit_coordinate(u, size, wrap) - Real{0.5};
    const Real base = std::floor(shifted);
    const int i = static_cast<int>(base);
    return {wrap_index(i, size, wrap), wrap_index(i + 1, size, wrap), shifted - base};
}

/// @source OpenGL 1.3, 3.8.7: floor(u), and the last texel at u = size
template <class Real>
int nearest_texel(Real u, int size, Wrap wrap) {
    const int i = static_cast<int>(std::floor(limit_coordinate(u, size, wrap)));
    if (i == size && wrap != Wrap::clamp_to_border) return size - 1;
    return wrap_index(i, size, wrap);
}

template <NumericModel M>
Color<typename M::Channel> fetch(const UploadedTexture<M>& texture, int i, int j,
                                 const Color<typename M::Channel>& border) {
    if (i < 0 || j < 0) return border;
    return texture.texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(texture.width) +
                          static_cast<std::size_t>(i)];
}

template <NumericModel M>
Color<typename M::Channel> sample_linear(const UploadedTexture<M>& texture,
                                         const TextureUnitState& unit, typename M::Real u,
                                         typename M::Real v,
                                         const Color<typename M::Channel>& border) {
    const auto x = linear_footprint(u, texture.width, unit.wrap_s);
    const auto y = linear_footprint(v, texture.height, unit.wrap_t);
    const auto t00 = fetch(texture, x.i0, y.i0, border), t10 = fetch(texture, x.i1, y.i0, border);
    const auto t01 = fetch(texture, x.i0, y.i1, border), t11 = fetch(texture, x.i1, y.i1, border);
    Color<typename M::Channel> result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = M::filter(t00[c], t10[c], t01[c], t11[c], x.fraction, y.fraction);
    return result;
}

/// The filtered texel of one fragment.
template <NumericModel M>
Color<typename M::Channel> sample(const UploadedTexture<M>& texture, const TextureUnitState& unit,
                                  const ProjectiveCoordinates<typename M::Real>& at,
                                  const Color<typename M::Channel>& border) {
    const auto u = texel_coordinate(at.s, at.q, texture.width);
    const auto v = texel_coordinate(at.t, at.q, texture.height);
    if (unit.filter == Filter::linear) return sample_linear(texture, unit, u, v, border);
    return fetch(texture, nearest_texel(u, texture.width, unit.wrap_s),
                 nearest_texel(v, texture.height, unit.wrap_t), border);
}

}  // namespace twofold
