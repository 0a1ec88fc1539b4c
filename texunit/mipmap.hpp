#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "texunit/exact_math.hpp"
#include "texunit/texel_address.hpp"

/// Which levels of a texture a fragment reads, and by which filter.
namespace twofold {

/// Base-2 logarithm; exact for powers of two, so that a texture drawn at half its size has level of
/// detail 1 and not nearly 1. Below 2^-1022, 0 and NaN included, it is -1022.
inline double log2_of(double x) {
    constexpr double log2_e = 0x1.71547652b82fep+0;
    constexpr std::uint64_t fraction_bits = 0x000fffffffffffff, one = 0x3ff0000000000000;
    if (!(x >= 0x1p-1022)) return -1022.0;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const double exponent = static_cast<double>(bits >> 52) - 1023.0;
    const double mantissa = std::bit_cast<double>((bits & fraction_bits) | one);
    return exponent + exact::log(mantissa) * log2_e;
}

/// rho^2: the square of the longer of the two ways, in texels of the base image, that one pixel in
/// x and one pixel in y make in the texture. Derivatives are differences to the neighbour pixels.
/// @source OpenGL 1.3, equation 3.18
template <class Real>
double squared_scale(const TexelPoint<Real>& here, const TexelPoint<Real>& right,
                     const TexelPoint<Real>& below) {
    const auto square = [&here](const TexelPoint<Real>& there) {
        const auto du = static_cast<double>(there.u - here.u);
        const auto dv = static_cast<double>(there.v - here.v);
        return du * du + dv * dv;
    };
    const double x = square(right), y = square(below);
    return x < y ? y : x;
}

/// lambda = log2(rho) + bias, from rho^2. In binary64 under every preset.
inline double level_of_detail(double squared_rho, double bias) {
    return 0.5 * log2_of(squared_rho) + bias;
}

/// Whether there are levels to choose from. Rectangles have one.
constexpr bool chooses_level(const TextureUnitState& unit, bool has_mipmaps) {
    return unit.mip_filter != MipFilter::off && has_mipmaps &&
           unit.target != TextureTarget::rectangle;
}

/// Whether a unit needs to know how the texture is scaled on the screen: if its two filters differ,
/// or if there are levels to choose from.
constexpr bool needs_derivatives(const TextureUnitState& unit, bool has_mipmaps) {
    return unit.min_filter != unit.mag_filter || chooses_level(unit, has_mipmaps);
}

/// The one or two levels a fragment reads, each by `filter`; `fraction` is the share of the coarser
/// one, 0 if there is no second.
struct LevelSelection {
    Filter filter = Filter::nearest;
    int fine = 0;
    int coarse = 0;
    double fraction = 0.0;
};

/// The level next to lambda; half-way between two it is the finer.
/// @source OpenGL 1.3, 3.8.8, "mipmapping": d = ceil(lambda + 1/2) - 1, written so that nothing is
/// rounded
inline int nearest_level(double lambda, int last_level) {
    if (lambda <= 0.5) return 0;
    if (lambda > last_level + 0.5) return last_level;
    return -static_cast<int>(std::floor(0.5 - lambda));
}

/// The level of detail up to which the base is magnified.
/// @source OpenGL 1.3, 3.8.9
constexpr double magnified_to(const TextureUnitState& unit, bool mipmapped) {
    const bool late =
        mipmapped && unit.mag_filter == Filter::linear && unit.min_filter == Filter::nearest;
    return late ? 0.5 : 0.0;
}

/// @param last_level  index of the coarsest level; 0 means that there are no mipmaps, and the base
///                    image is used whatever the mipmap filter says
/// @source OpenGL 1.3, 3.8.8
inline LevelSelection select_levels(const TextureUnitState& unit, double lambda, int last_level) {
    const bool mipmapped = unit.mip_filter != MipFilter::off && last_level > 0;
    if (lambda <= magnified_to(unit, mipmapped)) return {unit.mag_filter, 0, 0, 0.0};
    if (!mipmapped) return {unit.min_filter, 0, 0, 0.0};
    if (unit.mip_filter == MipFilter::nearest) {
        const int level = nearest_level(lambda, last_level);
        return {unit.min_filter, level, level, 0.0};
    }
    if (lambda >= last_level) return {unit.min_filter, last_level, last_level, 0.0};
    const int fine = static_cast<int>(lambda);
    return {unit.min_filter, fine, fine + 1, lambda - fine};
}

}  // namespace twofold
