#pragma once
#include "texunit/nv17.hpp"

namespace twofold {

/// The family of the GeForce3 and 4 Ti, closest to silicon that anybody can check: found exactly on
/// public captures of the NV2A. Where it has the rules of nv17, those were found here and inferred
/// there.
struct Nv2x : Nv17 {
    using Vertex = Nv2xArithmetic;
    static constexpr Preset preset = Preset::nv2x;
    /// Coordinates and 1/w are iterated apart. @source captures of NV2A: exact rational coordinates
    /// fit
    static constexpr bool coords_over_w = false;
    static constexpr int texture_units = 4;
    static constexpr int combiner_stages = 8;

    /// Without the 22-bit rounding of NV1x: 0.7 gives 178 in all four channels.
    static Color<int> vertex_color(const Color<nv1x::Word>& c) {
        return {nv1x::float_to_byte(c[0]), nv1x::float_to_byte(c[1]), nv1x::float_to_byte(c[2]),
                nv1x::float_to_byte(c[3])};
    }
};

static_assert(NumericModel<Nv2x>);

}  // namespace twofold
