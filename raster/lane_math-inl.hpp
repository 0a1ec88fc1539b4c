// What the vector loops share, compiled once for each instruction set: no #pragma once.
#include <hwy/highway.h>

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
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
using I = hn::Rebind<std::int32_t, D>;

/// How near to an integer a number may be before its floor is in doubt. Products with a reciprocal
/// stray from quotients by less.
constexpr double doubt = 0x1p-20;

/// Whether a lane's floor could be another's if the numbers were computed with divisions.
HWY_INLINE bool in_doubt(V x, V floor_x, V y, V floor_y) {
    const D d;
    const V a = hn::Sub(x, floor_x), b = hn::Sub(y, floor_y);
    return !hn::AllFalse(d, hn::Or(hn::Lt(hn::Min(a, b), hn::Set(d, doubt)),
                                   hn::Gt(hn::Max(a, b), hn::Set(d, 1.0 - doubt))));
}
HWY_INLINE bool in_doubt(V x, V floor_x) { return in_doubt(x, floor_x, x, floor_x); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
