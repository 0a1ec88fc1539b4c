#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "texunit/tex_env_state.hpp"

namespace twofold {

/// One texel or pixel of 8 bits a channel, 255 = 1.0; never premultiplied.
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 0;
    bool operator==(const Rgba8&) const = default;
};

/// One texel of binary32 channels r, g, b, a; never premultiplied.
using Rgba32f = std::array<float, 4>;

/// Stored texel formats beside plain RGBA of 8 bits. Components are named from the high bits down,
/// words are little-endian.
/// @source formats of NV1x and NV2x: envytools rnndb; DXTn: EXT_texture_compression_s3tc
enum class TextureFormat {
    argb8888,
    xrgb8888,  ///< alpha reads 1
    rgb565,
    argb1555,
    xrgb1555,  ///< alpha reads 1
    argb4444,
    l8,
    a8,
    i8,
    la88,  ///< alpha in the high byte
    dxt1,
    dxt3,
    dxt5
};

/// Texels as the format stores them; rows bottom up, DXTn blocks of 4 x 4 row by row from the
/// bottom.
struct PackedTexels {
    TextureFormat format = TextureFormat::argb8888;
    std::vector<std::uint8_t> bytes;
};

using Texels = std::variant<std::vector<Rgba8>, std::vector<Rgba32f>, PackedTexels>;

/// One texture image. Rows are bottom up, as OpenGL's TexImage2D takes them: texel (0, 0) is at s =
/// t = 0 and texel (i, j) is stored at j * width + i. Sizes count border texels, as TexImage2D's
/// do; with them texel (-1, -1) is stored first.
struct TextureImage {
    int width = 0;
    int height = 0;
    Texels texels;
};

/// A further face of a cube map with its own levels.
struct TextureFace {
    int width = 0;
    int height = 0;
    Texels texels;
    std::vector<TextureImage> mipmaps{};
};

/// A texture: its base image, and what else belongs to it.
struct Texture {
    int width = 0;
    int height = 0;
    Texels texels;
    BaseFormat base_format = BaseFormat::rgba;
    std::vector<TextureImage> mipmaps{};    ///< levels 1, 2, ...; empty: the base image alone
    std::vector<TextureFace> cube_faces{};  ///< of a cube map: -x, +y, -y, +z, -z; the base is +x
    int border = 0;  ///< texels around every image: 0 or 1. @source OpenGL 1.3, 3.8.1
};

/// A picture of any number of float channels. Rows are top down; sample (x, y, c) is stored at
/// (y * width + x) * channels + c.
struct FloatImage {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> samples;
};

/// A picture of 8-bit RGBA. Rows are top down; pixel (x, y) is stored at y * width + x.
struct ByteImage {
    int width = 0;
    int height = 0;
    std::vector<Rgba8> pixels;
};

}  // namespace twofold
