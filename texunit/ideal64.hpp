#pragma once
#include "texunit/real_model.hpp"

namespace twofold {

/// Truth: binary64 throughout. Its snap grid of 1/4096 pixel keeps coverage exact in integers and
/// is finer than any figure can see.
struct Ideal64 : RealModel<double> {
    using Depth = double;
    static constexpr Preset preset = Preset::ideal64;

    static SnapRule snap() { return {12, 1.0 / 8192.0}; }
    static Depth depth(double z, int) { return z; }
};

static_assert(NumericModel<Ideal64>);

}  // namespace twofold
