#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace twofold {

/// One texel or pixel of 8 bits a channel, 255 = 1.0; never premultiplied.
struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 0;
    bool operator==(const Rgba8&) const = default;
};

/// One texel of binary32 channels r, g, b, a; never premultiplied.
using Rgba32f = std::array<float, 4>;

/// A two-dimensional texture image. Rows are bottom up, as OpenGL's TexImage2D takes them: texel
/// (0, 0) is at s = t = 0 and texel (i, j) is stored at j * width + i.
struct Texture {
    int width = 0;
    int height = 0;
    std::variant<std::vector<Rgba8>, std::vector<Rgba32f>> texels;
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
