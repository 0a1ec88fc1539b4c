// What triangles give their fragments, on vectors, compiled once for each instruction set: no
// #pragma once.
#include <type_traits>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_math-inl.hpp"
#include "raster/lanes.hpp"

#if defined(TWOFOLD_LANE_WEIGHTS) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_WEIGHTS
#undef TWOFOLD_LANE_WEIGHTS
#else
#define TWOFOLD_LANE_WEIGHTS
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// Four numbers side by side, on one vector or more.
using Four = hn::CappedTag<double, 4>;

/// Doubled areas at some pixels, or what coordinates are weighed by.
template <class R>
struct Weights {
    hn::Vec<R> e0, e1, e2;
};

/// Pixels of a triangle, counted from its (x0, y0): as many as a vector of binary64 holds.
struct Pixels {
    V x, y;
};

HWY_INLINE Pixels pixels_at(const Triangle& t, const std::int32_t* places) {
    const D d;
    const I di;
    const auto v = hn::LoadU(di, places);
    const auto column = hn::And(v, hn::Set(di, tile_edge - 1));
    const auto row = hn::ShiftRight<tile_edge_bits>(v);
    return {hn::PromoteTo(d, hn::Sub(column, hn::Set(di, t.x0))),
            hn::PromoteTo(d, hn::Sub(row, hn::Set(di, t.y0)))};
}

HWY_INLINE Weights<D> areas_at(const Triangle& t, const Pixels& p) {
    const V e1 = at(t.e[1], p.x, p.y), e2 = at(t.e[2], p.x, p.y);
    return {hn::Sub(hn::Sub(hn::Set(D(), t.area), e1), e2), e1, e2};
}
HWY_INLINE Weights<D> areas_at(const Triangle& t, const std::int32_t* places) {
    return areas_at(t, pixels_at(t, places));
}

/// In a format whose vectors have as many lanes as those of binary64, or twice as many.
template <class R>
HWY_INLINE Weights<R> weights_at(R r, const Triangle& t, const std::int32_t* places) {
    const Weights<D> low = areas_at(t, places);
    if constexpr (std::is_same_v<hn::TFromD<R>, double>) {
        return low;
    } else {
        const Weights<D> high = areas_at(t, places + hn::Lanes(D()));
        const auto joined = [&](V from_low, V from_high) HWY_ATTR {
            const hn::Rebind<float, D> half;
            return hn::Combine(r, hn::DemoteTo(half, from_high), hn::DemoteTo(half, from_low));
        };
        return {joined(low.e0, high.e0), joined(low.e1, high.e1), joined(low.e2, high.e2)};
    }
}

/// Doubled areas times 1/w.
template <class R>
HWY_INLINE Weights<R> over_w(R r, const Triangle& t, const Weights<R>& w) {
    const auto over = [&](std::size_t k) HWY_ATTR {
        return hn::Set(r, static_cast<hn::TFromD<R>>(t.inverse_w[k]));
    };
    return {hn::Mul(w.e0, over(0)), hn::Mul(w.e1, over(1)), hn::Mul(w.e2, over(2))};
}

/// cut_within() of byte_arithmetic.hpp.
HWY_INLINE V cut_within(V x, V most) {
    return hn::Trunc(hn::IfThenElseZero(hn::Gt(x, hn::Zero(D())), hn::Min(x, most)));
}

/// 256 times the weights of the first and the third vertex in Nv17::iterate_color.
struct EndWeights {
    V n0, n2;
};

HWY_INLINE EndWeights end_weights(const Triangle& t, const std::int32_t* places) {
    const D d;
    const V steps = hn::Set(d, 256.0);
    Weights<D> w = areas_at(t, places);
    V sum = hn::Set(d, t.area);
    if (!t.equal_w) {
        w = over_w(d, t, w);
        sum = hn::Add(hn::Add(w.e0, w.e1), w.e2);
    }
    const V n0 = cut_within(hn::Div(hn::Mul(steps, w.e0), sum), steps);
    return {n0, cut_within(hn::Div(hn::Mul(steps, w.e2), sum), hn::Sub(steps, n0))};
}

/// coordinate_weights() of interpolate.hpp, from the doubled areas.
template <class R, class Channel>
HWY_INLINE Weights<R> coordinate_weights(R r, const Triangle& t,
                                         const Corners<hn::TFromD<R>, Channel>& c,
                                         const Weights<R>& areas) {
    return c.over_w || t.equal_w ? areas : over_w(r, t, areas);
}
template <class R, class Channel>
HWY_INLINE Weights<R> coordinate_weights(R r, const Triangle& t,
                                         const Corners<hn::TFromD<R>, Channel>& c,
                                         const std::int32_t* places) {
    return coordinate_weights(r, t, c, weights_at(r, t, places));
}

/// interpolate_coords() of interpolate.hpp.
template <class R, class Channel>
HWY_INLINE Coordinates<R> coordinates_at(R r, const Corners<hn::TFromD<R>, Channel>& c,
                                         std::size_t u, const Weights<R>& w) {
    const auto [v0, v1, v2] = c.coords[u];
    const auto sum = [&, v0 = v0, v1 = v1, v2 = v2](std::size_t k) HWY_ATTR {
        return hn::Add(
            hn::Add(hn::Mul(w.e0, hn::Set(r, (*v0)[k])), hn::Mul(w.e1, hn::Set(r, (*v1)[k]))),
            hn::Mul(w.e2, hn::Set(r, (*v2)[k])));
    };
    return {sum(0), sum(1), sum(3)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
