#include "raster/lanes.hpp"

#include "raster/lane_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

// ------------------------------------------------------------------------------------- coverage

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
using I = hn::Rebind<std::int32_t, D>;

HWY_INLINE Mask passes(CompareFunc func, V z, V stored) {
    const D d;
    switch (func) {
        case CompareFunc::never:
            return hn::FirstN(d, 0);
        case CompareFunc::less:
            return hn::Lt(z, stored);
        case CompareFunc::equal:
            return hn::Eq(z, stored);
        case CompareFunc::lequal:
            return hn::Le(z, stored);
        case CompareFunc::greater:
            return hn::Gt(z, stored);
        case CompareFunc::notequal:
            return hn::Ne(z, stored);
        case CompareFunc::gequal:
            return hn::Ge(z, stored);
        case CompareFunc::always:
            break;
    }
    return hn::FirstN(d, hn::Lanes(d));
}

/// The mask of as many narrower lanes.
template <class Narrow>
HWY_INLINE hn::Mask<Narrow> narrowed(Narrow narrow, Mask m) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), m, bits);
    return hn::LoadMaskBits(narrow, bits);
}

/// Depth as the buffer holds it, still in binary64.
HWY_INLINE V quantised(const DepthRule& rule, V z, std::uint32_t*) {
    const D d;
    const V inside = hn::Min(hn::Max(z, hn::Zero(d)), hn::Set(d, 1.0));
    return hn::Trunc(hn::Add(hn::Mul(inside, hn::Set(d, rule.steps)), hn::Set(d, rule.half)));
}
HWY_INLINE V quantised(const DepthRule&, V z, double*) { return z; }

HWY_INLINE V loaded(const std::uint32_t* p) {
    return hn::PromoteTo(D(), hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(p)));
}
HWY_INLINE V loaded(const double* p) { return hn::LoadU(D(), p); }
HWY_INLINE void stored(V z, std::uint32_t* p) {
    hn::StoreU(hn::DemoteTo(I(), z), I(), reinterpret_cast<std::int32_t*>(p));
}
HWY_INLINE void stored(V z, double* p) { hn::StoreU(z, D(), p); }
HWY_INLINE void compressed(V z, Mask m, std::uint32_t* p) {
    const I i;
    hn::CompressBlendedStore(hn::DemoteTo(i, z), narrowed(i, m), i,
                             reinterpret_cast<std::int32_t*>(p));
}
HWY_INLINE void compressed(V z, Mask m, double* p) { hn::CompressBlendedStore(z, m, D(), p); }

template <class Depth>
int cover_rows(const Triangle& t, const DepthRule& rule, Depth* depth, int row, Span<Depth>& out) {
    const D d;
    const I di;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const V iota = hn::Iota(d, 0.0), area = hn::Set(d, t.area);
    const V step0 = hn::Set(d, t.dx[0] * lanes), step1 = hn::Set(d, t.dx[1] * lanes);
    const V step2 = hn::Set(d, t.dx[2] * lanes);
    const V first0 = hn::Mul(iota, hn::Set(d, t.dx[0])), first1 = hn::Mul(iota, hn::Set(d, t.dx[1]));
    const V first2 = hn::Mul(iota, hn::Set(d, t.dx[2]));
    const V least0 = hn::Set(d, t.least[0]), least1 = hn::Set(d, t.least[1]);
    const V least2 = hn::Set(d, t.least[2]);
    const V z0 = hn::Set(d, t.z0), dz1 = hn::Set(d, t.dz1), dz2 = hn::Set(d, t.dz2);
    std::size_t n = 0;
    for (; row < t.y1 && n < span_capacity; ++row) {
        const double down = row - t.y0;
        V e0 = hn::Add(hn::Set(d, t.e[0] + t.dy[0] * down), first0);
        V e1 = hn::Add(hn::Set(d, t.e[1] + t.dy[1] * down), first1);
        V e2 = hn::Add(hn::Set(d, t.e[2] + t.dy[2] * down), first2);
        for (int x = t.x0; x < t.x1; x += lanes) {
            Mask m = hn::And(hn::And(hn::Ge(e0, least0), hn::Ge(e1, least1)), hn::Ge(e2, least2));
            if (x + lanes > t.x1) m = hn::And(m, hn::FirstN(d, static_cast<std::size_t>(t.x1 - x)));
            const V w1 = e1, w2 = e2;
            e0 = hn::Add(e0, step0);
            e1 = hn::Add(e1, step1);
            e2 = hn::Add(e2, step2);
            if (hn::AllFalse(d, m)) continue;
            const int at = row * tile_edge + x;
            V z = z0;
            if (rule.computed) {
                const V more = hn::Add(hn::Mul(w1, dz1), hn::Mul(w2, dz2));
                z = quantised(rule, hn::Add(z0, hn::Div(more, area)), depth);
                if (rule.early) {
                    const V old = loaded(depth + at);
                    m = hn::And(m, passes(rule.func, z, old));
                    if (rule.write) stored(hn::IfThenElse(m, z, old), depth + at);
                }
            }
            const auto places = hn::Add(hn::Set(di, at), hn::Iota(di, 0));
            auto* const place = reinterpret_cast<std::int32_t*>(out.at.data() + n);
            const bool late = rule.computed && !rule.early;
            if (hn::AllTrue(d, m)) {
                hn::StoreU(w1, d, out.e1.data() + n);
                hn::StoreU(w2, d, out.e2.data() + n);
                hn::StoreU(places, di, place);
                if (late) stored(z, out.z.data() + n);
                n += static_cast<std::size_t>(lanes);
            } else {
                hn::CompressBlendedStore(w1, m, d, out.e1.data() + n);
                hn::CompressBlendedStore(w2, m, d, out.e2.data() + n);
                hn::CompressBlendedStore(places, narrowed(di, m), di, place);
                if (late) compressed(z, m, out.z.data() + n);
                n += hn::CountTrue(d, m);
            }
        }
    }
    out.size = n;
    return row;
}

// -------------------------------------------------------------------------------- interpolation

/// Doubled areas at some pixels of a span.
struct Weights {
    V e0, e1, e2;
};

template <class Depth>
HWY_INLINE Weights weights_at(const Triangle& t, const Span<Depth>& span, std::size_t i) {
    const D d;
    const V e1 = hn::LoadU(d, span.e1.data() + i), e2 = hn::LoadU(d, span.e2.data() + i);
    return {hn::Sub(hn::Sub(hn::Set(d, t.area), e1), e2), e1, e2};
}

HWY_INLINE V as_real(D, V v) { return v; }
template <class F>
HWY_INLINE hn::Vec<F> as_real(F f, V v) {
    return hn::DemoteTo(f, v);
}

template <class Real, class Depth>
HWY_INLINE void interpolate_coords(const Triangle& t, const Corners<Real>& c, std::size_t units,
                                   const Span<Depth>& span, Batch<Real, Depth>& out) {
    const hn::Rebind<Real, D> r;
    const bool over_w = c.over_w || t.equal_w;
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(r)) {
        const Weights w = weights_at(t, span, i);
        auto w0 = as_real(r, w.e0), w1 = as_real(r, w.e1), w2 = as_real(r, w.e2);
        if (!over_w) {
            w0 = hn::Mul(w0, hn::Set(r, static_cast<Real>(t.inverse_w[0])));
            w1 = hn::Mul(w1, hn::Set(r, static_cast<Real>(t.inverse_w[1])));
            w2 = hn::Mul(w2, hn::Set(r, static_cast<Real>(t.inverse_w[2])));
        }
        for (std::size_t u = 0; u < units; ++u)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& v = c.coords[u][k];
                const auto sum = hn::Add(hn::Add(hn::Mul(w0, hn::Set(r, v[0])),
                                                 hn::Mul(w1, hn::Set(r, v[1]))),
                                         hn::Mul(w2, hn::Set(r, v[2])));
                hn::StoreU(sum, r, out.coords[u][k].data() + out.size + i);
            }
    }
}

template <class Real, class Depth>
HWY_INLINE void copy_places(const Span<Depth>& span, Batch<Real, Depth>& out) {
    for (std::size_t i = 0; i < span.size; ++i) out.at[out.size + i] = span.at[i];
    for (std::size_t i = 0; i < span.size; ++i) out.z[out.size + i] = span.z[i];
}

/// Nv17::iterate_color.
HWY_INLINE void interpolate_byte_colors(const Triangle& t, const Corners<double>& c,
                                        const Span<std::uint32_t>& span, std::uint32_t* out) {
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
        auto color = hn::Zero(di);
        const auto channel = [&](std::size_t k) HWY_ATTR {
            const auto value = hn::Add(hn::Add(hn::Mul(n0, hn::Set(di, c.bytes[0][k])),
                                               hn::Mul(n1, hn::Set(di, c.bytes[1][k]))),
                                       hn::Mul(n2, hn::Set(di, c.bytes[2][k])));
            return hn::ShiftRight<8>(hn::Add(value, hn::Set(di, 128)));
        };
        color = hn::Or(hn::Or(channel(0), hn::ShiftLeft<8>(channel(1))),
                       hn::Or(hn::ShiftLeft<16>(channel(2)), hn::ShiftLeft<24>(channel(3))));
        hn::StoreU(color, di, reinterpret_cast<std::int32_t*>(out + i));
    }
}

std::uint32_t packed(const Color<int>& c) {
    return static_cast<std::uint32_t>(c[0]) | static_cast<std::uint32_t>(c[1]) << 8 |
           static_cast<std::uint32_t>(c[2]) << 16 | static_cast<std::uint32_t>(c[3]) << 24;
}

void interpolate_b(const Triangle& t, const Corners<double>& c, std::size_t units,
                   const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out) {
    interpolate_coords(t, c, units, span, out);
    copy_places(span, out);
    if (c.one_color) {
        const std::uint32_t color = packed(c.bytes[0]);
        for (std::size_t i = 0; i < span.size; ++i) out.bytes[out.size + i] = color;
    } else {
        interpolate_byte_colors(t, c, span, out.bytes.data() + out.size);
    }
    out.size += span.size;
}

/// RealModel::iterate_color, the four channels of a fragment side by side.
template <class Real, class Depth>
HWY_INLINE void interpolate_real_colors(const Triangle& t, const Corners<Real>& c,
                                        const Span<Depth>& span, Color<Real>* out) {
    const hn::Rebind<Real, D> r;
    const hn::CappedTag<Real, 4> four;
    alignas(64) Real l1[hn::MaxLanes(r)], l2[hn::MaxLanes(r)], sum[hn::MaxLanes(r)];
    for (std::size_t i = 0; i < span.size; i += hn::Lanes(r)) {
        const Weights w = weights_at(t, span, i);
        const auto p0 = hn::Mul(as_real(r, w.e0), hn::Set(r, static_cast<Real>(t.inverse_w[0])));
        const auto p1 = hn::Mul(as_real(r, w.e1), hn::Set(r, static_cast<Real>(t.inverse_w[1])));
        const auto p2 = hn::Mul(as_real(r, w.e2), hn::Set(r, static_cast<Real>(t.inverse_w[2])));
        hn::StoreU(p1, r, l1);
        hn::StoreU(p2, r, l2);
        hn::StoreU(hn::Add(hn::Add(p0, p1), p2), r, sum);
        const std::size_t rest = span.size - i;
        for (std::size_t k = 0; k < hn::Lanes(r) && k < rest; ++k)
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

template <class Real, class Depth>
void interpolate_r(const Triangle& t, const Corners<Real>& c, std::size_t units,
                   const Span<Depth>& span, Batch<Real, Depth>& out) {
    interpolate_coords(t, c, units, span, out);
    copy_places(span, out);
    if (c.one_color)
        for (std::size_t i = 0; i < span.size; ++i) out.reals[out.size + i] = c.reals[0];
    else
        interpolate_real_colors(t, c, span, out.reals.data() + out.size);
    out.size += span.size;
}

// ------------------------------------------------------------------------------------ addresses

/// limit_coordinate() of texunit/texel_address.hpp.
template <class R>
HWY_INLINE hn::Vec<R> limited(R r, hn::Vec<R> u, int size, Wrap wrap) {
    using Real = hn::TFromD<R>;
    const auto n = hn::Set(r, static_cast<Real>(size));
    const auto half = hn::Set(r, Real{0.5});
    switch (wrap) {
        case Wrap::repeat:
            return hn::Sub(u, hn::Mul(n, hn::Floor(hn::Div(u, n))));
        case Wrap::clamp:
            return hn::Min(hn::Max(u, hn::Zero(r)), n);
        case Wrap::clamp_to_edge:
            return hn::Min(hn::Max(u, half), hn::Sub(n, half));
        case Wrap::mirrored_repeat: {
            const auto copy = hn::Floor(hn::Div(u, n));
            const auto inside = hn::Sub(u, hn::Mul(n, copy));
            const auto two = hn::Set(r, Real{2});
            const auto even = hn::Eq(copy, hn::Mul(two, hn::Floor(hn::Div(copy, two))));
            const auto turned = hn::IfThenElse(even, inside, hn::Sub(n, inside));
            return hn::Min(hn::Max(turned, half), hn::Sub(n, half));
        }
        case Wrap::clamp_to_border:
            break;
    }
    return hn::Min(hn::Max(u, hn::Neg(half)), hn::Add(n, half));
}

/// A place along one axis: the lesser texel and, for LINEAR, the fraction of the next.
template <class R>
struct Axis {
    hn::Vec<R> texel, fraction;
};

template <class R>
HWY_INLINE Axis<R> axis(R r, hn::Vec<R> u, int size, Wrap wrap, bool linear) {
    using Real = hn::TFromD<R>;
    const auto at = limited(r, u, size, wrap);
    if (linear) {
        const auto shifted = hn::Sub(at, hn::Set(r, Real{0.5}));
        const auto base = hn::Floor(shifted);
        return {base, hn::Sub(shifted, base)};
    }
    const auto base = hn::Floor(at);
    const auto last = hn::Set(r, static_cast<Real>(wrap == Wrap::clamp_to_border ? size : size - 1));
    return {hn::Min(base, last), hn::Zero(r)};
}

/// texel_coordinate(), q being neither 0 nor NaN.
template <class R>
HWY_INLINE hn::Vec<R> texels_along(R r, hn::Vec<R> s, hn::Vec<R> q, int size) {
    using Real = hn::TFromD<R>;
    const auto limit = hn::Set(r, Real{32768});
    const auto u = hn::Div(hn::Mul(s, hn::Set(r, static_cast<Real>(size))), q);
    return hn::Min(hn::Max(u, hn::Neg(limit)), limit);
}

HWY_INLINE hn::Vec<I> as_int(D, V v) { return hn::DemoteTo(I(), v); }
template <class F>
HWY_INLINE hn::Vec<hn::RebindToSigned<F>> as_int(F, hn::Vec<F> v) {
    return hn::ConvertTo(hn::RebindToSigned<F>(), v);
}

/// Where a unit's footprints lie: the offset of the lesser texel into the padded image.
template <class Real>
struct Footprints {
    alignas(64) std::array<std::int32_t, batch_capacity + 1024> offset;
    alignas(64) std::array<Real, batch_capacity + 1024> a, b;
};

template <class Texel, class Real, class Depth, class Visit>
HWY_INLINE void for_each_footprint(const Unit<Texel>& unit, const Batch<Real, Depth>& batch,
                                   std::size_t u, Visit&& visit) {
    const hn::Rebind<Real, D> r;
    const Image<Texel>& image = unit.image;
    const auto one = hn::Set(r, Real{1});
    const int scale_s = unit.in_texels ? 1 : image.width, scale_t = unit.in_texels ? 1 : image.height;
    for (std::size_t i = 0; i < batch.size; i += hn::Lanes(r)) {
        const auto q =
            unit.divide_by_q ? hn::LoadU(r, batch.coords[u][2].data() + i) : one;
        const auto s = hn::LoadU(r, batch.coords[u][0].data() + i);
        const auto t = hn::LoadU(r, batch.coords[u][1].data() + i);
        const auto x = axis(r, texels_along(r, s, q, scale_s), image.width, unit.wrap_s, unit.linear);
        const auto y = axis(r, texels_along(r, t, q, scale_t), image.height, unit.wrap_t, unit.linear);
        const hn::Rebind<std::int32_t, D> di;
        const auto column = hn::Add(as_int(r, x.texel), hn::Set(di, 1));
        const auto line = hn::Add(as_int(r, y.texel), hn::Set(di, 1));
        visit(i, hn::Add(hn::Mul(line, hn::Set(di, image.stride)), column), x.fraction, y.fraction);
    }
}

// ---------------------------------------------------------------------------------- 8-bit shading

using U32 = hn::ScalableTag<std::uint32_t>;
using U16 = hn::Repartition<std::uint16_t, U32>;
using Bytes = hn::Vec<U16>;

/// Four channels of as many texels as there are 32-bit lanes: red and blue, green and alpha.
struct Texels8 {
    Bytes rb, ga;
};

HWY_INLINE Texels8 unpacked(hn::Vec<U32> t) {
    const U32 d;
    const auto low = hn::Set(d, 0x00ff00ffu);
    return {hn::BitCast(U16(), hn::And(t, low)),
            hn::BitCast(U16(), hn::And(hn::ShiftRight<8>(t), low))};
}

HWY_INLINE hn::Vec<U32> repacked(const Texels8& t) {
    const U32 d;
    return hn::Or(hn::BitCast(d, t.rb), hn::ShiftLeft<8>(hn::BitCast(d, t.ga)));
}

/// flerp() of byte_arithmetic.hpp: (p (256 - w) + q w + 128) >> 8, which fits 16 bits.
HWY_INLINE Bytes flerp16(Bytes p, Bytes q, Bytes w) {
    const auto moved = hn::Add(hn::ShiftLeft<8>(p), hn::Mul(hn::Sub(q, p), w));
    return hn::ShiftRight<8>(hn::Add(moved, hn::Set(U16(), 128)));
}

/// mul_rn() of byte_arithmetic.hpp.
HWY_INLINE Bytes mul_rn16(Bytes a, Bytes b) {
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(U16(), 128));
    return hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
}

HWY_INLINE Texels8 gathered(const std::uint32_t* base, hn::Vec<hn::RebindToSigned<U32>> at) {
    return unpacked(hn::GatherIndex(U32(), base, at));
}

/// Nv17::filter on all four channels.
HWY_INLINE Texels8 filtered(const Image<std::uint32_t>& image,
                            hn::Vec<hn::RebindToSigned<U32>> at, hn::Vec<U32> weights) {
    const U32 d;
    const auto low = hn::And(weights, hn::Set(d, 0xffffu)), high = hn::ShiftRight<16>(weights);
    const Bytes a = hn::BitCast(U16(), hn::Or(low, hn::ShiftLeft<16>(low)));
    const Bytes b = hn::BitCast(U16(), hn::Or(high, hn::ShiftLeft<16>(high)));
    const std::uint32_t* const next = image.texels + image.stride;
    const Texels8 t00 = gathered(image.texels, at), t10 = gathered(image.texels + 1, at);
    const Texels8 t01 = gathered(next, at), t11 = gathered(next + 1, at);
    return {flerp16(flerp16(t00.rb, t10.rb, a), flerp16(t01.rb, t11.rb, a), b),
            flerp16(flerp16(t00.ga, t10.ga, a), flerp16(t01.ga, t11.ga, a), b)};
}

/// MODULATE with its scales, or REPLACE.
HWY_INLINE Texels8 combined(const Unit<std::uint32_t>& unit, const Texels8& texel,
                            const Texels8& previous) {
    if (unit.replace) return texel;
    Texels8 c{mul_rn16(texel.rb, previous.rb), mul_rn16(texel.ga, previous.ga)};
    if (unit.rgb_scale == 1 && unit.alpha_scale == 1) return c;
    const auto rgb = static_cast<std::uint32_t>(unit.rgb_scale);
    const auto alpha = static_cast<std::uint32_t>(unit.alpha_scale);
    const auto top = hn::Set(U16(), 255);
    const auto factors = [](std::uint32_t lower, std::uint32_t upper) HWY_ATTR {
        return hn::BitCast(U16(), hn::Set(U32(), lower | upper << 16));
    };
    c.rb = hn::Min(hn::Mul(c.rb, factors(rgb, rgb)), top);
    c.ga = hn::Min(hn::Mul(c.ga, factors(rgb, alpha)), top);
    return c;
}

void shade_unit(const Unit<std::uint32_t>& unit, std::size_t u,
                Batch<double, std::uint32_t>& batch) {
    const U32 d;
    const hn::RebindToSigned<U32> ds;
    alignas(64) std::array<std::int32_t, batch.room> offsets;
    alignas(64) std::array<std::int32_t, batch.room> weights;
    const V steps = hn::Set(D(), 256.0), most = hn::Set(D(), 255.0);
    for_each_footprint(unit, batch, u, [&](std::size_t i, hn::Vec<I> offset, V a, V b) HWY_ATTR {
        const I di;
        hn::StoreU(offset, di, offsets.data() + i);
        const auto wa = hn::DemoteTo(di, hn::Min(hn::Mul(a, steps), most));
        const auto wb = hn::DemoteTo(di, hn::Min(hn::Mul(b, steps), most));
        hn::StoreU(hn::Or(wa, hn::ShiftLeft<16>(wb)), di, weights.data() + i);
    });
    // What lies behind the last fragment up to a full vector must be an address too.
    for (std::size_t i = batch.size; i < batch.size + widest; ++i) offsets[i] = 0;
    for (std::size_t i = 0; i < batch.size; i += hn::Lanes(d)) {
        const auto at = hn::LoadU(ds, offsets.data() + i);
        const auto previous = unpacked(hn::LoadU(d, batch.bytes.data() + i));
        const Texels8 texel =
            unit.linear ? filtered(unit.image, at,
                                   hn::BitCast(d, hn::LoadU(ds, weights.data() + i)))
                        : gathered(unit.image.texels, at);
        hn::StoreU(repacked(combined(unit, texel, previous)), d, batch.bytes.data() + i);
    }
}

void shade_b(const Shader<std::uint32_t>& s, Batch<double, std::uint32_t>& batch) {
    for (std::size_t u = 0; u < s.units; ++u) shade_unit(s.unit[u], u, batch);
}

// ----------------------------------------------------------------------------------- real shading

template <class Real>
HWY_INLINE hn::Vec<hn::CappedTag<Real, 4>> real_texel(const Image<Color<Real>>& image,
                                                      std::int32_t at, std::size_t channel, Real a,
                                                      Real b, bool linear) {
    const hn::CappedTag<Real, 4> four;
    const auto texel = [&](std::int32_t more) HWY_ATTR {
        return hn::LoadU(four, image.texels[at + more].data() + channel);
    };
    if (!linear) return texel(0);
    const auto va = hn::Set(four, a), na = hn::Set(four, Real{1} - a);
    const auto vb = hn::Set(four, b), nb = hn::Set(four, Real{1} - b);
    const auto row0 = hn::Add(hn::Mul(na, texel(0)), hn::Mul(va, texel(1)));
    const auto row1 =
        hn::Add(hn::Mul(na, texel(image.stride)), hn::Mul(va, texel(image.stride + 1)));
    return hn::Add(hn::Mul(nb, row0), hn::Mul(vb, row1));
}

template <class Real, class Depth>
void shade_real_unit(const Unit<Color<Real>>& unit, std::size_t u, Batch<Real, Depth>& batch) {
    const hn::Rebind<Real, D> r;
    const hn::CappedTag<Real, 4> four;
    alignas(64) std::array<std::int32_t, batch.room> offsets;
    alignas(64) std::array<Real, batch.room> as, bs;
    for_each_footprint(unit, batch, u,
                       [&](std::size_t i, auto offset, auto a, auto b) HWY_ATTR {
                           hn::StoreU(offset, I(), offsets.data() + i);
                           hn::StoreU(a, r, as.data() + i);
                           hn::StoreU(b, r, bs.data() + i);
                       });
    const bool scaled = unit.rgb_scale != 1 || unit.alpha_scale != 1;
    const std::array<Real, 4> factor{
        static_cast<Real>(unit.rgb_scale), static_cast<Real>(unit.rgb_scale),
        static_cast<Real>(unit.rgb_scale), static_cast<Real>(unit.alpha_scale)};
    const std::array<Real, 4> limit{
        unit.rgb_scale == 1 ? hwy::HighestValue<Real>() : Real{1},
        unit.rgb_scale == 1 ? hwy::HighestValue<Real>() : Real{1},
        unit.rgb_scale == 1 ? hwy::HighestValue<Real>() : Real{1},
        unit.alpha_scale == 1 ? hwy::HighestValue<Real>() : Real{1}};
    for (std::size_t i = 0; i < batch.size; ++i)
        for (std::size_t ch = 0; ch < 4; ch += hn::Lanes(four)) {
            Real* const color = batch.reals[i].data() + ch;
            auto c = real_texel(unit.image, offsets[i], ch, as[i], bs[i], unit.linear);
            if (!unit.replace) {
                c = hn::Mul(c, hn::LoadU(four, color));
                if (scaled)
                    c = hn::Min(hn::Mul(c, hn::LoadU(four, factor.data() + ch)),
                                hn::LoadU(four, limit.data() + ch));
            }
            hn::StoreU(c, four, color);
        }
}

template <class Real, class Depth>
void shade_r(const Shader<Color<Real>>& s, Batch<Real, Depth>& batch) {
    for (std::size_t u = 0; u < s.units; ++u) shade_real_unit(s.unit[u], u, batch);
}

void round_colors(Batch<double, std::uint32_t>& batch) {
    const hn::CappedTag<double, 4> four;
    const hn::Rebind<std::int32_t, hn::CappedTag<double, 4>> ints;
    for (std::size_t i = 0; i < batch.size; ++i) {
        alignas(16) std::array<std::int32_t, 4> c;
        for (std::size_t ch = 0; ch < 4; ch += hn::Lanes(four)) {
            const auto x = hn::LoadU(four, batch.reals[i].data() + ch);
            const auto inside = hn::Min(hn::Max(x, hn::Zero(four)), hn::Set(four, 1.0));
            const auto scaled =
                hn::Add(hn::Mul(hn::Set(four, 255.0), inside), hn::Set(four, 0.5));
            hn::StoreU(hn::DemoteTo(ints, scaled), ints, c.data() + ch);
        }
        batch.bytes[i] = packed(c);
    }
}

// -------------------------------------------------------------------------- one name per function

int cover_u32(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
              Span<std::uint32_t>& out) {
    return cover_rows(t, rule, depth, row, out);
}
int cover_f64(const Triangle& t, const DepthRule& rule, double* depth, int row, Span<double>& out) {
    return cover_rows(t, rule, depth, row, out);
}
void interpolate_bytes_u32(const Triangle& t, const Corners<double>& c, std::size_t units,
                           const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out) {
    interpolate_b(t, c, units, span, out);
}
void interpolate_f64_u32(const Triangle& t, const Corners<double>& c, std::size_t units,
                         const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out) {
    interpolate_r(t, c, units, span, out);
}
void interpolate_f64_f64(const Triangle& t, const Corners<double>& c, std::size_t units,
                         const Span<double>& span, Batch<double, double>& out) {
    interpolate_r(t, c, units, span, out);
}
void interpolate_f32_u32(const Triangle& t, const Corners<float>& c, std::size_t units,
                         const Span<std::uint32_t>& span, Batch<float, std::uint32_t>& out) {
    interpolate_r(t, c, units, span, out);
}
void shade_bytes_u32(const Shader<std::uint32_t>& s, Batch<double, std::uint32_t>& batch) {
    shade_b(s, batch);
}
void shade_f64_u32(const Shader<Color<double>>& s, Batch<double, std::uint32_t>& batch) {
    shade_r(s, batch);
}
void shade_f64_f64(const Shader<Color<double>>& s, Batch<double, double>& batch) {
    shade_r(s, batch);
}
void shade_f32_u32(const Shader<Color<float>>& s, Batch<float, std::uint32_t>& batch) {
    shade_r(s, batch);
}
void round_f64_u32(Batch<double, std::uint32_t>& batch) { round_colors(batch); }
const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(cover_u32);
HWY_EXPORT(cover_f64);
HWY_EXPORT(interpolate_bytes_u32);
HWY_EXPORT(interpolate_f64_u32);
HWY_EXPORT(interpolate_f64_f64);
HWY_EXPORT(interpolate_f32_u32);
HWY_EXPORT(shade_bytes_u32);
HWY_EXPORT(shade_f64_u32);
HWY_EXPORT(shade_f64_f64);
HWY_EXPORT(shade_f32_u32);
HWY_EXPORT(round_f64_u32);
HWY_EXPORT(target_name);

int cover(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
          Span<std::uint32_t>& out) {
    return HWY_DYNAMIC_DISPATCH(cover_u32)(t, rule, depth, row, out);
}
int cover(const Triangle& t, const DepthRule& rule, double* depth, int row, Span<double>& out) {
    return HWY_DYNAMIC_DISPATCH(cover_f64)(t, rule, depth, row, out);
}
void interpolate_bytes(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_bytes_u32)(t, c, units, span, out);
}
void interpolate_reals(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f64_u32)(t, c, units, span, out);
}
void interpolate_reals(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<double>& span, Batch<double, double>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f64_f64)(t, c, units, span, out);
}
void interpolate_reals(const Triangle& t, const Corners<float>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<float, std::uint32_t>& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_f32_u32)(t, c, units, span, out);
}
void shade(const Shader<std::uint32_t>& s, Batch<double, std::uint32_t>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_bytes_u32)(s, batch);
}
void shade(const Shader<Color<double>>& s, Batch<double, std::uint32_t>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_f64_u32)(s, batch);
}
void shade(const Shader<Color<double>>& s, Batch<double, double>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_f64_f64)(s, batch);
}
void shade(const Shader<Color<float>>& s, Batch<float, std::uint32_t>& batch) {
    HWY_DYNAMIC_DISPATCH(shade_f32_u32)(s, batch);
}
void round_to_bytes(Batch<double, std::uint32_t>& batch) {
    HWY_DYNAMIC_DISPATCH(round_f64_u32)(batch);
}
const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace twofold::lanes
#endif
