#pragma once
#include <cmath>

#include "texunit/unit_state.hpp"

/// From texture coordinates to texel indices along one axis. The rules are the same for all
/// presets, in the preset's coordinate format.
namespace twofold {

/// Texture coordinates of one fragment before the division: s = S/Q, t = T/Q. A cube map reads
/// (S, T, R) as a direction.
template <class Real>
struct ProjectiveCoordinates {
    Real s, t, r, q;
};

/// Texels beyond this distance from the origin are all the same texel (T03, T05): coordinates stop
/// here before they become integers.
inline constexpr int farthest_texel = 1 << 15;

/// numerator x size / q in texels, with a single division: an exact integer stays one. Division by
/// 0 gives the farthest texel by sign, as captures of NV2A show; 0 / 0 and other results that are
/// not numbers give 0 (T02).
template <class Real>
Real texel_coordinate(Real numerator, Real q, int size) {
    const Real u = numerator * static_cast<Real>(size) / q;
    constexpr Real limit{farthest_texel};
    if (!(u == u)) return Real{0};
    return u < -limit ? -limit : (u > limit ? limit : u);
}

/// u of the image and of its mirror image in turn. @source OpenGL 1.4, 3.8.6
template <class Real>
Real mirrored(Real u, Real n) {
    const Real copy = std::floor(u / n);
    const Real inside = u - n * copy;
    const bool odd = copy != Real{2} * std::floor(copy / Real{2});
    return odd ? n - inside : inside;
}

/// The coordinate limited as the wrap mode says, in texels. @source OpenGL 1.3, 3.8.5
template <class Real>
Real limit_coordinate(Real u, int size, Wrap wrap) {
    const Real n = static_cast<Real>(size);
    constexpr Real half{0.5};
    const auto within = [](Real x, Real lo, Real hi) { return x < lo ? lo : (x > hi ? hi : x); };
    switch (wrap) {
        case Wrap::repeat:
            return u - n * std::floor(u / n);
        case Wrap::clamp:
            return within(u, Real{0}, n);
        case Wrap::clamp_to_edge:
            return within(u, half, n - half);
        case Wrap::mirrored_repeat:
            return within(mirrored(u, n), half, n - half);
        case Wrap::clamp_to_border:
            break;
    }
    return within(u, -half, n + half);
}

/// Indices of the border: its texels on either side of an image, or the unit's border colour for an
/// image without. All other indices are at least 0.
inline constexpr int border_before = -1, border_behind = -2;

/// The texel index for an integer coordinate of -1..size + 1. The last occurs with weight 0 only,
/// where CLAMP_TO_BORDER ends.
constexpr int wrap_index(int i, int size, Wrap wrap) {
    if (i >= 0 && i < size) return i;
    if (wrap == Wrap::repeat) return i < 0 ? i + size : i - size;
    if (wrap == Wrap::clamp_to_edge || wrap == Wrap::mirrored_repeat) return i < 0 ? 0 : size - 1;
    return i < 0 ? border_before : border_behind;
}

/// The two texels that LINEAR blends along one axis, and the fraction of the second.
template <class Real>
struct LinearFootprint {
    int i0, i1;
    Real fraction;
};

/// Largest integer <= u of a limited coordinate: conversion cuts toward 0.
template <class Real>
int floor_of_texel(Real u) {
    const int cut = static_cast<int>(u);
    return u < static_cast<Real>(cut) ? cut - 1 : cut;
}

/// @source OpenGL 1.3, 3.8.7: i0 = floor(u - 1/2)
template <class Real>
LinearFootprint<Real> linear_footprint(Real u, int size, Wrap wrap) {
    const Real shifted = limit_coordinate(u, size, wrap) - Real{0.5};
    const int i = floor_of_texel(shifted);
    return {wrap_index(i, size, wrap), wrap_index(i + 1, size, wrap),
            shifted - static_cast<Real>(i)};
}

/// The texel of the image and of its mirror image in turn. The coordinate becomes an integer before
/// it is mirrored: at an exact integer that is the texel to its right.
/// @source captures of NV2A
constexpr int mirrored_index(int i, int size) {
    const int period = 2 * size;
    const int j = ((i % period) + period) % period;
    return j < size ? j : period - 1 - j;
}

/// @source OpenGL 1.3, 3.8.7: floor(u), and the last texel at u = size
template <class Real>
int nearest_texel(Real u, int size, Wrap wrap) {
    if (wrap == Wrap::mirrored_repeat) return mirrored_index(floor_of_texel(u), size);
    const int i = floor_of_texel(limit_coordinate(u, size, wrap));
    if (i == size && wrap != Wrap::clamp_to_border) return size - 1;
    return wrap_index(i, size, wrap);
}

/// What of a unit's state decides how its coordinates address an image.
struct Addressing {
    Wrap wrap_s, wrap_t;
    bool divide_by_q = true;
    bool in_texels = false;  ///< coordinates count texels, not images
};

constexpr Addressing addressing_of(const TextureUnitState& unit) {
    return {unit.wrap_s, unit.wrap_t, unit.divide_by_q, unit.target == TextureTarget::rectangle};
}

/// A place in an image, in texels.
template <class Real>
struct TexelPoint {
    Real u, v;
};

template <class Real>
TexelPoint<Real> texel_point(const Addressing& how, const ProjectiveCoordinates<Real>& at,
                             int width, int height) {
    const Real q = how.divide_by_q ? at.q : Real{1};
    return {texel_coordinate(at.s, q, how.in_texels ? 1 : width),
            texel_coordinate(at.t, q, how.in_texels ? 1 : height)};
}

}  // namespace twofold
