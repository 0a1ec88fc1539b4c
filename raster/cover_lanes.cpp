#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/cover_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// A number below 2^31 in magnitude rounded to units of 2^-19, in the lower bits of a word, and one
/// unit more.
HWY_INLINE hn::Vec<U> fixed(V x) {
    return hn::BitCast(U(), hn::Add(x, hn::Set(D(), 0x1.8p33 + 0x1p-19)));
}

/// Whether the floors of two vectors of such numbers could be others' that are within 2^-21 of
/// them.
HWY_INLINE hn::Mask<DI> in_doubt(hn::Vec<U> low, hn::Vec<U> high) {
    const DI di;
    return hn::Eq(hn::And(lower_halves(low, high), hn::Set(di, 0x7fffe)), hn::Zero(di));
}

/// The floors of two vectors of such numbers that are not in doubt.
HWY_INLINE VI floors(hn::Vec<U> low, hn::Vec<U> high) {
    return lower_halves(hn::ShiftRight<19>(low), hn::ShiftRight<19>(high));
}

/// Pixels of one row, the first at (x, y) from the triangle's first.
struct RowPixels {
    int x, y;
};

/// Depth by divisions, half a vector of pixels from x on.
HWY_INLINE V exact_depth(const Triangle& t, double x, double y) {
    const D d;
    const V vx = hn::Iota(d, x), vy = hn::Set(d, y);
    const V more = hn::Add(hn::Mul(at(t.e[1], vx, vy), hn::Set(d, t.dz1)),
                           hn::Mul(at(t.e[2], vx, vy), hn::Set(d, t.dz2)));
    return hn::Add(hn::Set(d, t.z0), hn::Div(more, hn::Set(d, t.area)));
}

/// Depth as an integer buffer holds it.
HWY_NOINLINE VI quantised_depth(const Triangle& t, const DepthRule& rule, RowPixels p) {
    const D d;
    const auto quantised = [&](double x) HWY_ATTR {
        const V z = exact_depth(t, x, p.y);
        const V inside = hn::Min(hn::Max(z, hn::Zero(d)), hn::Set(d, 1.0));
        return hn::DemoteTo(
            I(), hn::Add(hn::Mul(inside, hn::Set(d, rule.steps)), hn::Set(d, rule.half)));
    };
    const DI di;
    const double half = static_cast<double>(hn::Lanes(d));
    return hn::Combine(di, quantised(p.x + half), quantised(p.x));
}

/// Depth of a buffer of integers, a vector of pixels at a time.
class IntegerDepth {
  public:
    using Pixels = DI;

    IntegerDepth(const Triangle& t, const DepthRule& rule) : t_(t), rule_(rule) {
        const D d;
        const V dx = hn::Set(d, t.near_depth.dx);
        low_ = hn::Mul(hn::Iota(d, 0.0), dx);
        high_ = hn::Mul(hn::Iota(d, static_cast<double>(hn::Lanes(d))), dx);
        step_ = hn::Mul(hn::Set(d, static_cast<double>(hn::Lanes(DI()))), dx);
    }

    /// From here on the pixels from (t.x0, t.y0 + down).
    HWY_INLINE void start_row(int down) {
        first_ = at(t_.near_depth, hn::Zero(D()), hn::Set(D(), static_cast<double>(down)));
    }
    HWY_INLINE void step() { first_ = hn::Add(first_, step_); }

    /// Tests and writes the depth of pixels of which `m` are covered, appends those that are left
    /// and returns their number.
    HWY_INLINE std::size_t keep(RowPixels p, hn::Mask<DI> m, std::uint32_t* depth, VI places,
                                std::int32_t* at, double* z_out) const {
        const DI d;
        if (rule_.computed) {
            const VI z = depth_at(p);
            if (rule_.early) {
                auto* const stored = reinterpret_cast<std::int32_t*>(depth);
                const VI old = hn::LoadU(d, stored);
                m = hn::And(m, passes(d, rule_.func, z, old));
                if (rule_.write) hn::StoreU(hn::IfThenElse(m, z, old), d, stored);
            } else {
                alignas(64) std::array<std::int32_t, widest> kept;
                append(d, z, m, kept.data());
                const Two real = as_real(hn::Load(d, kept.data()));
                hn::StoreU(real.low, D(), z_out);
                hn::StoreU(real.high, D(), z_out + hn::Lanes(D()));
            }
        }
        append(d, places, m, at);
        return hn::CountTrue(d, m);
    }

  private:
    /// Divisions are done only where they could make a difference.
    HWY_INLINE VI depth_at(RowPixels p) const {
        const auto low = fixed(hn::Add(first_, low_)), high = fixed(hn::Add(first_, high_));
        const bool sure = hn::AllFalse(DI(), in_doubt(low, high));
        if (HWY_LIKELY(t_.near_depth_usable && sure)) return floors(low, high);
        return quantised_depth(t_, rule_, p);
    }

    const Triangle& t_;
    const DepthRule rule_;
    V first_, low_, high_, step_;
};

/// Depth of a buffer of binary64.
class RealDepth {
  public:
    using Pixels = I;

    RealDepth(const Triangle& t, const DepthRule& rule) : t_(t), rule_(rule) {}

    HWY_INLINE void start_row(int) {}
    HWY_INLINE void step() {}

    HWY_INLINE std::size_t keep(RowPixels p, hn::Mask<I> m, double* depth, hn::Vec<I> places,
                                std::int32_t* at, double* z_out) const {
        const D d;
        using S = hn::RebindToSigned<D>;
        Mask inside = hn::MaskFromVec(hn::BitCast(d, hn::PromoteTo(S(), hn::VecFromMask(I(), m))));
        if (rule_.computed) {
            const V z = exact_depth(t_, p.x, p.y);
            if (rule_.early) {
                const V old = hn::LoadU(d, depth);
                inside = hn::And(inside, passes(d, rule_.func, z, old));
                if (rule_.write) hn::StoreU(hn::IfThenElse(inside, z, old), d, depth);
            } else {
                append(d, z, inside, z_out);
            }
        }
        alignas(64) std::array<double, widest> kept;
        append(d, hn::PromoteTo(d, places), inside, kept.data());
        hn::StoreU(hn::DemoteTo(I(), hn::Load(d, kept.data())), I(), at);
        return hn::CountTrue(d, inside);
    }

  private:
    const Triangle& t_;
    const DepthRule& rule_;
};

/// The three edges at a vector of pixels: negative in a lane where one is.
template <class T>
struct Edges {
    using Vec = hn::Vec<T>;
    Vec e0, e1, e2;

    HWY_INLINE Vec outside() const { return hn::Or(hn::Or(e0, e1), e2); }
    HWY_INLINE Edges operator+(const Edges& o) const {
        return {hn::Add(e0, o.e0), hn::Add(e1, o.e1), hn::Add(e2, o.e2)};
    }
};

/// The same number of pixels from each edge on: `all(edge)` of each.
template <class T, class Of>
HWY_INLINE Edges<T> edges_of(T d, const Triangle& t, Of&& of) {
    return {hn::Set(d, of(t.cover[0])), hn::Set(d, of(t.cover[1])), hn::Set(d, of(t.cover[2]))};
}

template <class Rule, class Depth>
HWY_INLINE Covered cover_rows(const Triangle& t, const DepthRule& rule, Depth* depth, int row,
                              std::size_t size, BatchPlaces& out) {
    using Pixels = typename Rule::Pixels;
    const Pixels d;
    Rule depth_rule(t, rule);
    const auto lanes = static_cast<int>(hn::Lanes(d));
    const auto iota = hn::Iota(d, 0);
    const Edges<Pixels> step_right =
        edges_of(d, t, [lanes](const CoverEdge& e) { return e.dx * lanes; });
    const Edges<Pixels> step_down = edges_of(d, t, [](const CoverEdge& e) { return e.dy; });
    const Edges<Pixels> lane = edges_of(d, t, [](const CoverEdge& e) { return e.dx; });
    const int from = row - t.y0;
    Edges<Pixels> start =
        edges_of(d, t, [from](const CoverEdge& e) { return e.first + e.dy * from; });
    start = start +
            Edges<Pixels>{hn::Mul(iota, lane.e0), hn::Mul(iota, lane.e1), hn::Mul(iota, lane.e2)};
    // The last vector of a row may reach beyond the pixels to visit.
    const int width = t.x1 - t.x0, whole = (width - 1) / lanes * lanes;
    const auto last = hn::FirstN(d, static_cast<std::size_t>(width - whole));
    std::size_t n = 0;
    for (; row < t.y1 && n < cover_capacity; ++row, start = start + step_down) {
        depth_rule.start_row(row - t.y0);
        Edges<Pixels> e = start;
        for (int x = 0; x < width; x += lanes, e = e + step_right, depth_rule.step()) {
            auto m = hn::Gt(e.outside(), hn::Set(d, -1));
            if (x == whole) m = hn::And(m, last);
            if (hn::AllFalse(d, m)) continue;
            const int place = row * tile_edge + t.x0 + x;
            n +=
                depth_rule.keep({x, row - t.y0}, m, depth + place, hn::Add(hn::Set(d, place), iota),
                                out.at.data() + size + n, out.z.data() + size + n);
        }
    }
    // What lies behind the last fragment up to a full vector must be a place in the triangle too.
    hn::StoreU(hn::Set(d, t.y0 * tile_edge + t.x0), d, out.at.data() + size + n);
    return {row, n};
}

Covered cover_u32(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
                  std::size_t size, BatchPlaces& out) {
    return cover_rows<IntegerDepth>(t, rule, depth, row, size, out);
}
Covered cover_f64(const Triangle& t, const DepthRule& rule, double* depth, int row,
                  std::size_t size, BatchPlaces& out) {
    return cover_rows<RealDepth>(t, rule, depth, row, size, out);
}
/// Whole cache lines at a time where vectors are so wide: a processor need not read them first.
void fill_u32(std::uint32_t* words, std::size_t size, std::uint32_t value) {
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t lanes = hn::Lanes(d);
    const auto values = hn::Set(d, value);
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) hn::StoreU(values, d, words + i);
    for (; i < size; ++i) words[i] = value;
}
const char* target_name() { return on_sse2 ? "SSE2" : hwy::TargetName(HWY_TARGET); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(cover_u32);
HWY_EXPORT(cover_f64);
HWY_EXPORT(fill_u32);
HWY_EXPORT(target_name);

Covered cover(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
              std::size_t size, BatchPlaces& out) {
    return HWY_DYNAMIC_DISPATCH(cover_u32)(t, rule, depth, row, size, out);
}
Covered cover(const Triangle& t, const DepthRule& rule, double* depth, int row, std::size_t size,
              BatchPlaces& out) {
    return HWY_DYNAMIC_DISPATCH(cover_f64)(t, rule, depth, row, size, out);
}
void fill(std::uint32_t* words, std::size_t size, std::uint32_t value) {
    HWY_DYNAMIC_DISPATCH(fill_u32)(words, size, value);
}
const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace twofold::lanes
#endif
