#pragma once
#include "texunit/real_model.hpp"

namespace twofold {

/// Binary32 throughout, one rounding an operation: what a floating-point GPU of a later generation
/// computes.
struct Float32 : RealModel<float> {
    using Depth = std::uint32_t;
    static constexpr Preset preset = Preset::float32;

    static SnapRule snap() { return {4, 1.0 / 32.0}; }
    static Depth depth(double z, int bits) { return depth_rounded(z, bits); }
};

static_assert(NumericModel<Float32>);

}  // namespace twofold
