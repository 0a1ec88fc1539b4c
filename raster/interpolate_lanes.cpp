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

/// How many divisions 1/q of both units takes: one where both q are the same or their product can
/// be divided by.
enum class Divisions { same, product, each };

Divisions divisions_of(const Near& a, const Near& b) {
    if (a.q_of_vertex == b.q_of_vertex) return Divisions::same;
    return a.moderate && b.moderate ? Divisions::product : Divisions::each;
}

/// A triangle's units that are placed by linear numbers and 1/q.
struct Placing {
    const Triangle& t;
    const ByteCorners& c;
    const Shader<std::uint32_t>& s;
    const std::array<Near, lane_units>& near;
    std::size_t begin, end;  ///< of the units

    /// Footprints of unit u where no doubt is left, else as the reference finds them.
    /// @param planes  planes(unit, k): plane k of Near at the fragments from i on
    template <class Planes>
    HWY_INLINE void place(std::size_t u, const NearImage& image, const Planes& planes,
                          const Two& over_q, std::size_t i, ByteBatch& out) const {
        const VI x = image.x.units(product(planes(u, Near::x), over_q));
        const VI y = image.y.units(product(planes(u, Near::y), over_q));
        if (HWY_LIKELY(hn::AllFalse(DI(), hn::Or(in_doubt(x), in_doubt(y)))))
            store(image.footprints(x, y), u, i, out);
        else
            store(footprints_by_division(t, c, s, u, out.places.at.data() + i), u, i, out);
    }
};

HWY_INLINE Two reciprocal(const Two& q) {
    return {near_reciprocal(q.low), near_reciprocal(q.high)};
}

struct OneUnit : Placing {
    NearImage image;

    HWY_INLINE explicit OneUnit(const Placing& p) : Placing(p), image(s.unit[begin].image) {}

    template <class Planes>
    HWY_INLINE void operator()(const Planes& planes, std::size_t i, ByteBatch& out) const {
        place(begin, image, planes, reciprocal(planes(begin, Near::q)), i, out);
    }
};

struct BothUnits : Placing {
    NearImage image0, image1;
    Divisions divisions;

    HWY_INLINE explicit BothUnits(const Placing& p)
        : Placing(p),
          image0(s.unit[0].image),
          image1(s.unit[1].image),
          divisions(divisions_of(near[0], near[1])) {}

    template <class Planes>
    HWY_INLINE void operator()(const Planes& planes, std::size_t i, ByteBatch& out) const {
        const Two q = planes(0, Near::q);
        Two over0, over1;
        if (divisions == Divisions::same) {
            over0 = over1 = reciprocal(q);
        } else if (divisions == Divisions::each) {
            over0 = reciprocal(q);
            over1 = reciprocal(planes(1, Near::q));
        } else {
            const Two q1 = planes(1, Near::q), over = reciprocal(product(q, q1));
            over0 = product(over, q1);
            over1 = product(over, q);
        }
        place(0, image0, planes, over0, i, out);
        place(1, image1, planes, over1, i, out);
    }
};

/// Whether `count` fragments are all pixels of some rows between t.x0 and t.x1: as there are no
/// more of them between the first row and the last.
bool fill_rows(const Triangle& t, const std::int32_t* at, std::size_t count) {
    const int rows = (at[count - 1] >> tile_edge_bits) - (at[0] >> tile_edge_bits) + 1;
    return static_cast<int>(count) == rows * (t.x1 - t.x0);
}

/// Fragments that fill rows: what y gives to a plane is found once a row. A vector at the end of a
/// row reaches behind it, where the next row's overwrite what it wrote.
template <class Units>
void place_rows(const Units& units, std::size_t count, ByteBatch& out) {
    const D d;
    const Triangle& t = units.t;
    const auto width = static_cast<std::size_t>(t.x1 - t.x0), lanes = hn::Lanes(d);
    const Two columns{hn::Iota(d, 0.0), hn::Iota(d, static_cast<double>(lanes))};
    for (std::size_t i = out.size; i < out.size + count; i += width) {
        const double y = (out.places.at[i] >> tile_edge_bits) - t.y0;
        std::array<std::array<double, 4>, lane_units> first;
        for (std::size_t u = units.begin; u < units.end; ++u)
            for (std::size_t k = 0; k < 4; ++k)
                first[u][k] = units.near[u].planes.first[k] + y * units.near[u].planes.dy[k];
        for (std::size_t x = 0; x < width; x += 2 * lanes) {
            const V start = hn::Set(d, static_cast<double>(x));
            const Two at{hn::Add(columns.low, start), hn::Add(columns.high, start)};
            const auto planes = [&](std::size_t u, std::size_t k) HWY_ATTR {
                const V dx = hn::Set(d, units.near[u].planes.dx[k]), at0 = hn::Set(d, first[u][k]);
                return Two{hn::Add(hn::Mul(at.low, dx), at0), hn::Add(hn::Mul(at.high, dx), at0)};
            };
            units(planes, i + x, out);
        }
    }
}

template <class Units>
void place_anywhere(const Units& units, std::size_t count, ByteBatch& out) {
    const DI di;
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(di)) {
        const VI at = hn::LoadU(di, out.places.at.data() + i);
        const Two x = columns_of(units.t, at), y = rows_of(units.t, at);
        const auto planes = [&](std::size_t u, std::size_t k) HWY_ATTR {
            const FourPlanes& p = units.near[u].planes;
            return Two{p.at(k, x.low, y.low), p.at(k, x.high, y.high)};
        };
        units(planes, i, out);
    }
}

template <class Units>
HWY_INLINE void place_near(const Units& units, std::size_t count, ByteBatch& out) {
    const auto width = static_cast<std::size_t>(units.t.x1 - units.t.x0);
    if (width >= 4 * hn::Lanes(DI()) && fill_rows(units.t, out.places.at.data() + out.size, count))
        place_rows(units, count, out);
    else
        place_anywhere(units, count, out);
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
    if (near[0].usable && near[1].usable)
        return place_near(BothUnits({t, c, s, near, 0, 2}), count, out);
    for (std::size_t u = 0; u < s.units; ++u) {
        if (c.choose_level[u]) continue;
        if (near[u].usable)
            place_near(OneUnit({t, c, s, near, u, u + 1}), count, out);
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
