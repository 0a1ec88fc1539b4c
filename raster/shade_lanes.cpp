#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shade_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

using U32 = hn::ScalableTag<std::uint32_t>;
using S32 = hn::RebindToSigned<U32>;
using U16 = hn::Repartition<std::uint16_t, U32>;
using Bytes = hn::Vec<U16>;

/// Four channels of as many texels as there are 32-bit lanes: red and blue, green and alpha.
struct Texels8 {
    Bytes rb, ga;
};

HWY_INLINE Texels8 unpacked(hn::Vec<U32> t) {
    const auto low = hn::Set(U32(), 0x00ff00ffu);
    return {hn::BitCast(U16(), hn::And(t, low)), hn::ShiftRight<8>(hn::BitCast(U16(), t))};
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

/// mul_rn() of byte_arithmetic.hpp: t + t / 256 over 256 is 257 t over 65536.
HWY_INLINE Bytes mul_rn16(Bytes a, Bytes b) {
    const auto t = hn::Add(hn::Mul(a, b), hn::Set(U16(), 128));
    return hn::MulHigh(t, hn::Set(U16(), 257));
}

HWY_INLINE Texels8 gathered(const std::uint32_t* base, hn::Vec<S32> at) {
    return unpacked(hn::GatherIndex(U32(), base, at));
}

/// Texels side by side at as many places as there are 32-bit lanes.
struct Pairs {
    Texels8 left, right;
};

using U64 = hn::Repartition<std::uint64_t, U32>;

/// A weight of 16 bits for both halves of a word.
HWY_INLINE Bytes for_both(hn::Vec<U32> weight) {
    return hn::BitCast(U16(), hn::Or(weight, hn::ShiftLeft<16>(weight)));
}

// SSE2's vectors have their own of these three, and no GatherOffset.

/// Words of two texels, from as many places as there are 32-bit lanes.
template <class T>
HWY_INLINE std::array<hn::Vec<T>, 2> words_at(T, const std::uint32_t* texels,
                                              const std::int32_t* at) {
    const hn::Half<S32> half;
    const hn::RebindToSigned<T> places;
    const auto* const words = reinterpret_cast<const std::uint64_t*>(texels);
    const auto bytes = hn::ShiftLeft<2>(hn::LoadU(S32(), at));
    return {GatherOffset(T(), words, hn::PromoteTo(places, hn::LowerHalf(half, bytes))),
            GatherOffset(T(), words, hn::PromoteTo(places, hn::UpperHalf(half, bytes)))};
}

/// A weight in the lower half of each word, for both halves, and one in the upper half.
template <class V32>
HWY_INLINE Bytes lower_for_both(V32 v) {
    return for_both(hn::And(v, hn::Set(U32(), 0xffffu)));
}
template <class V32>
HWY_INLINE Bytes upper_for_both(V32 v) {
    return for_both(hn::ShiftRight<16>(v));
}

/// Two texels are read at once: half as many loads.
HWY_INLINE Pairs pairs_at(const std::uint32_t* texels, const std::int32_t* at) {
    const U32 d;
    const auto [low, high] = words_at(U64(), texels, at);
    const auto l = hn::BitCast(d, low), h = hn::BitCast(d, high);
    return {unpacked(hn::ConcatEven(d, h, l)), unpacked(hn::ConcatOdd(d, h, l))};
}

HWY_INLINE Texels8 flerp16(const Texels8& p, const Texels8& q, Bytes w) {
    return {flerp16(p.rb, q.rb, w), flerp16(p.ga, q.ga, w)};
}

/// Nv17::filter on all four channels.
HWY_INLINE Texels8 filtered(const Image<std::uint32_t>& image, const std::int32_t* at,
                            hn::Vec<U32> weights) {
    const Bytes a = lower_for_both(weights), b = upper_for_both(weights);
    const Pairs top = pairs_at(image.texels, at), next = pairs_at(image.texels + image.stride, at);
    return flerp16(flerp16(top.left, top.right, a), flerp16(next.left, next.right, a), b);
}

/// The texels at the footprints of the fragments from i on.
HWY_INLINE Texels8 filtered(const Unit<std::uint32_t>& unit, const ByteFootprints& footprints,
                            std::size_t i) {
    const std::int32_t* const at = footprints.offset.data() + i;
    if (!reads_four(unit)) return gathered(unit.image.texels, hn::LoadU(S32(), at));
    return filtered(unit.image, at, hn::LoadU(U32(), footprints.weights.data() + i));
}

/// What unit u looks up for the fragments from i on.
HWY_INLINE Texels8 texels_of(const Unit<std::uint32_t>& unit, const ByteBatch& batch, std::size_t u,
                             std::size_t i) {
    const U32 d;
    const Texels8 fine = filtered(unit, batch.fine[u], i);
    if (!unit.rule.blends) return fine;
    const auto share = hn::LoadU(d, batch.coarse_share[u].data() + i);
    if (hn::AllTrue(d, hn::Eq(share, hn::Zero(d)))) return fine;
    return flerp16(fine, filtered(unit, batch.coarse[u], i), for_both(share));
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

void shade_bytes(const Shader<std::uint32_t>& s, ByteBatch& batch) {
    const U32 d;
    end_with_addresses(s, batch);
    for (std::size_t i = 0; i < batch.size; i += hn::Lanes(d)) {
        Texels8 color = unpacked(hn::LoadU(d, batch.color.data() + i));
        for (std::size_t u = 0; u < s.units; ++u)
            color = combined(s.unit[u], texels_of(s.unit[u], batch, u, i), color);
        hn::StoreU(repacked(color), d, batch.color.data() + i);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(shade_bytes);

void shade(const Shader<std::uint32_t>& s, ByteBatch& batch) {
    HWY_DYNAMIC_DISPATCH(shade_bytes)(s, batch);
}

}  // namespace twofold::lanes
#endif
