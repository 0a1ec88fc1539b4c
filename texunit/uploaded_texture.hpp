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

/// One image in the preset's channels. Rows bottom up.
template <NumericModel M>
struct UploadedImage {
    int width = 1;
    int height = 1;
    std::vector<Color<typename M::Channel>> texels;
};

/// A texture converted once into the preset's channels (OpenGL 1.3, 3.8.1).
template <NumericModel M>
struct UploadedTexture {
    std::vector<UploadedImage<M>> levels;       ///< the base image and its mipmaps
    std::vector<UploadedImage<M>> other_faces;  ///< of a cube map: all but +x, which is the base
    BaseFormat base_format = BaseFormat::rgba;

    bool has_mipmaps() const { return levels.size() > 1; }

    /// The image of a cube map's face; a texture that is no cube map shows its base on every face.
    const UploadedImage<M>& face(CubeFace which) const {
        const auto k = static_cast<std::size_t>(which);
        return k == 0 || k > other_faces.size() ? levels[0] : other_faces[k - 1];
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

template <NumericModel M>
UploadedImage<M> upload_image(const M& m, int width, int height, const Texels& texels,
                              BaseFormat format) {
    UploadedImage<M> image{width, height, {}};
    image.texels = std::visit([&](const auto& t) { return decode(m, t, width, height); }, texels);
    if (format != BaseFormat::rgba)
        for (auto& t : image.texels) t = kept_by(m, format, t);
    return image;
}

/// @throws Error if the bytes of a packed image are not as many as its size and format ask for
template <NumericModel M>
UploadedTexture<M> upload(const M& m, const Texture& texture) {
    const BaseFormat format = texture.base_format;
    UploadedTexture<M> result;
    result.base_format = format;
    result.levels.push_back(upload_image(m, texture.width, texture.height, texture.texels, format));
    for (const TextureImage& level : texture.mipmaps)
        result.levels.push_back(upload_image(m, level.width, level.height, level.texels, format));
    for (const TextureImage& face : texture.cube_faces)
        result.other_faces.push_back(upload_image(m, face.width, face.height, face.texels, format));
    return result;
}

/// What a unit without a texture reads (T11): one texel, (1, 1, 1, 1).
template <NumericModel M>
UploadedTexture<M> white_texture(const M& m) {
    return upload(m, {1, 1, std::vector<Rgba8>{{255, 255, 255, 255}}});
}

}  // namespace twofold
