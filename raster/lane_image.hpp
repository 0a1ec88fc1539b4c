#pragma once
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "raster/bind.hpp"
#include "raster/lane_rounding.hpp"

/// Textures as the vector loops read them.
namespace twofold {

/// How a model's fragments are computed on vectors: in bytes, in real numbers, or in integers that
/// binary64 holds.
enum class LaneKind { bytes, reals, rounded };

template <NumericModel M>
constexpr LaneKind lane_kind() {
    switch (M::preset) {
        case Preset::nv17:
        case Preset::nv2x:
            return LaneKind::bytes;
        case Preset::gl13:
        case Preset::float32:
        case Preset::ideal64:
            return LaneKind::reals;
        case Preset::coarse8:
        case Preset::custom:
            break;
    }
    return LaneKind::rounded;
}

/// A texel with its four channels side by side: a word of bytes, red lowest, or four numbers.
template <NumericModel M>
using LaneTexel =
    std::conditional_t<lane_kind<M>() == LaneKind::bytes, std::uint32_t, Color<typename M::Real>>;

template <NumericModel M>
using LaneShader = std::conditional_t<lane_kind<M>() == LaneKind::rounded, lanes::RoundedShader,
                                      lanes::Shader<LaneTexel<M>>>;

/// @param has_alpha  of its texture; without, MODULATE leaves alpha alone
template <NumericModel M>
LaneTexel<M> lane_texel(const M& m, const Color<typename M::Channel>& c, bool has_alpha) {
    if constexpr (lane_kind<M>() == LaneKind::bytes) {
        return packed_bytes(c);
    } else if constexpr (lane_kind<M>() == LaneKind::reals) {
        return c;
    } else {
        const double alpha = has_alpha ? c[3] : rounding_of(m).product.identity;
        return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]),
                alpha};
    }
}

/// The texel index at a place of -1 to size + 1 along one axis, or a border's.
inline int surrounding_index(int place, int size, Wrap wrap) {
    return wrap == Wrap::repeat ? (place + size) % size : wrap_index(place, size, wrap);
}

/// A unit's images with their surroundings as its wrap modes and border see them.
template <NumericModel M>
struct LaneImages {
    std::vector<LaneTexel<M>> texels;  ///< of all levels, each with the stride of the widest
    std::vector<lanes::Image<LaneTexel<M>>> levels;
};

/// Writes an image with its surroundings.
template <NumericModel M>
void surround(const M& m, const BoundUnit<M>& unit, const UploadedImage<M>& image, int stride,
              LaneTexel<M>* out) {
    const bool alpha = has_alpha(unit.texture->base_format);
    for (int j = -1; j <= image.height + 1; ++j, out += stride)
        for (int i = -1; i <= image.width + 1; ++i)
            out[i + 1] = lane_texel(
                m,
                fetch<M>(image, surrounding_index(i, image.width, unit.state.wrap_s),
                         surrounding_index(j, image.height, unit.state.wrap_t), unit.border),
                alpha);
}

/// The levels that a unit reads: all where it chooses among them, else the base.
template <NumericModel M>
std::span<const UploadedImage<M>> levels_read(const BoundUnit<M>& unit) {
    const auto& levels = unit.texture->levels;
    return {levels.data(), unit.chooses_level ? levels.size() : 1};
}

template <NumericModel M>
LaneImages<M> lane_images(const M& m, const BoundUnit<M>& unit) {
    const auto levels = levels_read(unit);
    int stride = 0, rows = 0;
    for (const UploadedImage<M>& level : levels) {
        stride = std::max(stride, level.width + 3);
        rows += level.height + 3;
    }
    LaneImages<M> images;
    images.texels.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows));
    LaneTexel<M>* first = images.texels.data();
    for (const UploadedImage<M>& level : levels) {
        surround(m, unit, level, stride, first);
        images.levels.push_back({first, level.width, level.height, stride});
        first += stride * (level.height + 3);
    }
    return images;
}

inline constexpr double largest_texel = 1152921504606846976.0;  // 2^60

/// Vectors know finite texels only: min and max of a NaN are not the same everywhere.
template <NumericModel M>
bool moderate(const BoundUnit<M>& unit) {
    if constexpr (lane_kind<M>() == LaneKind::reals)
        for (const UploadedImage<M>& image : levels_read(unit))
            for (const auto& texel : image.texels)
                for (const auto c : texel)
                    if (!(std::fabs(static_cast<double>(c)) <= largest_texel)) return false;
    return true;
}

/// What of a unit vectors do not know; empty if they know it: a two-dimensional image with all its
/// levels, MODULATE, or REPLACE of all channels.
template <NumericModel M>
std::string why_not_on_lanes(const BoundUnit<M>& unit) {
    const TextureUnitState& s = unit.state;
    const BaseFormat format = unit.texture->base_format;
    const bool mirrored = s.wrap_s == Wrap::mirrored_repeat || s.wrap_t == Wrap::mirrored_repeat;
    const bool modulates = s.env.mode == TexEnvMode::modulate && format != BaseFormat::alpha;
    const bool replaces = s.env.mode == TexEnvMode::replace && format == BaseFormat::rgba &&
                          unit.env.rgb_scale == 1 && unit.env.alpha_scale == 1;
    if (s.target == TextureTarget::cube_map) return "a cube map";
    if (mirrored && (s.mag_filter == Filter::nearest || s.min_filter == Filter::nearest))
        return "mirrored_repeat with filter nearest";
    if (!modulates && !replaces)
        return "an environment other than modulate, or replace of all four channels";
    if (!moderate(unit)) return "a texel that is not finite or above 2^60";
    return {};
}

/// What of a pass keeps vectors from shading its fragments; empty if nothing does.
template <NumericModel M>
std::string why_not_on_lanes(const BoundPass<M>& pass) {
    if constexpr (lane_kind<M>() == LaneKind::rounded)
        if (!filter_is_exact(rounding_of(pass.m)))
            return "filter_rounding once with weights and registers wider than binary64";
    if (pass.combiners) return "register combiners";
    if (pass.state.color_sum) return "colour sum";
    if (pass.state.fog) return "fog";
    if (pass.units.size() > lanes::lane_units)
        return "more than " + std::to_string(lanes::lane_units) + " texture units";
    for (const BoundUnit<M>& unit : pass.units)
        if (const std::string why = why_not_on_lanes<M>(unit); !why.empty())
            return "texture unit " + std::to_string(unit.index) + ": " + why;
    return {};
}

/// Whether vectors can shade the fragments of a pass.
template <NumericModel M>
bool lanes_know(const BoundPass<M>& pass) {
    return why_not_on_lanes(pass).empty();
}

/// Coarse8 does not blend levels.
template <NumericModel M>
lanes::LevelRule level_rule(const BoundUnit<M>& unit) {
    const TextureUnitState& s = unit.state;
    const bool blends = unit.chooses_level && s.mip_filter == MipFilter::linear;
    return {s.lod_bias, magnified_to(s, unit.chooses_level), s.min_filter == Filter::linear,
            s.mip_filter == MipFilter::nearest, blends && M::preset != Preset::coarse8};
}

/// @param images  lane_images(); what is returned points into them
template <NumericModel M>
lanes::Unit<LaneTexel<M>> lane_unit(const BoundUnit<M>& unit, const LaneImages<M>& images) {
    const lanes::Image<LaneTexel<M>>& image = images.levels[0];
    const TextureUnitState& s = unit.state;
    const double to_centre = s.mag_filter == Filter::linear ? 128.0 : 0.0;
    lanes::Unit<LaneTexel<M>> out{image,
                                  s.wrap_s,
                                  s.wrap_t,
                                  s.mag_filter == Filter::linear,
                                  s.divide_by_q,
                                  s.target == TextureTarget::rectangle,
                                  s.env.mode == TexEnvMode::replace,
                                  unit.env.rgb_scale,
                                  unit.env.alpha_scale,
                                  {256.0 * image.width, 256.0 * image.height, 0.0, 1.0},
                                  {to_centre, to_centre, 0.0, 0.0},
                                  {},
                                  {}};
    if (!unit.derivatives) return out;
    out.levels = images.levels;
    out.rule = level_rule(unit);
    return out;
}

}  // namespace twofold
