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

HWY_INLINE Texels8 gathered(const std::uint32_t* base, hn::Vec<S32> at) {
    return unpacked(hn::GatherIndex(U32(), base, at));
}

/// Texels side by side at as many places as there are 32-bit lanes.
struct Pairs {
    Texels8 left, right;
};

using U64 = hn::Repartition<std::uint64_t, U32>;
using S64 = hn::RebindToSigned<U64>;

/// Two texels are read at once: half as many loads.
HWY_INLINE Pairs pairs_at(const std::uint32_t* base, hn::Vec<S64> low, hn::Vec<S64> high) {
    const U32 d;
    const auto* const words = reinterpret_cast<const std::uint64_t*>(base);
    const auto l = hn::BitCast(d, hn::GatherOffset(U64(), words, low));
    const auto h = hn::BitCast(d, hn::GatherOffset(U64(), words, high));
    return {unpacked(hn::ConcatEven(d, h, l)), unpacked(hn::ConcatOdd(d, h, l))};
}

/// Nv17::filter on all four channels.
HWY_INLINE Texels8 filtered(const Image<std::uint32_t>& image, hn::Vec<S32> at,
                            hn::Vec<U32> weights) {
    const auto low = hn::And(weights, hn::Set(U32(), 0xffffu));
    const auto high = hn::ShiftRight<16>(weights);
    const Bytes a = hn::BitCast(U16(), hn::Or(low, hn::ShiftLeft<16>(low)));
    const Bytes b = hn::BitCast(U16(), hn::Or(high, hn::ShiftLeft<16>(high)));
    const hn::Half<S32> half;
    const auto bytes = hn::ShiftLeft<2>(at);
    const auto at_low = hn::PromoteTo(S64(), hn::LowerHalf(half, bytes));
    const auto at_high = hn::PromoteTo(S64(), hn::UpperHalf(half, bytes));
    const Pairs top = pairs_at(image.texels, at_low, at_high);
    const Pairs next = pairs_at(image.texels + image.stride, at_low, at_high);
    return {flerp16(flerp16(top.left.rb, top.right.rb, a), flerp16(next.left.rb, next.right.rb, a), b),
            flerp16(flerp16(top.left.ga, top.right.ga, a), flerp16(next.left.ga, next.right.ga, a), b)};
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
    const S32 ds;
    // What lies behind the last fragment up to a full vector must be an address too.
    for (std::size_t u = 0; u < s.units; ++u)
        for (std::size_t i = batch.size; i < batch.size + widest; ++i) batch.offset[u][i] = 0;
    for (std::size_t i = 0; i < batch.size; i += hn::Lanes(d)) {
        Texels8 color = unpacked(hn::LoadU(d, batch.color.data() + i));
        for (std::size_t u = 0; u < s.units; ++u) {
            const Unit<std::uint32_t>& unit = s.unit[u];
            const auto at = hn::LoadU(ds, batch.offset[u].data() + i);
            const auto weights = hn::LoadU(d, batch.weights[u].data() + i);
            color = combined(unit,
                             unit.linear ? filtered(unit.image, at, weights)
                                         : gathered(unit.image.texels, at),
                             color);
        }
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
