#include "raster/lanes.hpp"

#include "raster/lane_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/cover_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

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

/// Depth as the buffer holds it, still in binary64.
HWY_INLINE V quantised(const DepthRule& rule, V z) {
    const D d;
    const V inside = hn::Min(hn::Max(z, hn::Zero(d)), hn::Set(d, 1.0));
    return hn::Add(hn::Mul(inside, hn::Set(d, rule.steps)), hn::Set(d, rule.half));
}

/// Depth in units of the buffer, before it is cut, as a number linear in the window: within 2^-24 of
/// what divisions give if the triangle's depths are moderate.
struct NearDepth {
    double first, per_e1, per_e2, least, most;

    NearDepth(const Triangle& t, const DepthRule& rule)
        : first(t.z0 * rule.steps + rule.half),
          per_e1(t.dz1 * rule.steps * t.over_area),
          per_e2(t.dz2 * rule.steps * t.over_area),
          least(rule.half),
          most(rule.steps + rule.half) {}

    HWY_INLINE V at(V e1, V e2) const {
        const D d;
        const V z = hn::Add(hn::Set(d, first), hn::Add(hn::Mul(e1, hn::Set(d, per_e1)),
                                                       hn::Mul(e2, hn::Set(d, per_e2))));
        return hn::Min(hn::Max(z, hn::Set(d, least)), hn::Set(d, most));
    }
};

HWY_INLINE V exact_depth(const Triangle& t, V e1, V e2) {
    const D d;
    const V more = hn::Add(hn::Mul(e1, hn::Set(d, t.dz1)), hn::Mul(e2, hn::Set(d, t.dz2)));
    return hn::Add(hn::Set(d, t.z0), hn::Div(more, hn::Set(d, t.area)));
}

/// Depth as the buffer holds it. Divisions are done only where they could make a difference.
HWY_INLINE V depth_at(const Triangle& t, const DepthRule& rule, const NearDepth& near, V e1, V e2,
                      std::uint32_t*) {
    const V z = near.at(e1, e2);
    const V whole = hn::Floor(z);
    if (HWY_LIKELY(t.moderate_depth && !in_doubt(z, whole))) return whole;
    return hn::Floor(quantised(rule, exact_depth(t, e1, e2)));
}
HWY_INLINE V depth_at(const Triangle& t, const DepthRule&, const NearDepth&, V e1, V e2, double*) {
    return exact_depth(t, e1, e2);
}

HWY_INLINE V loaded(const std::uint32_t* p) {
    return hn::PromoteTo(D(), hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(p)));
}
HWY_INLINE V loaded(const double* p) { return hn::LoadU(D(), p); }
HWY_INLINE void stored(V z, std::uint32_t* p) {
    hn::StoreU(hn::DemoteTo(I(), z), I(), reinterpret_cast<std::int32_t*>(p));
}
HWY_INLINE void stored(V z, double* p) { hn::StoreU(z, D(), p); }
/// Stores the lanes of the mask, close together; up to a full vector may be written. Not Compress:
/// g++ 12 copies Highway 1.0.3's table for it to the stack at every call.
HWY_INLINE void append(V v, Mask m, double* p) {
    const D d;
    if (hn::AllTrue(d, m))
        hn::StoreU(v, d, p);
    else
        hn::CompressStore(v, m, d, p);
}

template <class Depth>
int cover_rows(const Triangle& t, const DepthRule& rule, Depth* depth, int row, Span& out) {
    const D d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const V iota = hn::Iota(d, 0.0);
    const V step0 = hn::Set(d, t.dx[0] * lanes), step1 = hn::Set(d, t.dx[1] * lanes);
    const V step2 = hn::Set(d, t.dx[2] * lanes);
    const V first0 = hn::Mul(iota, hn::Set(d, t.dx[0])), first1 = hn::Mul(iota, hn::Set(d, t.dx[1]));
    const V first2 = hn::Mul(iota, hn::Set(d, t.dx[2]));
    const V least0 = hn::Set(d, t.least[0]), least1 = hn::Set(d, t.least[1]);
    const V least2 = hn::Set(d, t.least[2]);
    const NearDepth near(t, rule);
    const bool late = rule.computed && !rule.early;
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
            V z = hn::Zero(d);
            if (rule.computed) {
                z = depth_at(t, rule, near, w1, w2, depth);
                if (rule.early) {
                    const V old = loaded(depth + at);
                    m = hn::And(m, passes(rule.func, z, old));
                    if (rule.write) stored(hn::IfThenElse(m, z, old), depth + at);
                }
            }
            const V places = hn::Add(hn::Set(d, at), iota);
            append(w1, m, out.e1.data() + n);
            append(w2, m, out.e2.data() + n);
            append(places, m, out.at.data() + n);
            if (late) append(z, m, out.z.data() + n);
            n += hn::CountTrue(d, m);
        }
    }
    out.size = n;
    return row;
}

int cover_u32(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row, Span& out) {
    return cover_rows(t, rule, depth, row, out);
}
int cover_f64(const Triangle& t, const DepthRule& rule, double* depth, int row, Span& out) {
    return cover_rows(t, rule, depth, row, out);
}
const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(cover_u32);
HWY_EXPORT(cover_f64);
HWY_EXPORT(target_name);

int cover(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row, Span& out) {
    return HWY_DYNAMIC_DISPATCH(cover_u32)(t, rule, depth, row, out);
}
int cover(const Triangle& t, const DepthRule& rule, double* depth, int row, Span& out) {
    return HWY_DYNAMIC_DISPATCH(cover_f64)(t, rule, depth, row, out);
}
const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace twofold::lanes
#endif
