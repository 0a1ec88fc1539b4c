#pragma once
#include "texunit/presets.hpp"

/// A byte's way in and out of a model: `texel` is the way in, `finish` and `to_unorm8` the way out.
namespace twofold::laws {

/// Models hold no state but `custom`, whose initial settings are nv17's.
template <NumericModel M>
inline const M m{};

template <NumericModel M>
typename M::Channel in(int byte) {
    return m<M>.texel(Rgba8{static_cast<std::uint8_t>(byte), 0, 0, 0})[0];
}

template <NumericModel M>
int out(typename M::Channel c) {
    return m<M>.to_unorm8(m<M>.finish(c));
}

template <NumericModel M>
typename M::Pixel pixel_of(int byte) {
    return m<M>.finish(in<M>(byte));
}

}  // namespace twofold::laws
