#pragma once
#include <optional>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/combiner.hpp"
#include "texunit/sample.hpp"
#include "texunit/tex_env.hpp"

/// A pass with everything that is the same for all its fragments, converted once into the preset's
/// formats.
namespace twofold {

/// A texture unit that is on, with what it reads.
template <NumericModel M>
struct BoundUnit {
    std::size_t index;  ///< 0 to max_units - 1
    TextureUnitState state;
    const UploadedTexture<M>* texture;
    Color<typename M::Channel> border;
    TexEnv env;  ///< the environment as COMBINE, for the texture's base format
    Color<typename M::Channel> env_color;
    bool only_modulates;  ///< the environment is MODULATE of all four channels, unscaled
    bool chooses_level;   ///< there are levels, and the filter reads them
    bool derivatives;     ///< the lookup needs the neighbouring pixels' coordinates
    /// What the unit reads if it has no choice between levels or faces; else null.
    const UploadedImage<M>* only_image;
    Addressing addressing;  ///< of it
};

template <NumericModel M>
struct BoundPass {
    const M& m;
    PassState state;
    std::vector<BoundUnit<M>> units;
    std::optional<BoundCombiners<M>> combiners;
    Color<typename M::Channel> fog_color;
    Color<typename M::Pixel> blend_color;
    typename M::Pixel alpha_reference;
    bool plain_write;  ///< a fragment that passes the tests replaces what was there
};

template <NumericModel M>
Color<typename M::Pixel> pixels_of(const M& m, const Vec4& c) {
    return {m.pixel(c.x), m.pixel(c.y), m.pixel(c.z), m.pixel(c.w)};
}

template <NumericModel M>
BoundUnit<M> bind_unit(const M& m, std::size_t index, const TextureUnitState& state,
                       const UploadedTexture<M>& texture) {
    const bool derivatives = needs_derivatives(state, texture.has_mipmaps());
    const bool chooses = derivatives || state.target == TextureTarget::cube_map;
    return {index,
            state,
            &texture,
            kept_by(m, texture.base_format, constant_color(m, state.border_color)),
            as_combine(state.env, texture.base_format),
            constant_color(m, state.env.color),
            state.env.mode == TexEnvMode::modulate && state.env.rgb_scale == 1 &&
                texture.base_format == BaseFormat::rgba,
            chooses_level(state, texture.has_mipmaps()),
            derivatives,
            chooses ? nullptr : &texture.levels[0],
            addressing_of(state)};
}

/// Whether a fragment's colour replaces a pixel's in every bit.
template <NumericModel M>
bool writes_plainly(const M& m, const PassState& state, ColorFormat format) {
    const auto one = m.pixel(1.0);
    return !state.blend && format == ColorFormat::rgba8888 &&
           state.color_mask == PassState{}.color_mask && m.quantise(one, 8) == one;
}

/// @param state    normalized; @param format of the framebuffer
/// @param textures the frame's, uploaded; @param white what a unit without a texture reads (T11)
template <NumericModel M>
BoundPass<M> bind(const M& m, const PassState& state, ColorFormat format,
                  const std::vector<UploadedTexture<M>>& textures,
                  const UploadedTexture<M>& white) {
    BoundPass<M> bound{m, state, {}, std::nullopt, {}, {}, {}, writes_plainly(m, state, format)};
    for (std::size_t u = 0; u < max_units; ++u)
        if (const auto& unit = state.units[u])
            bound.units.push_back(
                bind_unit(m, u, *unit, unit->texture ? textures[*unit->texture] : white));
    if (state.combiners) bound.combiners = bind_combiners(m, *state.combiners);
    if (state.fog) bound.fog_color = constant_color(m, Vec4{state.fog->color, 0.0});
    if (state.blend) bound.blend_color = pixels_of(m, state.blend->color);
    bound.alpha_reference = m.pixel(state.alpha_test ? state.alpha_test->reference : 0.0);
    return bound;
}

}  // namespace twofold
