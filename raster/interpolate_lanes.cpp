#include <algorithm>
#include <cmath>

#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/interpolate_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// Doubled areas at some pixels of a span.
struct Weights {
    V e0, e1, e2;
};

HWY_INLINE Weights weights_at(const Triangle& t, const Span& span, std::size_t i) {
    const D d;
    const V e1 = hn::Load(d, span.e1.data() + i), e2 = hn::Load(d, span.e2.data() + i);
    return {hn::Sub(hn::Sub(hn::Set(d, t.area), e1), e2), e1, e2};
}

HWY_INLINE V as_real(D, V v) { return v; }
template <class F>
HWY_INLINE hn::Vec<F> as_real(F f, V v) {
    return hn::DemoteTo(f, v);
}

template <class Real>
using Narrow = hn::Rebind<Real, D>;

/// The coordinates of one unit at a vector of a span, as interpolate_coords() of interpolate.hpp
/// computes them.
template <class Real>
HWY_INLINE Coordinates<Narrow<Real>> coordinates_at(const Triangle& t, const Corners<Real>& c,
                                                    std::size_t u, const Weights& w) {
    const Narrow<Real> r;
    auto w0 = as_real(r, w.e0), w1 = as_real(r, w.e1), w2 = as_real(r, w.e2);
    if (!c.over_w && !t.equal_w) {
        w0 = hn::Mul(w0, hn::Set(r, static_cast<Real>(t.inverse_w[0])));
        w1 = hn::Mul(w1, hn::Set(r, static_cast<Real>(t.inverse_w[1])));
        w2 = hn::Mul(w2, hn::Set(r, static_cast<Real>(t.inverse_w[2])));
    }
    const auto sum = [&](const std::array<Real, 3>& v) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(w0, hn::Set(r, v[0])), hn::Mul(w1, hn::Set(r, v[1]))),
                       hn::Mul(w2, hn::Set(r, v[2])));
    };
    return {sum(c.coords[u][0]), sum(c.coords[u][1]), sum(c.coords[u][2])};
}

/// A number that is linear in the window: first + e1 per_e1 + e2 per_e2.
struct Linear {
    double first, per_e1, per_e2;

    Linear(const Triangle& t, const std::array<double, 3>& v)
        : first(v[0] * t.area), per_e1(v[1] - v[0]), per_e2(v[2] - v[0]) {}

    HWY_INLINE V at(V e1, V e2) const {
        const D d;
        return hn::Add(hn::Set(d, first), hn::Add(hn::Mul(e1, hn::Set(d, per_e1)),
                                                  hn::Mul(e2, hn::Set(d, per_e2))));
    }
};

double largest(const std::array<double, 3>& v) {
    return std::max(std::max(std::fabs(v[0]), std::fabs(v[1])), std::fabs(v[2]));
}

/// A unit's place in its texture as two linear numbers over a third: in 1/256 texel from the centre
/// of texel (0, 0). Near the reference's numbers by far less than `doubt` if it is `usable`.
struct Near {
    std::array<double, 3> x, y, q;
    bool usable;

    Near(const Triangle& t, const Corners<double>& c, const Shader<std::uint32_t>& s,
         std::size_t u) {
        usable = false;
        x = y = q = {};
        if (u >= s.units || !knows_reciprocals(s.unit[u])) return;
        const Image<std::uint32_t>& image = s.unit[u].image;
        for (std::size_t k = 0; k < 3; ++k) {
            const double w = c.over_w || t.equal_w ? 1.0 : t.inverse_w[k];
            q[k] = w * c.coords[u][2][k];
            x[k] = w * c.coords[u][0][k] * (256.0 * image.width) - 128.0 * q[k];
            y[k] = w * c.coords[u][1][k] * (256.0 * image.height) - 128.0 * q[k];
        }
        // Both this and the reference stray by 2^-49 of the largest place, times the spread of q.
        const double least = std::min(std::min(std::fabs(q[0]), std::fabs(q[1])),
                                     std::fabs(q[2]));
        usable = largest(x) <= 0x1p26 * least && largest(y) <= 0x1p26 * least &&
                 largest(q) <= 0x1p10 * least;
    }
};

/// The same for both units: one reciprocal serves them.
bool same_q(const Near& a, const Near& b) { return a.usable && b.usable && a.q == b.q; }

/// Footprints by linear numbers and a reciprocal where no doubt is left, else as the reference does.
void place_near(const Triangle& t, const Corners<double>& c, const Shader<std::uint32_t>& s,
                std::size_t first, std::size_t units, const std::array<Near, lane_units>& near,
                const Span& span, ByteBatch& out) {
    const D d;
    const I di;
    const Linear lq(t, near[first].q);
    const std::array<Linear, lane_units> lx{Linear(t, near[0].x), Linear(t, near[1].x)};
    const std::array<Linear, lane_units> ly{Linear(t, near[0].y), Linear(t, near[1].y)};
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(d)) {
        const V e1 = hn::Load(d, span.e1.data() + i), e2 = hn::Load(d, span.e2.data() + i);
        const V over_q = near_reciprocal(lq.at(e1, e2));
        for (std::size_t u = first; u < first + units; ++u) {
            const V x = hn::Mul(lx[u].at(e1, e2), over_q), y = hn::Mul(ly[u].at(e1, e2), over_q);
            const V fx = hn::Floor(x), fy = hn::Floor(y);
            const Footprint8 f =
                HWY_LIKELY(!in_doubt(x, fx, y, fy))
                    ? footprint_at(s.unit[u].image, fx, fy)
                    : footprint_by_division(s.unit[u],
                                            coordinates_at(t, c, u, weights_at(t, span, i)));
            const std::size_t to = out.size + i;
            hn::StoreU(f.offset, di, out.offset[u].data() + to);
            hn::StoreU(f.weights, di, reinterpret_cast<std::int32_t*>(out.weights[u].data() + to));
        }
    }
}

void place_exactly(const Triangle& t, const Corners<double>& c, const Unit<std::uint32_t>& unit,
                   std::size_t u, const Span& span, ByteBatch& out) {
    const I di;
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(di)) {
        const Footprint8 f =
            footprint_by_division(unit, coordinates_at(t, c, u, weights_at(t, span, i)));
        const std::size_t to = out.size + i;
        hn::StoreU(f.offset, di, out.offset[u].data() + to);
        hn::StoreU(f.weights, di, reinterpret_cast<std::int32_t*>(out.weights[u].data() + to));
    }
}

void place_bytes(const Triangle& t, const Corners<double>& c, const Shader<std::uint32_t>& s,
                 const Span& span, ByteBatch& out) {
    const std::array<Near, lane_units> near{Near(t, c, s, 0), Near(t, c, s, 1)};
    if (same_q(near[0], near[1])) return place_near(t, c, s, 0, s.units, near, span, out);
    for (std::size_t u = 0; u < s.units; ++u) {
        if (near[u].usable)
            place_near(t, c, s, u, 1, near, span, out);
        else
            place_exactly(t, c, s.unit[u], u, span, out);
    }
}

template <class Real>
void place_reals(const Triangle& t, const Corners<Real>& c, const Unit<Color<Real>>& unit,
                 std::size_t u, const Span& span, RealBatch<Real>& out) {
    const Narrow<Real> r;
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(r)) {
        const auto f = footprint(r, unit, coordinates_at(t, c, u, weights_at(t, span, i)));
        hn::StoreU(f.offset, I(), out.offset[u].data() + out.size + i);
        hn::StoreU(f.a, r, out.a[u].data() + out.size + i);
        hn::StoreU(f.b, r, out.b[u].data() + out.size + i);
    }
}

/// Nv17::iterate_color.
void iterate_bytes(const Triangle& t, const Corners<double>& c, const Span& span,
                   std::uint32_t* out) {
    const D d;
    const I di;
    const V steps = hn::Set(d, 256.0);
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(d)) {
        const Weights w = weights_at(t, span, i);
        V l0 = w.e0, l2 = w.e2, sum = hn::Set(d, t.area);
        if (!t.equal_w) {
            l0 = hn::Mul(w.e0, hn::Set(d, t.inverse_w[0]));
            l2 = hn::Mul(w.e2, hn::Set(d, t.inverse_w[2]));
            sum = hn::Add(hn::Add(l0, hn::Mul(w.e1, hn::Set(d, t.inverse_w[1]))), l2);
        }
        const auto n0 = hn::DemoteTo(di, hn::Div(hn::Mul(steps, l0), sum));
        const auto n2 = hn::DemoteTo(di, hn::Div(hn::Mul(steps, l2), sum));
        const auto n1 = hn::Sub(hn::Sub(hn::Set(di, 256), n0), n2);
        const auto channel = [&](std::size_t k) HWY_ATTR {
            const auto value = hn::Add(hn::Add(hn::Mul(n0, hn::Set(di, c.bytes[0][k])),
                                               hn::Mul(n1, hn::Set(di, c.bytes[1][k]))),
                                       hn::Mul(n2, hn::Set(di, c.bytes[2][k])));
            return hn::ShiftRight<8>(hn::Add(value, hn::Set(di, 128)));
        };
        const auto color = hn::Or(hn::Or(channel(0), hn::ShiftLeft<8>(channel(1))),
                                  hn::Or(hn::ShiftLeft<16>(channel(2)),
                                         hn::ShiftLeft<24>(channel(3))));
        hn::StoreU(color, di, reinterpret_cast<std::int32_t*>(out + i));
    }
}

/// RealModel::iterate_color, the four channels of a fragment side by side.
template <class Real>
void iterate_reals(const Triangle& t, const Corners<Real>& c, const Span& span, Color<Real>* out) {
    const Narrow<Real> r;
    const hn::CappedTag<Real, 4> four;
    alignas(64) Real l1[hn::MaxLanes(r)], l2[hn::MaxLanes(r)], sum[hn::MaxLanes(r)];
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(r)) {
        const Weights w = weights_at(t, span, i);
        const auto over = [&](V e, std::size_t k) HWY_ATTR {
            return hn::Mul(as_real(r, e), hn::Set(r, static_cast<Real>(t.inverse_w[k])));
        };
        const auto p0 = over(w.e0, 0), p1 = over(w.e1, 1), p2 = over(w.e2, 2);
        hn::StoreU(p1, r, l1);
        hn::StoreU(p2, r, l2);
        hn::StoreU(hn::Add(hn::Add(p0, p1), p2), r, sum);
        const std::size_t count = HWY_MIN(hn::Lanes(r), span.size - i);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t ch = 0; ch < 4; ch += hn::Lanes(four)) {
                const auto c0 = hn::LoadU(four, c.reals[0].data() + ch);
                const auto d1 = hn::Sub(hn::LoadU(four, c.reals[1].data() + ch), c0);
                const auto d2 = hn::Sub(hn::LoadU(four, c.reals[2].data() + ch), c0);
                const auto more = hn::Add(hn::Mul(hn::Set(four, l1[k]), d1),
                                          hn::Mul(hn::Set(four, l2[k]), d2));
                hn::StoreU(hn::Add(c0, hn::Div(more, hn::Set(four, sum[k]))), four,
                           out[i + k].data() + ch);
            }
    }
}

void copy_places(const Span& span, BatchPlaces& out, std::size_t size) {
    const D d;
    const I di;
    auto* const at = reinterpret_cast<std::int32_t*>(out.at.data() + size);
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(d)) {
        hn::StoreU(hn::DemoteTo(di, hn::Load(d, span.at.data() + i)), di, at + i);
        hn::StoreU(hn::Load(d, span.z.data() + i), d, out.z.data() + size + i);
    }
}

void interpolate_u8(const Triangle& t, const Corners<double>& c, const Shader<std::uint32_t>& s,
                    const Span& span, ByteBatch& out) {
    place_bytes(t, c, s, span, out);
    copy_places(span, out.places, out.size);
    if (c.one_color) {
        const std::uint32_t color = packed_bytes(c.bytes[0]);
        for (std::size_t i = 0; i < span.size; ++i) out.color[out.size + i] = color;
    } else {
        iterate_bytes(t, c, span, out.color.data() + out.size);
    }
    out.size += span.size;
}

template <class Real>
void interpolate_reals(const Triangle& t, const Corners<Real>& c, const Shader<Color<Real>>& s,
                       const Span& span, RealBatch<Real>& out) {
    for (std::size_t u = 0; u < s.units; ++u) place_reals(t, c, s.unit[u], u, span, out);
    copy_places(span, out.places, out.size);
    if (c.one_color)
        for (std::size_t i = 0; i < span.size; ++i) out.color[out.size + i] = c.reals[0];
    else
        iterate_reals(t, c, span, out.color.data() + out.size);
    out.size += span.size;
}

void interpolate_f64(const Triangle& t, const Corners<double>& c, const Shader<Color<double>>& s,
                     const Span& span, RealBatch<double>& out) {
    interpolate_reals(t, c, s, span, out);
}
void interpolate_f32(const Triangle& t, const Corners<float>& c, const Shader<Color<float>>& s,
                     const Span& span, RealBatch<float>& out) {
    interpolate_reals(t, c, s, span, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(interpolate_u8);
HWY_EXPORT(interpolate_f64);
HWY_EXPORT(interpolate_f32);

void interpolate(const Triangle& t, const Corners<double>& c, const Shader<std::uint32_t>& s,
                 const Span& span, ByteBatch& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_u8)(t, c, s, span, out);
}
void interpolate(const Triangle& t, const Corners<double>& c, const Shader<Color<double>>& s,
                 const Span& span, RealBatch<double>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f64)(t, c, s, span, out);
}
void interpolate(const Triangle& t, const Corners<float>& c, const Shader<Color<float>>& s,
                 const Span& span, RealBatch<float>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f32)(t, c, s, span, out);
}

}  // namespace twofold::lanes
#endif
