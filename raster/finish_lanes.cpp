#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/finish_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_math-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

using U32 = hn::RebindToUnsigned<DI>;

/// The places of the fragments from i on; behind the last, pixels that no tile shows.
HWY_INLINE VI places_from(const BatchPlaces& places, std::size_t i, std::size_t size) {
    const DI d;
    const VI at = hn::LoadU(d, places.at.data() + i);
    if (HWY_LIKELY(i + hn::Lanes(d) <= size)) return at;
    return hn::IfThenElse(hn::FirstN(d, size - i), at,
                          hn::Iota(d, static_cast<std::int32_t>(tile_pixels)));
}

/// The lanes of the mask whose depth passes; it is written as the rule says.
HWY_INLINE hn::Mask<DI> depth_tested(const DepthRule& rule, const double* z, VI at, hn::Mask<DI> m,
                                     std::uint32_t* depth) {
    const DI d;
    auto* const stored = reinterpret_cast<std::int32_t*>(depth);
    const auto whole = [](const double* p)
                           HWY_ATTR { return hn::DemoteTo(I(), hn::LoadU(D(), p)); };
    const VI incoming = hn::Combine(d, whole(z + hn::Lanes(D())), whole(z));
    const VI old = hn::GatherIndex(d, stored, at);
    m = hn::And(m, passes(d, rule.func, incoming, old));
    if (rule.write) hn::ScatterIndex(hn::IfThenElse(m, incoming, old), d, stored, at);
    return m;
}

std::size_t keep(const LateTests& tests, std::uint32_t* depth, std::size_t size,
                 BatchPlaces& places, std::uint32_t* words) {
    const DI d;
    auto* const colors = reinterpret_cast<std::int32_t*>(words);
    std::size_t n = 0;
    for (std::size_t i = 0; i < size; i += hn::Lanes(d)) {
        const VI at = places_from(places, i, size);
        const VI color = hn::LoadU(d, colors + i);
        const VI alpha = hn::BitCast(d, hn::ShiftRight<24>(hn::BitCast(U32(), color)));
        auto m = hn::And(hn::FirstN(d, size - i),
                         passes(d, tests.alpha, alpha, hn::Set(d, tests.alpha_reference)));
        if (tests.depth.computed) m = depth_tested(tests.depth, places.z.data() + i, at, m, depth);
        append(d, at, m, places.at.data() + n);
        append(d, color, m, colors + n);
        n += hn::CountTrue(d, m);
    }
    return n;
}

/// Rows of a triangle lie side by side in the picture: whole vectors of them are stored at once.
/// Of fragments with one place the last is stored last.
void write_words(const BatchPlaces& places, const std::uint32_t* words, std::size_t size,
                 std::uint32_t* tile, std::size_t stride) {
    const U32 u;
    const DI d;
    const auto iota = hn::Iota(d, 0);
    const std::size_t whole = size / hn::Lanes(d) * hn::Lanes(d);
    for (std::size_t i = 0; i < whole; i += hn::Lanes(d)) {
        const auto at = hn::LoadU(d, places.at.data() + i);
        const auto color = hn::LoadU(u, words + i);
        const auto row = hn::Mul(hn::ShiftRight<tile_edge_bits>(at),
                                 hn::Set(d, static_cast<std::int32_t>(stride)));
        const auto to = hn::Add(row, hn::And(at, hn::Set(d, tile_edge - 1)));
        const std::int32_t first = hn::GetLane(to);
        if (hn::AllTrue(d, hn::Eq(to, hn::Add(hn::Set(d, first), iota))))
            hn::StoreU(color, u, tile + first);
        else
            hn::ScatterIndex(color, u, tile, to);
    }
    for (std::size_t i = whole; i < size; ++i) {
        const auto at = static_cast<std::size_t>(places.at[i]);
        tile[(at >> tile_edge_bits) * stride + at % tile_edge] = words[i];
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(keep);
HWY_EXPORT(write_words);

std::size_t keep_survivors(const LateTests& tests, std::uint32_t* depth, std::size_t size,
                           BatchPlaces& places, std::uint32_t* words) {
    return HWY_DYNAMIC_DISPATCH(keep)(tests, depth, size, places, words);
}
void write_colors(const BatchPlaces& places, const std::uint32_t* words, std::size_t size,
                  std::uint32_t* tile, std::size_t stride) {
    HWY_DYNAMIC_DISPATCH(write_words)(places, words, size, tile, stride);
}

}  // namespace twofold::lanes
#endif
