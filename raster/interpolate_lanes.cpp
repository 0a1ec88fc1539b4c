#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/interpolate_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_math-inl.hpp"
#include "raster/lane_near-inl.hpp"
#include "raster/lane_weights-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

HWY_NOINLINE Footprints footprints_by_division(const Triangle& t, const ByteCorners& c,
                                               const Shader<std::uint32_t>& s, std::size_t u,
                                               const std::int32_t* at) {
    const DI di;
    const auto half = [&](const std::int32_t* from) HWY_ATTR {
        const D d;
        const auto coordinates = coordinates_at(d, c, u, coordinate_weights(d, t, c, from));
        return in_bytes(footprint(d, Addresses<D>(d, s.unit[u]), coordinates));
    };
    const Footprint8 low = half(at), high = half(at + hn::Lanes(D()));
    return {hn::Combine(di, high.offset, low.offset), hn::Combine(di, high.weights, low.weights)};
}

HWY_INLINE void store(const Footprints& f, std::size_t u, std::size_t i, ByteBatch& out) {
    const DI di;
    hn::StoreU(f.offset, di, out.fine[u].offset.data() + i);
    hn::StoreU(f.weights, di, reinterpret_cast<std::int32_t*>(out.fine[u].weights.data() + i));
}

/// Footprints of one unit by linear numbers and 1/q where no doubt is left, else as the reference
/// does.
HWY_INLINE void place_near(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                           std::size_t u, const FourPlanes& p, const Two& x, const Two& y,
                           const Two& over_q, std::size_t i, ByteBatch& out) {
    const auto u_low = fixed(hn::Mul(p.at(Near::x, x.low, y.low), over_q.low));
    const auto v_low = fixed(hn::Mul(p.at(Near::y, x.low, y.low), over_q.low));
    const auto u_high = fixed(hn::Mul(p.at(Near::x, x.high, y.high), over_q.high));
    const auto v_high = fixed(hn::Mul(p.at(Near::y, x.high, y.high), over_q.high));
    const auto doubt = hn::Or(in_doubt(u_low, u_high), in_doubt(v_low, v_high));
    if (HWY_LIKELY(hn::AllFalse(DI(), doubt)))
        store(footprints_at(s.unit[u].image, floors(u_low, u_high), floors(v_low, v_high)), u, i,
              out);
    else
        store(footprints_by_division(t, c, s, u, out.places.at.data() + i), u, i, out);
}

/// 1/q of both units at a vector of fragments.
struct Reciprocals {
    std::array<Two, lane_units> over_q;
};

/// How many divisions the reciprocals take: one where both q are the same or their product can be
/// divided by.
enum class Divisions { same, product, each };

Divisions divisions_of(const Near& a, const Near& b) {
    if (a.q_of_vertex == b.q_of_vertex) return Divisions::same;
    return a.moderate && b.moderate ? Divisions::product : Divisions::each;
}

HWY_INLINE Reciprocals reciprocals_of(Divisions divisions, const std::array<Near, lane_units>& near,
                                      const Two& x, const Two& y) {
    const auto q = [&](std::size_t u) HWY_ATTR {
        return Two{near[u].planes.at(Near::q, x.low, y.low),
                   near[u].planes.at(Near::q, x.high, y.high)};
    };
    const auto reciprocal = [](const Two& v) HWY_ATTR {
        return Two{near_reciprocal(v.low), near_reciprocal(v.high)};
    };
    const Two q0 = q(0);
    if (divisions == Divisions::same) {
        const Two over = reciprocal(q0);
        return {{over, over}};
    }
    const Two q1 = q(1);
    if (divisions == Divisions::each) return {{reciprocal(q0), reciprocal(q1)}};
    const Two over = reciprocal(product(q0, q1));
    return {{product(over, q1), product(over, q0)}};
}

/// Both units, near.
void place_both(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                const std::array<Near, lane_units>& near, std::size_t count, ByteBatch& out) {
    const DI di;
    const Divisions divisions = divisions_of(near[0], near[1]);
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(di)) {
        const VI at = hn::LoadU(di, out.places.at.data() + i);
        const Two x = columns_of(t, at), y = rows_of(t, at);
        const Reciprocals r = reciprocals_of(divisions, near, x, y);
        place_near(t, c, s, 0, near[0].planes, x, y, r.over_q[0], i, out);
        place_near(t, c, s, 1, near[1].planes, x, y, r.over_q[1], i, out);
    }
}

/// One unit, near.
void place_one(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
               std::size_t u, const FourPlanes& planes, std::size_t count, ByteBatch& out) {
    const DI di;
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(di)) {
        const VI at = hn::LoadU(di, out.places.at.data() + i);
        const Two x = columns_of(t, at), y = rows_of(t, at);
        const Two over_q{near_reciprocal(planes.at(Near::q, x.low, y.low)),
                         near_reciprocal(planes.at(Near::q, x.high, y.high))};
        place_near(t, c, s, u, planes, x, y, over_q, i, out);
    }
}

void place_exactly(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                   std::size_t u, std::size_t count, ByteBatch& out) {
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(DI()))
        store(footprints_by_division(t, c, s, u, out.places.at.data() + i), u, i, out);
}

void place_bytes(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                 std::size_t count, ByteBatch& out) {
    const Reach reach = reach_of(t);
    const auto near_of = [&](std::size_t u) {
        return u < s.units && !c.choose_level[u] ? Near(t, reach, c, s.unit[u], u) : Near();
    };
    const std::array<Near, lane_units> near{near_of(0), near_of(1)};
    if (near[0].usable && near[1].usable) return place_both(t, c, s, near, count, out);
    for (std::size_t u = 0; u < s.units; ++u) {
        if (c.choose_level[u]) continue;
        if (near[u].usable)
            place_one(t, c, s, u, near[u].planes, count, out);
        else
            place_exactly(t, c, s, u, count, out);
    }
}

/// Nv17::iterate_color.
void iterate_bytes(const Triangle& t, const ByteCorners& c, const std::int32_t* at,
                   std::size_t count, std::uint32_t* out) {
    const D d;
    const I di;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const EndWeights w = end_weights(t, at + i);
        const auto n0 = hn::DemoteTo(di, w.n0), n2 = hn::DemoteTo(di, w.n2);
        const auto n1 = hn::Sub(hn::Sub(hn::Set(di, 256), n0), n2);
        const auto channel = [&](std::size_t k) HWY_ATTR {
            const auto value = hn::Add(hn::Add(hn::Mul(n0, hn::Set(di, (*c.colors[0])[k])),
                                               hn::Mul(n1, hn::Set(di, (*c.colors[1])[k]))),
                                       hn::Mul(n2, hn::Set(di, (*c.colors[2])[k])));
            return hn::ShiftRight<8>(hn::Add(value, hn::Set(di, 128)));
        };
        const auto color =
            hn::Or(hn::Or(channel(0), hn::ShiftLeft<8>(channel(1))),
                   hn::Or(hn::ShiftLeft<16>(channel(2)), hn::ShiftLeft<24>(channel(3))));
        hn::StoreU(color, di, reinterpret_cast<std::int32_t*>(out + i));
    }
}

/// Whole vectors: a batch has room.
HWY_INLINE void fill_vectors(std::uint32_t* words, std::size_t size, std::uint32_t value) {
    const hn::RebindToUnsigned<DI> d;
    for (std::size_t i = 0; i < size; i += hn::Lanes(d))
        hn::StoreU(hn::Set(d, value), d, words + i);
}

void interpolate_u8(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                    std::size_t count, ByteBatch& out) {
    place_bytes(t, c, s, count, out);
    std::uint32_t* const color = out.color.data() + out.size;
    if (c.one_color)
        fill_vectors(color, count, packed_bytes(*c.colors[0]));
    else
        iterate_bytes(t, c, out.places.at.data() + out.size, count, color);
    out.size += count;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(interpolate_u8);

void interpolate(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                 std::size_t count, ByteBatch& out) {
    HWY_DYNAMIC_DISPATCH(interpolate_u8)(t, c, s, count, out);
}
}  // namespace twofold::lanes
#endif
