#include <algorithm>

#include "raster/lane_targets.hpp"
#include "raster/lanes.hpp"
#include "texunit/mipmap.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/level_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/lane_address-inl.hpp"
#include "raster/lane_levels-inl.hpp"
#include "raster/lane_near-inl.hpp"
#include "raster/lane_weights-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

/// Vectors of a preset's coordinates have as many lanes as those of binary64.
HWY_INLINE V in_format(D, V v) { return v; }
template <class R>
HWY_INLINE hn::Vec<R> in_format(R r, V v) {
    return hn::DemoteTo(r, v);
}
HWY_INLINE V in_binary64(V v) { return v; }
template <class Narrow>
HWY_INLINE V in_binary64(Narrow v) {
    return hn::PromoteTo(D(), v);
}

// -------------------------------------------------------------------------------- level of detail

/// Texture coordinates at fragments, and one pixel further in x and in y.
template <class R>
struct Neighbourhood {
    Coordinates<R> here, right, below;
};

template <class R, class Channel>
HWY_INLINE Neighbourhood<R> neighbourhood(R r, const Triangle& t,
                                          const Corners<hn::TFromD<R>, Channel>& c, std::size_t u,
                                          const Pixels& p) {
    const auto at = [&](V x, V y) HWY_ATTR {
        const Weights<D> areas = areas_at(t, Pixels{x, y});
        const Weights<R> held{in_format(r, areas.e0), in_format(r, areas.e1),
                              in_format(r, areas.e2)};
        return coordinates_at(r, c, u, coordinate_weights(r, t, c, held));
    };
    const V one = hn::Set(D(), 1.0);
    return {at(p.x, p.y), at(hn::Add(p.x, one), p.y), at(p.x, hn::Add(p.y, one))};
}

template <class R>
HWY_INLINE V squared_way(const Point<R>& from, const Point<R>& to) {
    const V u = in_binary64(hn::Sub(to.u, from.u)), v = in_binary64(hn::Sub(to.v, from.v));
    return hn::Add(hn::Mul(u, u), hn::Mul(v, v));
}

/// squared_scale() of texunit/mipmap.hpp.
template <class R>
HWY_INLINE V squared_scale(R r, const Addresses<R>& base, const Neighbourhood<R>& at) {
    const Point<R> here = texel_point<true>(r, base, at.here);
    const V x = squared_way(here, texel_point<true>(r, base, at.right));
    const V y = squared_way(here, texel_point<true>(r, base, at.below));
    return hn::IfThenElse(hn::Lt(x, y), y, x);
}

/// Free of branches, so that the loop becomes vectors.
HWY_INLINE V levels_of_detail(V squared_rho, double bias) {
    alignas(64) std::array<double, hn::MaxLanes(D())> values;
    hn::Store(squared_rho, D(), values.data());
    for (double& value : values) value = level_of_detail(value, bias);
    return hn::Load(D(), values.data());
}

// -------------------------------------------------------------------------------------- the choice

/// The image that fragments read (ReadImage) and the share of the next one.
struct Choice {
    V image, share;
};

/// select_levels() of texunit/mipmap.hpp.
HWY_INLINE Choice chosen(const LevelRule& rule, std::size_t levels, V lod) {
    const D d;
    const auto minified = hn::Lt(hn::Set(d, rule.magnified_to), lod);
    const V last = hn::Set(d, static_cast<double>(levels - 1));
    const V held = hn::IfThenElseZero(minified, hn::Min(lod, last));
    const V level =
        rule.nearest ? hn::Neg(hn::Floor(hn::Sub(hn::Set(d, 0.5), held))) : hn::Floor(held);
    const V image = hn::IfThenElseZero(minified, hn::Add(level, hn::Set(d, 1.0)));
    return {image, rule.blends ? hn::Sub(held, level) : hn::Zero(d)};
}

/// Footprints of each fragment in its image.
template <class R, class Texel>
HWY_INLINE Footprint<R> footprint_in(R r, const Unit<Texel>& unit, V images,
                                     const Coordinates<R>& at) {
    const I di;
    Footprint<R> out{hn::Zero(di), hn::Zero(r), hn::Zero(r)};
    const auto each = [&](std::int32_t k, hn::Mask<I> here) HWY_ATTR {
        const auto [image, linear] = read_image(unit, k);
        const Footprint<R> f = footprint(r, Addresses<R>(r, unit, image, linear), at);
        const auto number = hn::Set(r, static_cast<hn::TFromD<R>>(k));
        const auto also = hn::Eq(in_format(r, images), number);
        out = {hn::IfThenElse(here, f.offset, out.offset), hn::IfThenElse(also, f.a, out.a),
               hn::IfThenElse(also, f.b, out.b)};
    };
    for_each_image(di, hn::DemoteTo(di, images), unit.levels.size(), each);
    return out;
}

// ------------------------------------------------------------------------------------- the batches

HWY_INLINE void store(D, const Footprint<D>& f, std::size_t i, ByteFootprints& out) {
    const Footprint8 bytes = in_bytes(f);
    hn::StoreU(bytes.offset, I(), out.offset.data() + i);
    hn::StoreU(bytes.weights, I(), reinterpret_cast<std::int32_t*>(out.weights.data() + i));
}
template <class R>
HWY_INLINE void store(R r, const Footprint<R>& f, std::size_t i,
                      RealFootprints<hn::TFromD<R>>& out) {
    hn::StoreU(f.offset, I(), out.offset.data() + i);
    hn::StoreU(f.a, r, out.a.data() + i);
    hn::StoreU(f.b, r, out.b.data() + i);
}

/// Nv17::cut_weight.
HWY_INLINE void store_share(D, V share, std::uint32_t* out) {
    const auto parts = hn::DemoteTo(I(), hn::Mul(share, hn::Set(D(), 256.0)));
    hn::StoreU(parts, I(), reinterpret_cast<std::int32_t*>(out));
}
template <class R>
HWY_INLINE void store_share(R r, V share, hn::TFromD<R>* out) {
    hn::StoreU(in_format(r, share), r, out);
}

/// The footprints of one unit from fragment i on, of which each chooses its level.
template <class Real, class Channel, class Texel, class Batch>
HWY_NOINLINE void choose_exactly(const Triangle& t, const Corners<Real, Channel>& c,
                                 const Unit<Texel>& unit, std::size_t u, std::size_t i,
                                 Batch& out) {
    const D d;
    using R = hn::Rebind<Real, D>;
    const R r;
    const Neighbourhood<R> at = neighbourhood(r, t, c, u, pixels_at(t, out.places.at.data() + i));
    const V lod = levels_of_detail(squared_scale(r, Addresses<R>(r, unit), at), unit.rule.bias);
    const Choice choice = chosen(unit.rule, unit.levels.size(), lod);
    store(r, footprint_in(r, unit, choice.image, at.here), i, out.fine[u]);
    if (!unit.rule.blends) return;
    store_share(r, choice.share, out.coarse_share[u].data() + i);
    if (hn::AllTrue(d, hn::Eq(choice.share, hn::Zero(d))))
        return hn::StoreU(hn::Zero(I()), I(), out.coarse[u].offset.data() + i);
    const V most = hn::Set(d, static_cast<double>(unit.levels.size()));
    const V next = hn::Min(hn::Add(choice.image, hn::Set(d, 1.0)), most);
    store(r, footprint_in(r, unit, next, at.here), i, out.coarse[u]);
}

/// The same for all fragments.
template <class Real, class Channel, class Texel, class Batch>
void choose(const Triangle& t, const Corners<Real, Channel>& c, const Unit<Texel>& unit,
            std::size_t u, std::size_t count, Batch& out) {
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(D()))
        choose_exactly(t, c, unit, u, i, out);
}

HWY_INLINE void store(const Footprints& f, std::size_t i, ByteFootprints& out) {
    hn::StoreU(f.offset, DI(), out.offset.data() + i);
    hn::StoreU(f.weights, DI(), reinterpret_cast<std::int32_t*>(out.weights.data() + i));
}

/// Chooses by near places, unless doubt is left.
HWY_INLINE bool choose_near(const Triangle& t, const FourPlanes& planes,
                            const Unit<std::uint32_t>& unit, std::size_t u, std::size_t i,
                            ByteBatch& out) {
    const DI di;
    const VI at = hn::LoadU(di, out.places.at.data() + i);
    const Two x = columns_of(t, at), y = rows_of(t, at);
    const NearPoint here = near_point(planes, x, y);
    const NearChoice choice = near_choice(
        unit.rule, unit.levels.size(), near_levels_of_detail(planes, unit.rule.bias, x, y, here));
    const NearFootprints fine = near_footprints(unit, choice.image, here);
    if (HWY_UNLIKELY(!hn::AllFalse(di, hn::Or(choice.doubt, fine.doubt)))) return false;
    store(fine.at, i, out.fine[u]);
    if (!unit.rule.blends) return true;
    hn::StoreU(choice.share, di, reinterpret_cast<std::int32_t*>(out.coarse_share[u].data() + i));
    if (hn::AllTrue(di, hn::Eq(choice.share, hn::Zero(di)))) {
        hn::StoreU(hn::Zero(di), di, out.coarse[u].offset.data() + i);
        return true;
    }
    const VI most = hn::Set(di, static_cast<std::int32_t>(unit.levels.size()));
    const NearFootprints coarse =
        near_footprints(unit, hn::Min(hn::Add(choice.image, hn::Set(di, 1)), most), here);
    store(coarse.at, i, out.coarse[u]);
    return hn::AllFalse(di, coarse.doubt);
}

/// By near places where they are known.
void choose(const Triangle& t, const ByteCorners& c, const Unit<std::uint32_t>& unit, std::size_t u,
            std::size_t count, ByteBatch& out) {
    const Near near(t, reach_of(t), c, unit, u);
    if (!near.usable_beside || !knows_near_levels(unit))
        return choose<double, int, std::uint32_t, ByteBatch>(t, c, unit, u, count, out);
    for (std::size_t i = out.size; i < out.size + count; i += hn::Lanes(DI())) {
        if (HWY_LIKELY(choose_near(t, near.planes, unit, u, i, out))) continue;
        choose_exactly(t, c, unit, u, i, out);
        choose_exactly(t, c, unit, u, i + hn::Lanes(D()), out);
    }
}

/// The base's footprints, which interpolate() finds, give all.
template <class Batch>
void read_base_only(std::size_t u, std::size_t count, Batch& out) {
    const auto clear = [&](auto& column) {
        std::fill_n(column.begin() + static_cast<std::ptrdiff_t>(out.size), count, 0);
    };
    clear(out.coarse_share[u]);
    clear(out.coarse[u].offset);
}

template <class Real, class Channel, class Shader, class Batch>
void choose_for_units(const Triangle& t, const Corners<Real, Channel>& c, const Shader& s,
                      std::size_t count, Batch& out) {
    for (std::size_t u = 0; u < s.units; ++u) {
        if (c.choose_level[u])
            choose(t, c, s.unit[u], u, count, out);
        else if (s.unit[u].rule.blends)
            read_base_only(u, count, out);
    }
}

void choose_u8(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
               std::size_t count, ByteBatch& out) {
    choose_for_units(t, c, s, count, out);
}
void choose_f64(const Triangle& t, const RealCorners<double>& c, const Shader<Color<double>>& s,
                std::size_t count, RealBatch<double>& out) {
    choose_for_units(t, c, s, count, out);
}
void choose_f32(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                std::size_t count, RealBatch<float>& out) {
    choose_for_units(t, c, s, count, out);
}
void choose_rounded(const Triangle& t, const ByteCorners& c, const RoundedShader& s,
                    std::size_t count, RealBatch<double>& out) {
    choose_for_units(t, c, s, count, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace twofold::lanes {

HWY_EXPORT(choose_u8);
HWY_EXPORT(choose_f64);
HWY_EXPORT(choose_f32);
HWY_EXPORT(choose_rounded);

void choose_levels(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                   std::size_t count, ByteBatch& out) {
    HWY_DYNAMIC_DISPATCH(choose_u8)(t, c, s, count, out);
}
void choose_levels(const Triangle& t, const RealCorners<double>& c, const Shader<Color<double>>& s,
                   std::size_t count, RealBatch<double>& out) {
    HWY_DYNAMIC_DISPATCH(choose_f64)(t, c, s, count, out);
}
void choose_levels(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                   std::size_t count, RealBatch<float>& out) {
    HWY_DYNAMIC_DISPATCH(choose_f32)(t, c, s, count, out);
}
void choose_levels(const Triangle& t, const ByteCorners& c, const RoundedShader& s,
                   std::size_t count, RealBatch<double>& out) {
    HWY_DYNAMIC_DISPATCH(choose_rounded)(t, c, s, count, out);
}

}  // namespace twofold::lanes
#endif
