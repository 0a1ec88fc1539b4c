#include "raster/alpha_lanes.hpp"

#include "raster/lane_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/alpha_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

using F = hn::Rebind<float, DI>;
using VF = hn::Vec<F>;

/// The cells, first to behind the last, that footprints between three places may read along one
/// axis. Interpolated coordinates stray from the corners' hull by a few units in the last place of
/// the largest; in binary32 that is 2^-22 of it.
struct Cells {
    VI first, end;

    HWY_INLINE Cells(VF a, VF b, VF c, float scale, int size, int cell_bits) {
        const F f;
        const VF low = hn::Mul(hn::Min(hn::Min(a, b), c), hn::Set(f, scale));
        const VF high = hn::Mul(hn::Max(hn::Max(a, b), c), hn::Set(f, scale));
        const VF largest = hn::Max(hn::Abs(low), hn::Abs(high));
        const VF margin = hn::Add(hn::Set(f, 0.75f), hn::Mul(hn::Set(f, 4e-6f), largest));
        first = cell(hn::Sub(low, margin), size, cell_bits);
        end = hn::Add(cell(hn::Add(high, margin), size, cell_bits), hn::Set(DI(), 1));
    }

    /// Half a texel less, rounded to an integer by 2^23; a whole place may give the cell below,
    /// which the margin allows for.
    static HWY_INLINE VI cell(VF place, int size, int cell_bits) {
        const F f;
        const VF inside =
            hn::Min(hn::Max(place, hn::Set(f, 0.5f)), hn::Set(f, static_cast<float>(size) - 0.5f));
        const VF rounded = hn::Add(hn::Sub(inside, hn::Set(f, 0.5f)), hn::Set(f, 0x1p23f));
        const VI texel = hn::And(hn::BitCast(DI(), rounded), hn::Set(DI(), 0x7fffff));
        return hn::ShiftRightSame(texel, cell_bits);
    }
};

/// What the corners of some triangles have.
HWY_INLINE VF of_corner(const float* values, const std::uint32_t* vertices, VI at) {
    const auto* const words = reinterpret_cast<const std::int32_t*>(vertices);
    return hn::GatherIndex(F(), values, hn::GatherIndex(DI(), words, at));
}

void find(const AlphaGrid& grid, const TexelPlaces& places, const TriangleList& triangles,
          std::uint8_t* known) {
    const DI d;
    const hn::Rebind<std::uint8_t, DI> bytes;
    const auto lanes = hn::Lanes(d);
    const auto* const count = reinterpret_cast<const std::int32_t*>(grid.count);
    const VI iota = hn::Mul(hn::Iota(d, 0), hn::Set(d, static_cast<int>(triangles.stride)));
    for (std::size_t i = 0; i < triangles.size; i += lanes) {
        const std::size_t left = triangles.size - i;
        // Lanes behind the last triangle look at the first of the vector.
        const VI at = left >= lanes ? iota : hn::IfThenElseZero(hn::FirstN(d, left), iota);
        const std::uint32_t* const v = triangles.vertex + i * triangles.stride;
        const Cells x(of_corner(places.u, v, at), of_corner(places.u, v + 1, at),
                      of_corner(places.u, v + 2, at), grid.scale_u, grid.width, grid.cell_bits);
        const Cells y(of_corner(places.v, v, at), of_corner(places.v, v + 1, at),
                      of_corner(places.v, v + 2, at), grid.scale_v, grid.height, grid.cell_bits);
        const VI row = hn::Set(d, grid.columns + 1);
        const VI below = hn::Mul(y.first, row), above = hn::Mul(y.end, row);
        const auto counted = [&](VI line, VI column) HWY_ATTR {
            return hn::GatherIndex(d, count, hn::Add(line, column));
        };
        const VI sum = hn::Sub(hn::Add(counted(above, x.end), counted(below, x.first)),
                               hn::Add(counted(below, x.end), counted(above, x.first)));
        const VI cells = hn::Mul(hn::Sub(x.end, x.first), hn::Sub(y.end, y.first));
        const auto zero = hn::Eq(hn::And(sum, hn::Set(d, 0xffff)), cells);
        const auto one = hn::Eq(hn::ShiftRight<16>(sum), cells);
        const VI result =
            hn::IfThenElse(zero, hn::Set(d, 1), hn::IfThenElseZero(one, hn::Set(d, 2)));
        hn::StoreU(hn::DemoteTo(bytes, result), bytes, known + i);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(find);

void find_alphas(const AlphaGrid& grid, const TexelPlaces& places, const TriangleList& triangles,
                 std::uint8_t* known) {
    HWY_DYNAMIC_DISPATCH(find)(grid, places, triangles, known);
}

}  // namespace twofold::lanes
#endif
