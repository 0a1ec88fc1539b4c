// What the vector loops share, compiled once for each instruction set: no #pragma once.
#include <hwy/highway.h>

#include "raster/lanes.hpp"

#if HWY_ARCH_X86_64
#include "raster/sse2_lanes.hpp"
#endif

#if defined(TWOFOLD_LANE_MATH) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_MATH
#undef TWOFOLD_LANE_MATH
#else
#define TWOFOLD_LANE_MATH
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {
#if HWY_ARCH_X86_64 && HWY_TARGET == HWY_EMU128
namespace hn = sse2;
constexpr bool on_sse2 = true;
#else
namespace hn = hwy::HWY_NAMESPACE;
constexpr bool on_sse2 = false;
#endif

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
using I = hn::Rebind<std::int32_t, D>;

using U = hn::RebindToUnsigned<D>;

/// Fragments are walked by vectors of 32-bit integers, which take two of binary64.
using DI = hn::ScalableTag<std::int32_t>;
using VI = hn::Vec<DI>;
struct Two {
    V low, high;
};

HWY_INLINE Two as_real(VI v) {
    return {hn::PromoteTo(D(), hn::LowerHalf(I(), v)), hn::PromoteTo(D(), hn::UpperHalf(I(), v))};
}

HWY_INLINE Two product(const Two& a, const Two& b) {
    return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
}

HWY_INLINE V at(const Plane& p, V x, V y) {
    const D d;
    return hn::Add(hn::Set(d, p.first),
                   hn::Add(hn::Mul(x, hn::Set(d, p.dx)), hn::Mul(y, hn::Set(d, p.dy))));
}

/// The lower halves of the words of two vectors.
HWY_INLINE VI lower_halves(hn::Vec<U> low, hn::Vec<U> high) {
    const DI di;
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return hn::ConcatOdd(di, hn::BitCast(di, high), hn::BitCast(di, low));
#else
    return hn::ConcatEven(di, hn::BitCast(di, high), hn::BitCast(di, low));
#endif
}

/// a b, both from 0 to 2^15 - 1. SSE2's vectors have their own.
template <class T>
HWY_INLINE T small_product(T a, T b) {
    return hn::Mul(a, b);
}

/// compare() of fragment_ops.hpp.
template <class T>
HWY_INLINE hn::Mask<T> passes(T d, CompareFunc func, hn::Vec<T> z, hn::Vec<T> stored) {
    switch (func) {
        case CompareFunc::never:
            return hn::FirstN(d, 0);
        case CompareFunc::less:
            return hn::Lt(z, stored);
        case CompareFunc::equal:
            return hn::Eq(z, stored);
        case CompareFunc::lequal:
            return hn::Not(hn::Lt(stored, z));
        case CompareFunc::greater:
            return hn::Lt(stored, z);
        case CompareFunc::notequal:
            return hn::Ne(z, stored);
        case CompareFunc::gequal:
            return hn::Not(hn::Lt(z, stored));
        case CompareFunc::always:
            break;
    }
    return hn::FirstN(d, hn::Lanes(d));
}

/// Stores the lanes of the mask, close together; up to a full vector may be written. Not Compress:
/// g++ 12 copies Highway 1.0.3's table for it to the stack at every call.
template <class T>
HWY_INLINE void append(T d, hn::Vec<T> v, hn::Mask<T> m, hn::TFromD<T>* p) {
    if (hn::AllTrue(d, m))
        hn::StoreU(v, d, p);
    else
        hn::CompressStore(v, m, d, p);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
