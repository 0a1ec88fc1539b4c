// Levels of detail by near places (lane_near-inl.hpp), on vectors, compiled once for each
// instruction set: no #pragma once.
#include <algorithm>
#include <cmath>

#include "raster/lane_near-inl.hpp"

#if defined(TWOFOLD_LANE_LEVELS) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_LEVELS
#undef TWOFOLD_LANE_LEVELS
#else
#define TWOFOLD_LANE_LEVELS
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

// ------------------------------------------------------------------------------ a unit's images

/// What fragments read: 0 is the base, magnified, 1 + k is level k, minified.
template <class Texel>
struct ReadImage {
    const Image<Texel>& image;
    bool linear;
};

template <class Texel>
ReadImage<Texel> read_image(const Unit<Texel>& unit, std::int32_t number) {
    if (number == 0) return {unit.image, unit.linear};
    return {unit.levels[static_cast<std::size_t>(number - 1)], unit.rule.linear};
}

/// Calls f(number, mask) for each image that fragments read, of `levels` and the magnified one.
template <class T, class F>
HWY_INLINE void for_each_image(T d, hn::Vec<T> numbers, std::size_t levels, F&& f) {
    const auto first = hn::Eq(numbers, hn::Set(d, hn::GetLane(numbers)));
    const bool one = hn::AllTrue(d, first);
    const auto last = static_cast<std::int32_t>(levels);
    for (std::int32_t k = one ? hn::GetLane(numbers) : 0; k <= last; ++k) {
        const auto here = hn::Eq(numbers, hn::Set(d, k));
        if (!hn::AllFalse(d, here)) f(k, here);
        if (one) return;
    }
}

// -------------------------------------------------------------------------------- level of detail

using F = hn::Rebind<float, DI>;
using VF = hn::Vec<F>;

inline constexpr int lod_bits = 23;  ///< near levels of detail count 2^-23

/// Whether a unit's level of detail may be found near: at 1/16 texel a pixel the base is magnified
/// for sure, so that what counts is known to some 2^-22 of it.
inline bool knows_near_levels(const Unit<std::uint32_t>& unit) {
    const auto no_larger = [&](const Image<std::uint32_t>& level) {
        return level.width <= unit.image.width && level.height <= unit.image.height;
    };
    return unit.rule.bias >= -32.0 && unit.rule.bias <= 3.5 &&
           std::all_of(unit.levels.begin(), unit.levels.end(), no_larger);
}

/// log2 in units of 2^-22, to one of them. The polynomial is near log2(1 + f) / f to 2^-24.
HWY_INLINE VI near_log2(VF x) {
    const DI di;
    const F d;
    constexpr std::int32_t one = 0x3f800000, sqrt_half = 0x3f3504f3;
    const VI bits = hn::BitCast(di, x);
    const VI exponent =
        hn::And(hn::Add(bits, hn::Set(di, one - sqrt_half)), hn::Set(di, 0x7f800000));
    const VF mantissa = hn::BitCast(d, hn::Add(hn::Sub(bits, exponent), hn::Set(di, one)));
    const VF f = hn::Sub(mantissa, hn::Set(d, 1.0f));
    VF sum = hn::Set(d, -0x1.2a7af4p-3f);
    for (const float c : {0x1.e5256ap-3f, -0x1.001202p-2f, 0x1.2596bep-2f, -0x1.70babap-2f,
                          0x1.ec7b62p-2f, -0x1.7155bap-1f, 0x1.715472p+0f})
        sum = hn::Add(hn::Mul(sum, f), hn::Set(d, c));
    const VI part = hn::ConvertTo(di, hn::Mul(hn::Mul(sum, f), hn::Set(d, 0x1p22f)));
    return hn::Add(hn::Sub(hn::ShiftRight<1>(exponent), hn::Set(di, 127 << 22)), part);
}

/// Places in the base, in Near's units.
struct NearPoint {
    Two u, v;
};

HWY_INLINE NearPoint near_point(const FourPlanes& p, const Two& x, const Two& y) {
    const auto plane = [&](std::size_t k) HWY_ATTR {
        return Two{p.at(k, x.low, y.low), p.at(k, x.high, y.high)};
    };
    const Two q = plane(Near::q), over{near_reciprocal(q.low), near_reciprocal(q.high)};
    return {product(plane(Near::x), over), product(plane(Near::y), over)};
}

HWY_INLINE VF squared_way(const NearPoint& from, const NearPoint& to) {
    const auto squared = [](V u0, V u1, V v0, V v1) HWY_ATTR {
        const V u = hn::Sub(u1, u0), v = hn::Sub(v1, v0);
        return hn::DemoteTo(hn::Rebind<float, D>(), hn::Add(hn::Mul(u, u), hn::Mul(v, v)));
    };
    return hn::Combine(F(), squared(from.u.high, to.u.high, from.v.high, to.v.high),
                       squared(from.u.low, to.u.low, from.v.low, to.v.low));
}

/// Levels of detail at pixels that are at `here`.
HWY_INLINE VI near_levels_of_detail(const FourPlanes& p, double bias, const Two& x, const Two& y,
                                    const NearPoint& here) {
    const auto one_more = [](const Two& a) HWY_ATTR {
        const V one = hn::Set(D(), 1.0);
        return Two{hn::Add(a.low, one), hn::Add(a.high, one)};
    };
    const VF squared = hn::Max(squared_way(here, near_point(p, one_more(x), y)),
                               squared_way(here, near_point(p, x, one_more(y))));
    // Half of the logarithm, less 8 because places are in 1/256 texel.
    const double more = std::floor((bias - 8.0) * (1 << lod_bits) + 0.5);
    return hn::Add(near_log2(squared), hn::Set(DI(), static_cast<std::int32_t>(more)));
}

/// Which images fragments read, the share of the next one in 1/256, and whether that could be
/// another by the exact level of detail.
struct NearChoice {
    VI image, share;
    hn::Mask<DI> doubt;
};

/// select_levels() of texunit/mipmap.hpp. All that it decides changes at multiples of 1/256.
HWY_INLINE NearChoice near_choice(const LevelRule& rule, std::size_t levels, VI lod) {
    const DI di;
    constexpr double unit = 1 << lod_bits;
    const auto most_magnified = static_cast<std::int32_t>(rule.magnified_to * unit);
    const auto last = static_cast<std::int32_t>(levels - 1) << lod_bits;
    const auto minified = hn::Lt(hn::Set(di, most_magnified), lod);
    const VI held = hn::IfThenElseZero(minified, hn::Min(lod, hn::Set(di, last)));
    const VI raised = rule.nearest ? hn::Add(held, hn::Set(di, (1 << (lod_bits - 1)) - 1)) : held;
    const VI image = hn::Add(hn::ShiftRight<lod_bits>(raised), hn::Set(di, 1));
    const VI share = hn::And(hn::ShiftRight<lod_bits - 8>(held), hn::Set(di, 255));
    const VI beside = hn::And(hn::Add(lod, hn::Set(di, 8)), hn::Set(di, 0x7ff0));
    return {hn::IfThenElseZero(minified, image), rule.blends ? share : hn::Zero(di),
            hn::And(hn::Eq(beside, hn::Zero(di)), hn::Lt(hn::Set(di, most_magnified - 16), lod))};
}

// ------------------------------------------------------------------------------------- footprints

struct NearFootprints {
    Footprints at;
    hn::Mask<DI> doubt;
};

/// Footprints in one image.
HWY_INLINE NearFootprints near_footprints(const Unit<std::uint32_t>& unit, std::int32_t number,
                                          const NearPoint& point) {
    const DI di;
    const D d;
    const auto [image, linear] = read_image(unit, number);
    const double to_centre = linear ? 128.0 : 0.0;
    const auto scaled = [&](const Two& places, int size, int base) HWY_ATTR {
        const double ratio = static_cast<double>(size) / base;
        const double shift = unit.shift[0] * ratio - to_centre;
        const auto place = [&](V v) HWY_ATTR {
            return hn::Add(hn::Mul(v, hn::Set(d, ratio)), hn::Set(d, shift));
        };
        return Two{place(places.low), place(places.high)};
    };
    const NearImage near(image);
    const VI x = near.x.units(scaled(point.u, image.width, unit.image.width));
    const VI y = near.y.units(scaled(point.v, image.height, unit.image.height));
    Footprints f = near.footprints(x, y);
    const auto first = static_cast<std::int32_t>(image.texels - unit.image.texels);
    f.offset = hn::Add(f.offset, hn::Set(di, first));
    if (!linear) f.weights = hn::Zero(di);
    return {f, hn::Or(in_doubt(x), in_doubt(y))};
}

/// Footprints of each fragment in its image.
HWY_INLINE NearFootprints near_footprints(const Unit<std::uint32_t>& unit, VI images,
                                          const NearPoint& point) {
    const DI di;
    NearFootprints out{{hn::Zero(di), hn::Zero(di)}, hn::FirstN(di, 0)};
    for_each_image(di, images, unit.levels.size(), [&](std::int32_t k, hn::Mask<DI> here) HWY_ATTR {
        const NearFootprints f = near_footprints(unit, k, point);
        out.at = {hn::IfThenElse(here, f.at.offset, out.at.offset),
                  hn::IfThenElse(here, f.at.weights, out.at.weights)};
        out.doubt = hn::Or(out.doubt, hn::And(here, f.doubt));
    });
    return out;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
