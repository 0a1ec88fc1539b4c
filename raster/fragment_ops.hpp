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

/// The blend factor of channel c (3 is alpha). @source OpenGL 1.3, tables 4.1 and 4.2
template <NumericModel M>
typename M::Pixel blend_factor(BlendFactor factor, std::size_t c,
                               const Color<typename M::Pixel>& source,
                               const Color<typename M::Pixel>& destination) {
    const auto one = M::pixel(1.0);
    switch (factor) {
        case BlendFactor::zero:
            return M::pixel(0.0);
        case BlendFactor::one:
            return one;
        case BlendFactor::src_color:
            return source[c];
        case BlendFactor::one_minus_src_color:
            return one - source[c];
        case BlendFactor::dst_color:
            return destination[c];
        case BlendFactor::one_minus_dst_color:
            return one - destination[c];
        case BlendFactor::src_alpha:
            return source[3];
        case BlendFactor::one_minus_src_alpha:
            return one - source[3];
        case BlendFactor::dst_alpha:
            return destination[3];
        case BlendFactor::one_minus_dst_alpha:
            return one - destination[3];
        case BlendFactor::src_alpha_saturate:
            break;
    }
    if (c == 3) return one;
    const auto room = one - destination[3];
    return source[3] < room ? source[3] : room;
}

template <NumericModel M>
Color<typename M::Pixel> blended(const Blend& blend, const Color<typename M::Pixel>& source,
                                 const Color<typename M::Pixel>& destination) {
    Color<typename M::Pixel> result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] =
            M::blend(source[c], blend_factor<M>(blend.source, c, source, destination),
                     destination[c], blend_factor<M>(blend.destination, c, source, destination));
    return result;
}

}  // namespace twofold
