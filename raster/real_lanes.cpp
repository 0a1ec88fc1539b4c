#include <algorithm>
#include <bit>

#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/real_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_reals-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
void interpolate_reals(const Triangle& t, const RealCorners<Real>& c, const Shader<Color<Real>>& s,
                       std::size_t count, RealBatch<Real>& out) {
    place_reals(t, c, s, count, out);
    Color<Real>* const color = out.color.data() + out.size;
    if (c.one_color)
        std::fill_n(color, count, *c.colors[0]);
    else
        iterate_reals(t, c, out.places.at.data() + out.size, count, color);
    out.size += count;
}

/// RealModel on vectors.
template <class Real>
struct RealArithmetic {
    static constexpr Real one() { return Real{1}; }

    template <class R>
    static HWY_INLINE hn::Vec<R> filter(R r, const Quad<R>& t, hn::Vec<R> a, hn::Vec<R> b) {
        return filter_levels(r, filter_levels(r, t.t00, t.t10, a),
                             filter_levels(r, t.t01, t.t11, a), b);
    }
    template <class R>
    static HWY_INLINE hn::Vec<R> filter_levels(R r, hn::Vec<R> p, hn::Vec<R> q, hn::Vec<R> w) {
        return hn::Add(hn::Mul(hn::Sub(hn::Set(r, one()), w), p), hn::Mul(w, q));
    }
    template <class R>
    static HWY_INLINE hn::Vec<R> modulate(R, hn::Vec<R> a, hn::Vec<R> b) {
        return hn::Mul(a, b);
    }
    template <class R>
    static HWY_INLINE hn::Vec<R> finish(R r, hn::Vec<R> c) {
        return clamped(r, c, one());
    }
};

void round_f64(double factor, RealBatch<double>& batch) {
    const D d;
    const hn::Rebind<std::uint8_t, D> bytes;
    const double* const from = batch.color.front().data();
    auto* const to = reinterpret_cast<std::uint8_t*>(batch.rounded.data());
    for (std::size_t i = 0; i < 4 * batch.size; i += hn::Lanes(d)) {
        const V raised =
            hn::Add(hn::Mul(hn::Set(d, factor), hn::LoadU(d, from + i)), hn::Set(d, 0.5));
        hn::StoreU(hn::DemoteTo(bytes, hn::DemoteTo(I(), raised)), bytes, to + i);
    }
    if constexpr (std::endian::native == std::endian::big)
        for (std::size_t i = 0; i < batch.size; ++i)
            batch.rounded[i] = __builtin_bswap32(batch.rounded[i]);
}

void interpolate_f64(const Triangle& t, const RealCorners<double>& c,
                     const Shader<Color<double>>& s, std::size_t count, RealBatch<double>& out) {
    interpolate_reals(t, c, s, count, out);
}
void interpolate_f32(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                     std::size_t count, RealBatch<float>& out) {
    interpolate_reals(t, c, s, count, out);
}
void shade_f64(const Shader<Color<double>>& s, RealBatch<double>& batch) {
    shade_fragments(s, RealArithmetic<double>(), batch);
}
void shade_f32(const Shader<Color<float>>& s, RealBatch<float>& batch) {
    shade_fragments(s, RealArithmetic<float>(), batch);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(interpolate_f64);
HWY_EXPORT(interpolate_f32);
HWY_EXPORT(shade_f64);
HWY_EXPORT(shade_f32);
HWY_EXPORT(round_f64);

void interpolate(const Triangle& t, const RealCorners<double>& c, const Shader<Color<double>>& s,
                 std::size_t count, RealBatch<double>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f64)(t, c, s, count, out);
}
void interpolate(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                 std::size_t count, RealBatch<float>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f32)(t, c, s, count, out);
}
void shade(const Shader<Color<double>>& s, RealBatch<double>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_f64)(s, batch);
}
void shade(const Shader<Color<float>>& s, RealBatch<float>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_f32)(s, batch);
}
void round_to_bytes(double factor, RealBatch<double>& batch) {
    HWY_DYNAMIC_DISPATCH(round_f64)(factor, batch);
}

}  // namespace twofold::lanes
#endif
