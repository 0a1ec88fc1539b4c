// Texture addresses on vectors, compiled once for each instruction set: no #pragma once.
#include "raster/lane_math-inl.hpp"
#include "raster/lanes.hpp"

#if defined(TWOFOLD_LANE_ADDRESS) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_ADDRESS
#undef TWOFOLD_LANE_ADDRESS
#else
#define TWOFOLD_LANE_ADDRESS
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// One axis of a unit's image, prepared once for all vectors.
template <class R>
struct Extent {
    using Real = hn::TFromD<R>;
    hn::Vec<R> size, scale;  ///< texels; what coordinates are multiplied by
    hn::Vec<R> least, most;  ///< what limited coordinates lie between
    hn::Vec<R> last;         ///< texel of NEAREST
    Wrap wrap;

    HWY_INLINE Extent(R r, int texels, Wrap wrap_mode, bool in_texels)
        : size(hn::Set(r, static_cast<Real>(texels))),
          scale(hn::Set(r, static_cast<Real>(in_texels ? 1 : texels))),
          least(hn::Set(r, margin(wrap_mode))),
          most(hn::Sub(size, least)),
          last(hn::Set(
              r, static_cast<Real>(wrap_mode == Wrap::clamp_to_border ? texels : texels - 1))),
          wrap(wrap_mode) {}

    static Real margin(Wrap wrap) {
        return wrap == Wrap::clamp ? Real{0}
                                   : (wrap == Wrap::clamp_to_border ? Real{-0.5} : Real{0.5});
    }
};

/// limit_coordinate() of texunit/texel_address.hpp.
template <class R>
HWY_INLINE hn::Vec<R> limited(R r, hn::Vec<R> u, const Extent<R>& in) {
    using Real = hn::TFromD<R>;
    if (in.wrap == Wrap::repeat)
        return hn::Sub(u, hn::Mul(in.size, hn::Floor(hn::Div(u, in.size))));
    if (in.wrap == Wrap::mirrored_repeat) {
        const auto copy = hn::Floor(hn::Div(u, in.size));
        const auto inside = hn::Sub(u, hn::Mul(in.size, copy));
        const auto two = hn::Set(r, Real{2});
        const auto even = hn::Eq(copy, hn::Mul(two, hn::Floor(hn::Div(copy, two))));
        u = hn::IfThenElse(even, inside, hn::Sub(in.size, inside));
    }
    return hn::Min(hn::Max(u, in.least), in.most);
}

/// A place along one axis: the lesser texel and, for LINEAR, the fraction of the next.
template <class R>
struct Axis {
    hn::Vec<R> texel, fraction;
};

template <class R>
HWY_INLINE Axis<R> axis(R r, hn::Vec<R> u, const Extent<R>& in, bool linear) {
    const auto at = limited(r, u, in);
    if (linear) {
        const auto shifted = hn::Sub(at, hn::Set(r, hn::TFromD<R>{0.5}));
        const auto base = hn::Floor(shifted);
        return {base, hn::Sub(shifted, base)};
    }
    return {hn::Min(hn::Floor(at), in.last), hn::Zero(r)};
}

/// texel_coordinate(). 0 / 0 is looked for where q may be 0.
template <bool any_q, class R>
HWY_INLINE hn::Vec<R> texels_along(R r, hn::Vec<R> s, hn::Vec<R> q, const Extent<R>& in) {
    const auto limit = hn::Set(r, hn::TFromD<R>{32768});
    auto u = hn::Div(hn::Mul(s, in.scale), q);
    if constexpr (any_q) u = hn::IfThenElseZero(hn::Eq(u, u), u);
    return hn::Min(hn::Max(u, hn::Neg(limit)), limit);
}

HWY_INLINE hn::Vec<I> as_int(D, V v) { return hn::DemoteTo(I(), v); }
template <class F>
HWY_INLINE hn::Vec<hn::RebindToSigned<F>> as_int(F, hn::Vec<F> v) {
    return hn::ConvertTo(hn::RebindToSigned<F>(), v);
}

/// Texture coordinates of some fragments, up to a common factor.
template <class R>
struct Coordinates {
    hn::Vec<R> s, t, q;
};

/// Where footprints lie: the offset of the lesser texel into the image with its surroundings, and
/// the fractions of the next.
template <class R>
struct Footprint {
    hn::Vec<hn::Rebind<std::int32_t, R>> offset;
    hn::Vec<R> a, b;
};

/// What footprint() needs of a unit.
template <class R>
struct Addresses {
    Extent<R> x, y;
    int first, stride;  ///< texel (0, 0), from the unit's image on
    bool linear, divide_by_q;

    template <class Texel>
    HWY_INLINE Addresses(R r, const Unit<Texel>& unit)
        : Addresses(r, unit, unit.image, unit.linear) {}

    /// @param image  of the unit's levels
    template <class Texel>
    HWY_INLINE Addresses(R r, const Unit<Texel>& unit, const Image<Texel>& image,
                         bool linear_filter)
        : x(r, image.width, unit.wrap_s, unit.in_texels),
          y(r, image.height, unit.wrap_t, unit.in_texels),
          first(static_cast<int>(image.texels - unit.image.texels) + image.stride + 1),
          stride(image.stride),
          linear(linear_filter),
          divide_by_q(unit.divide_by_q) {}
};

/// Places in an image, in texels.
template <class R>
struct Point {
    hn::Vec<R> u, v;
};

/// texel_point() of texunit/texel_address.hpp.
template <bool any_q, class R>
HWY_INLINE Point<R> texel_point(R r, const Addresses<R>& in, const Coordinates<R>& c) {
    const auto q = in.divide_by_q ? c.q : hn::Set(r, hn::TFromD<R>{1});
    return {texels_along<any_q>(r, c.s, q, in.x), texels_along<any_q>(r, c.t, q, in.y)};
}

/// q being neither 0 nor NaN.
template <class R>
HWY_INLINE Footprint<R> footprint(R r, const Addresses<R>& in, const Coordinates<R>& c) {
    const Point<R> point = texel_point<false>(r, in, c);
    const auto x = axis(r, point.u, in.x, in.linear), y = axis(r, point.v, in.y, in.linear);
    const hn::Rebind<std::int32_t, R> ints;
    const auto line = hn::Mul(as_int(r, y.texel), hn::Set(ints, in.stride));
    const auto column = hn::Add(as_int(r, x.texel), hn::Set(ints, in.first));
    return {hn::Add(line, column), x.fraction, y.fraction};
}

/// 8-bit presets: the fractions are weights in 1/256, a | b << 16.
struct Footprint8 {
    hn::Vec<I> offset, weights;
};

HWY_INLINE Footprint8 in_bytes(const Footprint<D>& f) {
    const D d;
    const I di;
    const auto weight = [&](V fraction) HWY_ATTR {
        return hn::DemoteTo(di, hn::Min(hn::Mul(fraction, hn::Set(d, 256.0)), hn::Set(d, 255.0)));
    };
    return {f.offset, hn::Or(weight(f.a), hn::ShiftLeft<16>(weight(f.b)))};
}

/// Whether a unit's coordinates may be found by reciprocals.
inline bool knows_reciprocals(const Unit<std::uint32_t>& unit) {
    return unit.divide_by_q && !unit.in_texels && unit.wrap_s == Wrap::clamp_to_edge &&
           unit.wrap_t == Wrap::clamp_to_edge && unit.image.width <= 4096 &&
           unit.image.height <= 4096;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
