#pragma once
#include <cstddef>
#include <variant>
#include <vector>

#include "texunit/cube_map.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/texture.hpp"
#include "texunit/texture_format.hpp"

/// A texture as a preset stores it.
namespace twofold {

/// One image in the preset's channels. Rows bottom up; width and height are those inside its
/// border.
template <NumericModel M>
struct UploadedImage {
    int width = 1;
    int height = 1;
    std::vector<Color<typename M::Channel>> texels;  ///< without border texels
    std::vector<Color<typename M::Channel>>
        bordered;  ///< (width + 2) x (height + 2), from texel (-1, -1); empty: no border texels
};

/// The base image and its mipmaps.
template <NumericModel M>
using UploadedLevels = std::vector<UploadedImage<M>>;

/// A texture converted once into the preset's channels (OpenGL 1.3, 3.8.1).
template <NumericModel M>
struct UploadedTexture {
    UploadedLevels<M> levels;
    std::vector<UploadedLevels<M>> other_faces;  ///< of a cube map: all but +x, which is `levels`
    BaseFormat base_format = BaseFormat::rgba;

    bool has_mipmaps() const { return levels.size() > 1; }

    /// A cube map's face; a texture that is no cube map shows its own levels on every face.
    const UploadedLevels<M>& face(CubeFace which) const {
        const auto k = static_cast<std::size_t>(which);
        return k == 0 || k > other_faces.size() ? levels : other_faces[k - 1];
    }
};

/// What a texture of this base format keeps of a colour, in the places where the environment looks
/// for it: A alone, L in all of r, g and b, I in all four. Also for border colours.
/// @source OpenGL 1.3, table 3.15
template <NumericModel M>
Color<typename M::Channel> kept_by(const M& m, BaseFormat format,
                                   const Color<typename M::Channel>& c) {
    constexpr typename M::Channel zero{0};
    const auto one = m.one();
    switch (format) {
        case BaseFormat::alpha:
            return {zero, zero, zero, c[3]};
        case BaseFormat::luminance:
            return {c[0], c[0], c[0], one};
        case BaseFormat::luminance_alpha:
            return {c[0], c[0], c[0], c[3]};
        case BaseFormat::intensity:
            return {c[0], c[0], c[0], c[0]};
        case BaseFormat::rgb:
            return {c[0], c[1], c[2], one};
        case BaseFormat::rgba:
            break;
    }
    return c;
}

template <NumericModel M, class Texel>
std::vector<Color<typename M::Channel>> decode(const M& m, const std::vector<Texel>& texels, int,
                                               int) {
    std::vector<Color<typename M::Channel>> result;
    result.reserve(texels.size());
    for (const Texel& t : texels) result.push_back(m.texel(t));
    return result;
}

/// The texels inside the border of an image of width x height.
template <class Texel>
std::vector<Texel> without_border(const std::vector<Texel>& texels, int width, int height) {
    std::vector<Texel> inside;
    for (int j = 1; j + 1 < height; ++j) {
        const auto row = texels.begin() + std::ptrdiff_t{j} * width;
        inside.insert(inside.end(), row + 1, row + width - 1);
    }
    return inside;
}

/// @param image  a TextureImage, TextureFace or Texture
template <NumericModel M, class Image>
UploadedImage<M> upload_image(const M& m, const Image& image, BaseFormat format, int border) {
    const int width = image.width, height = image.height;
    auto texels =
        std::visit([&](const auto& t) { return decode(m, t, width, height); }, image.texels);
    if (format != BaseFormat::rgba)
        for (auto& t : texels) t = kept_by(m, format, t);
    if (border == 0) return {width, height, std::move(texels), {}};
    return {width - 2, height - 2, without_border(texels, width, height), std::move(texels)};
}

/// @param image  a TextureFace or Texture
template <NumericModel M, class Image>
UploadedLevels<M> upload_levels(const M& m, const Image& image, BaseFormat format, int border) {
    UploadedLevels<M> levels;
    levels.push_back(upload_image(m, image, format, border));
    for (const TextureImage& level : image.mipmaps)
        levels.push_back(upload_image(m, level, format, border));
    return levels;
}

/// @throws Error if the bytes of a packed image are not as many as its size and format ask for
template <NumericModel M>
UploadedTexture<M> upload(const M& m, const Texture& texture) {
    const BaseFormat format = texture.base_format;
    UploadedTexture<M> result{upload_levels(m, texture, format, texture.border), {}, format};
    for (const TextureFace& face : texture.cube_faces)
        result.other_faces.push_back(upload_levels(m, face, format, texture.border));
    return result;
}

/// What a unit without a texture reads (T11): one texel, (1, 1, 1, 1).
template <NumericModel M>
UploadedTexture<M> white_texture(const M& m) {
    return upload(m, {1, 1, std::vector<Rgba8>{{255, 255, 255, 255}}});
}

}  // namespace twofold
