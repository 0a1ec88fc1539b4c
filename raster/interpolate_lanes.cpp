#include <algorithm>
#include <cmath>

#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/interpolate_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_math-inl.hpp"
#include "raster/lane_weights-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE VI column_of(VI at) { return hn::And(at, hn::Set(DI(), tile_edge - 1)); }
HWY_INLINE VI row_of(VI at) { return hn::ShiftRight<tile_edge_bits>(at); }

/// The largest magnitude of what a sum over the vertices passes through on the way to its value.
using Reach = std::array<double, 3>;

/// A bound of each doubled area in the pixels to visit.
Reach reach_of(const Triangle& t) {
    Reach reach;
    for (std::size_t k = 0; k < 3; ++k)
        reach[k] = std::fabs(t.e[k].first) + std::fabs(t.e[k].dx) * (t.x1 - t.x0) +
                   std::fabs(t.e[k].dy) * (t.y1 - t.y0);
    return reach;
}

struct FourPlanes {
    alignas(32) std::array<double, 4> first, dx, dy;

    HWY_INLINE V at(std::size_t k, V x, V y) const {
        return HWY_NAMESPACE::at(Plane{first[k], dx[k], dy[k]}, x, y);
    }
};

/// A unit's places in its texture as two linear numbers over a third: x and y in 1/256 texel, with
/// LINEAR from the centre of texel (0, 0), times q. Near the reference's places by less than 2^-20
/// if they are `usable`.
struct Near {
    static constexpr std::size_t x = 0, y = 1, q = 3;  ///< where s, t, q lie
    FourPlanes planes;
    std::array<double, 3> q_of_vertex;
    bool usable = false;
    bool moderate = false;  ///< a product of two such q is a number of binary32

    HWY_INLINE Near(const Triangle& t, const Reach& reach, const ByteCorners& c,
                    const Shader<std::uint32_t>& s, std::size_t u) {
        if (u >= s.units || c.choose_level[u] || !knows_reciprocals(s.unit[u])) return;
        std::array<double, 3> w{1.0, 1.0, 1.0};
        if (!c.over_w && !t.equal_w) w = t.inverse_w;
        for (std::size_t k = 0; k < 3; ++k) q_of_vertex[k] = w[k] * (*c.coords[u][k])[q];
        alignas(32) std::array<double, 4> largest;
        weigh(t, reach, c, s.unit[u], u, w, largest);
        // Each rounding strays by 2^-53 of the largest term. Places above 2^20 are clamped.
        const double least = t.area * std::min(std::min(std::fabs(q_of_vertex[0]),
                                                        std::fabs(q_of_vertex[1])),
                                               std::fabs(q_of_vertex[2]));
        usable = largest[x] <= 0x1p26 * least && largest[y] <= 0x1p26 * least &&
                 largest[q] <= 0x1p8 * least;
        moderate = usable && least >= 0x1p-50 && largest[q] <= 0x1p50;
    }

  private:
    /// What the vertices have, weighted by the doubled areas, and the largest magnitude that a sum
    /// passes through.
    HWY_INLINE void weigh(const Triangle& t, const Reach& reach, const ByteCorners& c,
                          const Unit<std::uint32_t>& unit, std::size_t u,
                          const std::array<double, 3>& w, std::array<double, 4>& largest) {
        const Four four;
        for (std::size_t i = 0; i < 4; i += hn::Lanes(four)) {
            const auto value = [&](std::size_t k) HWY_ATTR {
                const auto v = hn::LoadU(four, c.coords[u][k]->data() + i);
                const auto scaled = hn::Mul(hn::Mul(v, hn::Set(four, w[k])),
                                            hn::LoadU(four, unit.scale.data() + i));
                return hn::Sub(scaled, hn::Mul(hn::LoadU(four, unit.shift.data() + i),
                                               hn::Set(four, q_of_vertex[k])));
            };
            const auto v0 = value(0), v1 = value(1), v2 = value(2);
            const auto sum = [&](double a, double b, double d) HWY_ATTR {
                return hn::Add(hn::Add(hn::Mul(v0, hn::Set(four, a)), hn::Mul(v1, hn::Set(four, b))),
                               hn::Mul(v2, hn::Set(four, d)));
            };
            const auto magnitudes =
                hn::Add(hn::Add(hn::Mul(hn::Abs(v0), hn::Set(four, reach[0])),
                                hn::Mul(hn::Abs(v1), hn::Set(four, reach[1]))),
                        hn::Mul(hn::Abs(v2), hn::Set(four, reach[2])));
            hn::Store(sum(t.e[0].first, t.e[1].first, t.e[2].first), four, planes.first.data() + i);
            hn::Store(sum(t.e[0].dx, t.e[1].dx, t.e[2].dx), four, planes.dx.data() + i);
            hn::Store(sum(t.e[0].dy, t.e[1].dy, t.e[2].dy), four, planes.dy.data() + i);
            hn::Store(magnitudes, four, largest.data() + i);
        }
    }
};

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
    const auto product = [](const Two& a, const Two& b) HWY_ATTR {
        return Two{hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
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

HWY_INLINE Two columns_of(const Triangle& t, VI at) {
    return as_real(hn::Sub(column_of(at), hn::Set(DI(), t.x0)));
}
HWY_INLINE Two rows_of(const Triangle& t, VI at) {
    return as_real(hn::Sub(row_of(at), hn::Set(DI(), t.y0)));
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
    const std::array<Near, lane_units> near{Near(t, reach, c, s, 0), Near(t, reach, c, s, 1)};
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
        const auto color = hn::Or(hn::Or(channel(0), hn::ShiftLeft<8>(channel(1))),
                                  hn::Or(hn::ShiftLeft<16>(channel(2)),
                                         hn::ShiftLeft<24>(channel(3))));
        hn::StoreU(color, di, reinterpret_cast<std::int32_t*>(out + i));
    }
}

/// Whole vectors: a batch has room.
HWY_INLINE void fill_vectors(std::uint32_t* words, std::size_t size, std::uint32_t value) {
    const hn::RebindToUnsigned<DI> d;
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) hn::StoreU(hn::Set(d, value), d, words + i);
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
