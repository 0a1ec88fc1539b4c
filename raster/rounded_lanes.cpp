#include <algorithm>

#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/rounded_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_reals-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

// ----------------------------------------------------------------------------------- interpolation

/// Nv17::iterate_color.
void iterate_weighted(const Triangle& t, const RealCorners<double>& c, const std::int32_t* at,
                      std::size_t size, Color<double>* out) {
    const D d;
    const Four four;
    alignas(64) double n0[hn::MaxLanes(d)], n2[hn::MaxLanes(d)];
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        const EndWeights w = end_weights(t, at + i);
        hn::StoreU(w.n0, d, n0);
        hn::StoreU(w.n2, d, n2);
        const std::size_t count = HWY_MIN(hn::Lanes(d), size - i);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t ch = 0; ch < 4; ch += hn::Lanes(four)) {
                const auto weighted = [&](std::size_t v, double weight) HWY_ATTR {
                    return hn::Mul(hn::Set(four, weight),
                                   hn::LoadU(four, c.colors[v]->data() + ch));
                };
                const auto sum =
                    hn::Add(hn::Add(weighted(0, n0[k]), weighted(1, 256.0 - n0[k] - n2[k])),
                            hn::Add(weighted(2, n2[k]), hn::Set(four, 128.0)));
                hn::StoreU(hn::Floor(hn::Mul(sum, hn::Set(four, 1.0 / 256.0))), four,
                           out[i + k].data() + ch);
            }
    }
}

/// Coarse8::iterate_color.
void iterate_cut(const Triangle& t, const RealCorners<double>& c, const std::int32_t* at,
                 std::size_t size, Color<double>* out) {
    const D d;
    iterate_reals(t, c, at, size, out);
    double* const channels = out->data();
    for (std::size_t i = 0; i < 4 * size; i += hn::Lanes(d))
        hn::StoreU(cut_within(hn::LoadU(d, channels + i), hn::Set(d, 255.0)), d, channels + i);
}

void interpolate_rounded(const Triangle& t, const ByteCorners& c, const RoundedShader& s,
                         std::size_t count, RealBatch<double>& out) {
    std::array<Color<double>, 3> colors;
    for (std::size_t k = 0; k < 3; ++k)
        std::copy(c.colors[k]->begin(), c.colors[k]->end(), colors[k].begin());
    const RealCorners<double> corners{
        c.coords, {&colors[0], &colors[1], &colors[2]}, c.over_w, c.one_color, c.choose_level};
    place_reals(t, corners, s, count, out);
    const std::int32_t* const at = out.places.at.data() + out.size;
    Color<double>* const color = out.color.data() + out.size;
    if (c.one_color)
        std::fill_n(color, count, colors[0]);
    else if (s.rounding.cuts_colors)
        iterate_cut(t, corners, at, count, color);
    else
        iterate_weighted(t, corners, at, count, color);
    out.size += count;
}

// ----------------------------------------------------------------------------------------- shading

/// Nv17::cut_weight of some fractions: they stay fractions.
void cut_weights(double steps, std::size_t size, double* fractions) {
    const D d;
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        const V weight = hn::Floor(hn::Mul(hn::LoadU(d, fractions + i), hn::Set(d, steps)));
        const V held = hn::Min(weight, hn::Set(d, steps - 1.0));
        hn::StoreU(hn::Mul(held, hn::Set(d, 1.0 / steps)), d, fractions + i);
    }
}

/// Custom's and Coarse8's arithmetic. Every number before a floor is exact (Rounding).
template <bool filters_once>
struct RoundedArithmetic {
    Rounding rule;

    double one() const { return rule.one; }

    /// p (1 - w) + q w.
    static HWY_INLINE V mix(V p, V q, V w) { return hn::Add(p, hn::Mul(hn::Sub(q, p), w)); }

    HWY_INLINE V cut(V x) const { return hn::Floor(hn::Add(x, hn::Set(D(), rule.filter_half))); }

    HWY_INLINE V filter(D, const Quad<D>& t, V a, V b) const {
        const V row0 = mix(t.t00, t.t10, a), row1 = mix(t.t01, t.t11, a);
        if constexpr (filters_once) return cut(mix(row0, row1, b));
        return cut(mix(cut(row0), cut(row1), b));
    }
    HWY_INLINE V filter_levels(D, V fine, V coarse, V share) const {
        return cut(mix(fine, coarse, share));
    }
    HWY_INLINE V modulate(D d, V a, V b) const {
        const V sum = hn::Add(hn::Mul(a, b), hn::Set(d, rule.product.add));
        return hn::Floor(hn::Mul(sum, hn::Set(d, rule.product.factor)));
    }
    HWY_INLINE V finish(D d, V c) const {
        const V byte = hn::Mul(c, hn::Set(d, rule.finish_factor));
        const V whole =
            rule.finish_rounds ? hn::Floor(hn::Add(byte, hn::Set(d, rule.finish_half))) : byte;
        return clamped(d, whole, 255.0);
    }
};

void shade_rounded(const RoundedShader& s, RealBatch<double>& batch) {
    const auto cut = [&](BatchColumn<double>& fractions) {
        cut_weights(s.rounding.weight_steps, batch.size, fractions.data());
    };
    for (std::size_t u = 0; u < s.units; ++u) {
        cut(batch.fine[u].a);
        cut(batch.fine[u].b);
        if (!s.unit[u].rule.blends) continue;
        cut(batch.coarse[u].a);
        cut(batch.coarse[u].b);
        cut(batch.coarse_share[u]);
    }
    if (s.rounding.filters_once)
        shade_fragments(s, RoundedArithmetic<true>{s.rounding}, batch);
    else
        shade_fragments(s, RoundedArithmetic<false>{s.rounding}, batch);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(interpolate_rounded);
HWY_EXPORT(shade_rounded);

void interpolate(const Triangle& t, const ByteCorners& c, const RoundedShader& s, std::size_t count,
                 RealBatch<double>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_rounded)(t, c, s, count, out);
}
void shade(const RoundedShader& s, RealBatch<double>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_rounded)(s, batch);
}

}  // namespace twofold::lanes
#endif
