// Fragments whose colours are real numbers, on vectors, compiled once for each instruction set: no
// #pragma once.
#include <algorithm>

#include "raster/lane_weights-inl.hpp"

#if defined(TWOFOLD_LANE_REALS) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_LANE_REALS
#undef TWOFOLD_LANE_REALS
#else
#define TWOFOLD_LANE_REALS
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

template <class Real>
using Wide = hn::ScalableTag<Real>;

/// Colours lie fragment by fragment, so that a vector holds as many fragments' four channels, or as
/// many channels of one fragment.
template <class Real>
inline constexpr std::size_t channels_at_once = HWY_MIN(hn::MaxLanes(Wide<Real>()), 4);
template <class Real>
inline constexpr std::size_t fragments_at_once = HWY_MAX(hn::MaxLanes(Wide<Real>()) / 4, 1);

// ----------------------------------------------------------------------------------- interpolation

template <class Real>
void place_reals(const Triangle& t, const RealCorners<Real>& c, const Shader<Color<Real>>& s,
                 std::size_t count, RealBatch<Real>& out) {
    using R = Wide<Real>;
    const R r;
    const hn::Rebind<std::int32_t, R> ints;
    const std::array<Addresses<R>, lane_units> in{Addresses<R>(r, s.unit[0]),
                                                  Addresses<R>(r, s.unit[1])};
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(r)) {
        const Weights<R> w = coordinate_weights(r, t, c, out.places.at.data() + i);
        for (std::size_t u = 0; u < s.units; ++u) {
            if (c.choose_level[u]) continue;
            const Footprint<R> f = footprint(r, in[u], coordinates_at(r, c, u, w));
            hn::StoreU(f.offset, ints, out.fine[u].offset.data() + i);
            hn::StoreU(f.a, r, out.fine[u].a.data() + i);
            hn::StoreU(f.b, r, out.fine[u].b.data() + i);
        }
    }
}

/// RealModel::iterate_color, the four channels of a fragment side by side.
template <class Real>
void iterate_reals(const Triangle& t, const RealCorners<Real>& c, const std::int32_t* at,
                   std::size_t size, Color<Real>* out) {
    const Wide<Real> r;
    const hn::CappedTag<Real, 4> four;
    alignas(64) Real l1[hn::MaxLanes(r)], l2[hn::MaxLanes(r)], sum[hn::MaxLanes(r)];
    for (std::size_t i = 0; i < size; i += hn::Lanes(r)) {
        const auto l = over_w(r, t, weights_at(r, t, at + i));
        hn::StoreU(l.e1, r, l1);
        hn::StoreU(l.e2, r, l2);
        hn::StoreU(hn::Add(hn::Add(l.e0, l.e1), l.e2), r, sum);
        const std::size_t count = HWY_MIN(hn::Lanes(r), size - i);
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t ch = 0; ch < 4; ch += hn::Lanes(four)) {
                const auto c0 = hn::LoadU(four, c.colors[0]->data() + ch);
                const auto d1 = hn::Sub(hn::LoadU(four, c.colors[1]->data() + ch), c0);
                const auto d2 = hn::Sub(hn::LoadU(four, c.colors[2]->data() + ch), c0);
                const auto more =
                    hn::Add(hn::Mul(hn::Set(four, l1[k]), d1), hn::Mul(hn::Set(four, l2[k]), d2));
                hn::StoreU(hn::Add(c0, hn::Div(more, hn::Set(four, sum[k]))), four,
                           out[i + k].data() + ch);
            }
    }
}

// ----------------------------------------------------------------------------------------- shading

/// Texels of as many fragments as a vector holds, from `channel` on.
template <class R>
HWY_INLINE hn::Vec<R> texels_at(R r, const Color<hn::TFromD<R>>* texels, const std::int32_t* at,
                                std::size_t channel) {
    constexpr std::size_t lanes = hn::MaxLanes(R());
    if constexpr (lanes <= 4) {
        return hn::LoadU(r, texels[*at].data() + channel);
    } else {
        const hn::CappedTag<hn::TFromD<R>, lanes / 2> half;
        return hn::Combine(r, texels_at(half, texels, at + lanes / 8, channel),
                           texels_at(half, texels, at, channel));
    }
}

/// A number of each fragment for all of its channels.
template <class R>
HWY_INLINE hn::Vec<R> for_channels(R r, const hn::TFromD<R>* p) {
    using Index = hn::TFromD<hn::RebindToSigned<R>>;
    if constexpr (hn::MaxLanes(R()) <= 4) {
        return hn::Set(r, *p);
    } else {
        constexpr std::array<Index, 16> fragment{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
        return TableLookupLanes(hn::LoadU(r, p), SetTableIndices(r, fragment.data()));
    }
}

/// The four texels that LINEAR blends.
template <class R>
struct Quad {
    hn::Vec<R> t00, t10, t01, t11;
};

template <class R>
HWY_INLINE Quad<R> quad_at(R r, const Image<Color<hn::TFromD<R>>>& image, const std::int32_t* at,
                           std::size_t channel) {
    const auto texel = [&](int more)
                           HWY_ATTR { return texels_at(r, image.texels + more, at, channel); };
    return {texel(0), texel(1), texel(image.stride), texel(image.stride + 1)};
}

/// Factors and limits of MODULATE's scales. A channel that is not scaled is not limited either.
template <class Real>
struct Scales {
    static constexpr std::size_t room = HWY_MAX(hn::MaxLanes(Wide<Real>()), 4);
    std::array<Real, room> factor, least, most;
    bool needed;

    Scales(const Unit<Color<Real>>& unit, Real one)
        : needed(unit.rgb_scale != 1 || unit.alpha_scale != 1) {
        constexpr Real all = hwy::HighestValue<Real>();
        for (std::size_t k = 0; k < room; ++k) {
            const int scale = k % 4 < 3 ? unit.rgb_scale : unit.alpha_scale;
            factor[k] = static_cast<Real>(scale);
            least[k] = scale == 1 ? -all : Real{0};
            most[k] = scale == 1 ? all : one;
        }
    }

    template <class R>
    HWY_INLINE hn::Vec<R> scaled(R r, hn::Vec<R> c, std::size_t channel) const {
        const auto raised = hn::Mul(c, hn::LoadU(r, factor.data() + channel));
        return hn::Min(hn::Max(raised, hn::LoadU(r, least.data() + channel)),
                       hn::LoadU(r, most.data() + channel));
    }
};

/// The texels at the footprints of the fragments from i on.
template <class R, class Arithmetic>
HWY_INLINE hn::Vec<R> filtered(R r, const Arithmetic& m, const Unit<Color<hn::TFromD<R>>>& unit,
                               const RealFootprints<hn::TFromD<R>>& footprints, std::size_t i,
                               std::size_t channel) {
    const std::int32_t* const at = footprints.offset.data() + i;
    if (!reads_four(unit)) return texels_at(r, unit.image.texels, at, channel);
    return m.filter(r, quad_at(r, unit.image, at, channel),
                    for_channels(r, footprints.a.data() + i),
                    for_channels(r, footprints.b.data() + i));
}

/// What unit u looks up for the fragments from i on.
template <class R, class Arithmetic, class Batch>
HWY_INLINE hn::Vec<R> texels_of(R r, const Arithmetic& m, const Unit<Color<hn::TFromD<R>>>& unit,
                                const Batch& batch, std::size_t u, std::size_t i,
                                std::size_t channel) {
    const auto fine = filtered(r, m, unit, batch.fine[u], i, channel);
    if (!unit.rule.blends) return fine;
    const auto share = for_channels(r, batch.coarse_share[u].data() + i);
    if (hn::AllTrue(r, hn::Eq(share, hn::Zero(r)))) return fine;
    return m.filter_levels(r, fine, filtered(r, m, unit, batch.coarse[u], i, channel), share);
}

/// What unit u makes of the colours of the fragments from i on.
template <class R, class Arithmetic, class Batch>
HWY_INLINE hn::Vec<R> combined(R r, const Arithmetic& m, const Unit<Color<hn::TFromD<R>>>& unit,
                               const Scales<hn::TFromD<R>>& scales, const Batch& batch,
                               std::size_t u, std::size_t i, std::size_t channel,
                               hn::Vec<R> previous) {
    const auto texel = texels_of(r, m, unit, batch, u, i, channel);
    if (unit.replace) return texel;
    const auto c = m.modulate(r, texel, previous);
    return scales.needed ? scales.scaled(r, c, channel) : c;
}

/// Limited to [0, most].
template <class R>
HWY_INLINE hn::Vec<R> clamped(R r, hn::Vec<R> c, hn::TFromD<R> most) {
    return hn::IfThenElseZero(hn::Gt(c, hn::Zero(r)), hn::Min(c, hn::Set(r, most)));
}

/// Looks textures up and combines them with the colours.
/// @param m  a model's filter(), filter_levels(), modulate(), finish() and one() on vectors
template <class Real, class Arithmetic>
void shade_fragments(const Shader<Color<Real>>& shader, const Arithmetic m,
                     RealBatch<Real>& batch) {
    const Wide<Real> r;
    const Shader<Color<Real>> s = shader;
    const std::array<Scales<Real>, lane_units> scales{Scales<Real>(s.unit[0], m.one()),
                                                      Scales<Real>(s.unit[1], m.one())};
    end_with_addresses(s, batch);
    for (std::size_t i = 0; i < batch.size; i += fragments_at_once<Real>)
        for (std::size_t ch = 0; ch < 4; ch += channels_at_once<Real>) {
            Real* const color = batch.color[i].data() + ch;
            auto c = hn::LoadU(r, color);
            for (std::size_t u = 0; u < s.units; ++u)
                c = combined(r, m, s.unit[u], scales[u], batch, u, i, ch, c);
            hn::StoreU(m.finish(r, c), r, color);
        }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
