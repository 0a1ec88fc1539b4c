#pragma once
#include "raster/pass.hpp"
#include "texunit/numeric_model.hpp"

namespace twofold {

/// @source OpenGL 1.3, 4.1.4 and 4.1.6: `incoming` stands on the left
template <class T>
constexpr bool compare(CompareFunc func, T incoming, T stored) {
    switch (func) {
        case CompareFunc::never:
            return false;
        case CompareFunc::less:
            return incoming < stored;
        case CompareFunc::equal:
            return incoming == stored;
        case CompareFunc::lequal:
            return incoming <= stored;
        case CompareFunc::greater:
            return incoming > stored;
        case CompareFunc::notequal:
            return incoming != stored;
        case CompareFunc::gequal:
            return incoming >= stored;
        case CompareFunc::always:
            break;
    }
    return true;
}

/// Everything that a blend reads.
template <NumericModel M>
struct BlendOperands {
    Color<typename M::Pixel> source, destination, constant;
};

/// The blend factor of channel c (3 is alpha). @source OpenGL 1.3, tables 4.1 and 4.2, ARB_imaging
template <NumericModel M>
typename M::Pixel blend_factor(const M& m, BlendFactor factor, std::size_t c,
                               const BlendOperands<M>& in) {
    const auto one = m.pixel(1.0);
    switch (factor) {
        case BlendFactor::zero:
            return m.pixel(0.0);
        case BlendFactor::one:
            return one;
        case BlendFactor::src_color:
            return in.source[c];
        case BlendFactor::one_minus_src_color:
            return one - in.source[c];
        case BlendFactor::dst_color:
            return in.destination[c];
        case BlendFactor::one_minus_dst_color:
            return one - in.destination[c];
        case BlendFactor::src_alpha:
            return in.source[3];
        case BlendFactor::one_minus_src_alpha:
            return one - in.source[3];
        case BlendFactor::dst_alpha:
            return in.destination[3];
        case BlendFactor::one_minus_dst_alpha:
            return one - in.destination[3];
        case BlendFactor::constant_color:
            return in.constant[c];
        case BlendFactor::one_minus_constant_color:
            return one - in.constant[c];
        case BlendFactor::constant_alpha:
            return in.constant[3];
        case BlendFactor::one_minus_constant_alpha:
            return one - in.constant[3];
        case BlendFactor::src_alpha_saturate:
            break;
    }
    if (c == 3) return one;
    const auto room = one - in.destination[3];
    return in.source[3] < room ? in.source[3] : room;
}

/// One channel. MIN and MAX ignore the factors.
template <NumericModel M>
typename M::Pixel blended_channel(const M& m, const Blend& blend, std::size_t c,
                                  const BlendOperands<M>& in) {
    const auto s = in.source[c], d = in.destination[c];
    if (blend.equation == BlendEquation::min) return d < s ? d : s;
    if (blend.equation == BlendEquation::max) return s < d ? d : s;
    const auto f = blend_factor(m, blend.source, c, in);
    const auto g = blend_factor(m, blend.destination, c, in);
    if (blend.equation == BlendEquation::subtract) return m.blend_subtract(s, f, d, g);
    if (blend.equation == BlendEquation::reverse_subtract) return m.blend_subtract(d, g, s, f);
    return m.blend(s, f, d, g);
}

template <NumericModel M>
Color<typename M::Pixel> blended(const M& m, const Blend& blend, const BlendOperands<M>& in) {
    return {blended_channel(m, blend, 0, in), blended_channel(m, blend, 1, in),
            blended_channel(m, blend, 2, in), blended_channel(m, blend, 3, in)};
}

}  // namespace twofold
