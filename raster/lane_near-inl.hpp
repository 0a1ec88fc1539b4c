// Texture places as linear numbers over a third, on vectors, compiled once for each instruction
// set: no #pragma once.
#include <algorithm>
#include <cmath>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_weights-inl.hpp"

#if defined(TWOFOLD_LANE_NEAR) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_NEAR
#undef TWOFOLD_LANE_NEAR
#else
#define TWOFOLD_LANE_NEAR
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// 1 / q to 2^-46: from binary32, and a Newton step.
HWY_INLINE V near_reciprocal(V q) {
    const D d;
    const hn::Rebind<float, D> narrow;
    const V r = hn::PromoteTo(d, hn::Div(hn::Set(narrow, 1.0f), hn::DemoteTo(narrow, q)));
    return hn::Mul(r, hn::Sub(hn::Set(d, 2.0), hn::Mul(q, r)));
}

/// Footprints of a full vector of fragments.
struct Footprints {
    VI offset, weights;
};

/// One axis of an image of at most 4096 texels: places near those of the reference, in 1/256 texel,
/// from where the lesser texel of a footprint is texel 0; CLAMP_TO_EDGE.
class NearAxis {
  public:
    HWY_INLINE explicit NearAxis(int size) : most_(hn::Set(D(), 256.0 * (size - 1) + beside)) {}

    /// In units of 2^-12, and one unit more.
    HWY_INLINE VI units(const Two& places) const {
        const auto word = [this](V place) HWY_ATTR {
            const V held = hn::Min(hn::Max(place, hn::Set(D(), beside)), most_);
            return hn::BitCast(U(), hn::Add(held, hn::Set(D(), 0x1.8p40 + unit)));
        };
        return lower_halves(word(places.low), word(places.high));
    }

  private:
    static constexpr double unit = 0x1p-12;
    /// Limits stand so much above the steps at the ends, whose texels they give without doubt.
    static constexpr double beside = 2 * unit;
    V most_;
};

/// Whether the texels and weights of such units could be others' by places within 2^-13 of them.
HWY_INLINE hn::Mask<DI> in_doubt(VI units) {
    const DI di;
    return hn::Eq(hn::And(units, hn::Set(di, 0xffe)), hn::Zero(di));
}

/// An image, prepared once for all vectors.
struct NearImage {
    NearAxis x, y;
    VI stride, first;

    HWY_INLINE explicit NearImage(const Image<std::uint32_t>& image)
        : x(image.width),
          y(image.height),
          stride(hn::Set(DI(), image.stride)),
          first(hn::Set(DI(), image.stride + 1)) {}

    /// The footprints at places in NearAxis's units.
    HWY_INLINE Footprints footprints(VI ux, VI uy) const {
        const DI di;
        const hn::RebindToUnsigned<DI> du;
        const auto x_units = hn::BitCast(du, ux), y_units = hn::BitCast(du, uy);
        const VI column = hn::BitCast(di, hn::ShiftRight<20>(x_units));
        const VI line = hn::BitCast(di, hn::ShiftRight<20>(y_units));
        const auto a = hn::And(hn::ShiftRight<12>(x_units), hn::Set(du, 0xff));
        const auto b = hn::And(hn::ShiftLeft<4>(y_units), hn::Set(du, 0xff0000));
        return {hn::Add(hn::Add(small_product(line, stride), column), first),
                hn::BitCast(di, hn::Or(a, b))};
    }
};

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
    bool moderate = false;       ///< a product of two such q is a number of binary32
    bool usable_beside = false;  ///< at the neighbours of the triangle's pixels, too

    Near() {}
    HWY_INLINE Near(const Triangle& t, const Reach& reach, const ByteCorners& c,
                    const Unit<std::uint32_t>& unit, std::size_t u) {
        if (!knows_reciprocals(unit)) return;
        std::array<double, 3> w{1.0, 1.0, 1.0};
        if (!c.over_w && !t.equal_w) w = t.inverse_w;
        for (std::size_t k = 0; k < 3; ++k) q_of_vertex[k] = w[k] * (*c.coords[u][k])[q];
        alignas(32) std::array<double, 4> largest;
        weigh(t, reach, c, unit, u, w, largest);
        // Each rounding strays by 2^-53 of the largest term. Places above 2^20 are clamped.
        const double least =
            t.area * std::min(std::min(std::fabs(q_of_vertex[0]), std::fabs(q_of_vertex[1])),
                              std::fabs(q_of_vertex[2]));
        usable = largest[x] <= 0x1p26 * least && largest[y] <= 0x1p26 * least &&
                 largest[q] <= 0x1p8 * least;
        moderate = usable && least >= 0x1p-50 && largest[q] <= 0x1p50;
        const double beside = least - std::max(std::fabs(planes.dx[q]), std::fabs(planes.dy[q]));
        // Places below 2^23 are not clamped.
        usable_beside = usable && largest[x] <= 0x1p23 * beside && largest[y] <= 0x1p23 * beside &&
                        largest[q] <= 0x1p8 * beside;
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
                return hn::Add(
                    hn::Add(hn::Mul(v0, hn::Set(four, a)), hn::Mul(v1, hn::Set(four, b))),
                    hn::Mul(v2, hn::Set(four, d)));
            };
            const auto magnitudes = hn::Add(hn::Add(hn::Mul(hn::Abs(v0), hn::Set(four, reach[0])),
                                                    hn::Mul(hn::Abs(v1), hn::Set(four, reach[1]))),
                                            hn::Mul(hn::Abs(v2), hn::Set(four, reach[2])));
            hn::Store(sum(t.e[0].first, t.e[1].first, t.e[2].first), four, planes.first.data() + i);
            hn::Store(sum(t.e[0].dx, t.e[1].dx, t.e[2].dx), four, planes.dx.data() + i);
            hn::Store(sum(t.e[0].dy, t.e[1].dy, t.e[2].dy), four, planes.dy.data() + i);
            hn::Store(magnitudes, four, largest.data() + i);
        }
    }
};

HWY_INLINE Two columns_of(const Triangle& t, VI at) {
    return as_real(hn::Sub(column_of(at), hn::Set(DI(), t.x0)));
}
HWY_INLINE Two rows_of(const Triangle& t, VI at) {
    return as_real(hn::Sub(row_of(at), hn::Set(DI(), t.y0)));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
