#pragma once
#include <span>

#include "texunit/cube_map.hpp"
#include "texunit/mipmap.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/texel_address.hpp"
#include "texunit/unit_state.hpp"
#include "texunit/uploaded_texture.hpp"

/// The texture lookup of one fragment. Which texels are read is the same for all presets, in the
/// preset's coordinate format; how they are weighed comes from the preset.
namespace twofold {

/// The coordinates at a fragment, and one pixel further in x and in y. The neighbours are read only
/// if needs_derivatives(unit, texture).
template <class Real>
struct SamplePoint {
    ProjectiveCoordinates<Real> here, right, below;
};

/// Whether the lookup has no defined place: division by q = 0, a coordinate that is no number, or a
/// cube map's direction without length. Such coordinates read as 0; callers count them (T02, T05).
template <class Real>
bool undefined_coordinates(const TextureUnitState& unit, const ProjectiveCoordinates<Real>& at) {
    const bool cube = unit.target == TextureTarget::cube_map;
    const ProjectiveCoordinates<Real> flat = cube ? on_face(cube_face(at), at) : at;
    const Real q = cube || unit.divide_by_q ? flat.q : Real{1};
    const Real zero_if_finite = (flat.s - flat.s) + (flat.t - flat.t) + (q - q);
    if (zero_if_finite == Real{0}) return q == Real{0};
    const Real s = flat.s / q, t = flat.t / q;
    return q == Real{0} || !(s == s) || !(t == t);
}

/// A texel whose index along at least one axis is one of the border.
/// @source OpenGL 1.3, 3.8.7: the border colour is for images without border texels
template <NumericModel M>
const Color<typename M::Channel>& fetch_border(const UploadedImage<M>& image, int i, int j,
                                               const Color<typename M::Channel>& border) {
    if (image.bordered.empty()) return border;
    const auto place = [](int k, int size) {
        return static_cast<std::size_t>(k == border_behind ? size + 1 : k + 1);
    };
    const auto row = static_cast<std::size_t>(image.width) + 2;
    return image.bordered[place(j, image.height) * row + place(i, image.width)];
}

template <NumericModel M>
const Color<typename M::Channel>& fetch(const UploadedImage<M>& image, int i, int j,
                                        const Color<typename M::Channel>& border) {
    if (i < 0 || j < 0) return fetch_border(image, i, j, border);
    return image.texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(i)];
}

template <NumericModel M>
Color<typename M::Channel> sample_nearest(const UploadedImage<M>& image, const Addressing& how,
                                          const TexelPoint<typename M::Real>& at,
                                          const Color<typename M::Channel>& border) {
    return fetch(image, nearest_texel(at.u, image.width, how.wrap_s),
                 nearest_texel(at.v, image.height, how.wrap_t), border);
}

template <NumericModel M>
Color<typename M::Channel> sample_linear(const M& m, const UploadedImage<M>& image,
                                         const Addressing& how,
                                         const TexelPoint<typename M::Real>& at,
                                         const Color<typename M::Channel>& border) {
    const auto x = linear_footprint(at.u, image.width, how.wrap_s);
    const auto y = linear_footprint(at.v, image.height, how.wrap_t);
    const auto &t00 = fetch(image, x.i0, y.i0, border), &t10 = fetch(image, x.i1, y.i0, border);
    const auto &t01 = fetch(image, x.i0, y.i1, border), &t11 = fetch(image, x.i1, y.i1, border);
    Color<typename M::Channel> result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = m.filter(t00[c], t10[c], t01[c], t11[c], x.fraction, y.fraction);
    return result;
}

template <NumericModel M>
Color<typename M::Channel> sample_image(const M& m, const UploadedImage<M>& image,
                                        const Addressing& how, Filter filter,
                                        const ProjectiveCoordinates<typename M::Real>& at,
                                        const Color<typename M::Channel>& border) {
    const auto point = texel_point(how, at, image.width, image.height);
    return filter == Filter::linear ? sample_linear(m, image, how, point, border)
                                    : sample_nearest(image, how, point, border);
}

/// The levels for the scale at which the base image is seen. Without need for derivatives both
/// filters are the same and there is one level.
template <NumericModel M>
LevelSelection levels_at(std::span<const UploadedImage<M>> levels, const Addressing& how,
                         const TextureUnitState& unit, const SamplePoint<typename M::Real>& at) {
    if (!needs_derivatives(unit, levels.size() > 1)) return {unit.mag_filter, 0, 0, 0.0};
    const auto point = [&](const ProjectiveCoordinates<typename M::Real>& place) {
        return texel_point(how, place, levels[0].width, levels[0].height);
    };
    const double scale = squared_scale(point(at.here), point(at.right), point(at.below));
    return select_levels(unit, level_of_detail(scale, unit.lod_bias),
                         static_cast<int>(levels.size()) - 1);
}

/// The lookup in a stack of levels; two of them are blended after each was filtered.
template <NumericModel M>
Color<typename M::Channel> sample_levels(const M& m, std::span<const UploadedImage<M>> levels,
                                         const Addressing& how, const TextureUnitState& unit,
                                         const SamplePoint<typename M::Real>& at,
                                         const Color<typename M::Channel>& border) {
    const LevelSelection chosen = levels_at(levels, how, unit, at);
    const auto level = [&](int k) {
        return sample_image(m, levels[static_cast<std::size_t>(k)], how, chosen.filter, at.here,
                            border);
    };
    Color<typename M::Channel> result = level(chosen.fine);
    if (chosen.coarse == chosen.fine) return result;
    const Color<typename M::Channel> coarse = level(chosen.coarse);
    const auto fraction = static_cast<typename M::Real>(chosen.fraction);
    for (std::size_t c = 0; c < 4; ++c) result[c] = m.filter_levels(result[c], coarse[c], fraction);
    return result;
}

/// The filtered texel of one fragment.
/// @param border  the unit's border colour, as kept_by() the texture's base format
template <NumericModel M>
Color<typename M::Channel> sample(const M& m, const UploadedTexture<M>& texture,
                                  const TextureUnitState& unit,
                                  const SamplePoint<typename M::Real>& at,
                                  const Color<typename M::Channel>& border) {
    using Levels = std::span<const UploadedImage<M>>;
    if (unit.target == TextureTarget::cube_map) {
        const CubeFace face = cube_face(at.here);
        const SamplePoint<typename M::Real> on{on_face(face, at.here), on_face(face, at.right),
                                               on_face(face, at.below)};
        return sample_levels(m, Levels(texture.face(face)), cube_addressing(unit), unit, on,
                             border);
    }
    const bool one_level = unit.target == TextureTarget::rectangle;
    const Levels levels(texture.levels.data(), one_level ? 1 : texture.levels.size());
    return sample_levels(m, levels, addressing_of(unit), unit, at, border);
}

}  // namespace twofold
