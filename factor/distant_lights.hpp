#pragma once
#include <cstddef>
#include <vector>

#include "texunit/linear.hpp"

namespace twofold {

/// Lights of one block: the unit in which the lighting sum is formed (docs/exactness.md, section
/// 3).
inline constexpr std::size_t light_block = 256;

/// Lights of one patch: a quarter of a block, the least that is left out of a sum as a whole.
/// Smaller ones would leave out more, but begin and end the inner loops more often.
inline constexpr std::size_t light_patch = 64;

/// A cone of directions around every light of one patch, apex at the shaded point.
struct LightCone {
    Vec3 axis;  ///< unit, world space
    double sine =
        2.0;  ///< sine of the half angle, rounded up; 2 where the cone is a half space or more
    bool dark = false;  ///< every weight of the patch is 0
};

/// An environment as infinitely distant point lights, the finite sum that *defines* the lighting
/// function here (docs/method.md, section 2). Structure of arrays, light k at index k of each.
struct DistantLights {
    std::vector<double> x, y, z;   ///< unit direction to the light, world space
    std::vector<double> r, g, b;   ///< W = radiance * solid angle, >= 0
    std::vector<LightCone> cones;  ///< one a patch, by bound_blocks(); empty: nothing is left out

    std::size_t size() const { return x.size(); }
    std::size_t blocks() const { return (size() + light_block - 1) / light_block; }
    Vec3 direction(std::size_t k) const { return {x[k], y[k], z[k]}; }
    Rgb weight(std::size_t k) const { return {r[k], g[k], b[k]}; }
    void push_back(Vec3 direction, Rgb weight);
};

/// The lights in a frame that `turn` takes the world to.
DistantLights turned(const DistantLights& lights, const Mat3& turn);

/// The same lights with the cone of each patch filled in; the lighting sum is the same to the last
/// bit and faster. To be called after the last push_back.
DistantLights bound_blocks(DistantLights lights);

}  // namespace twofold
