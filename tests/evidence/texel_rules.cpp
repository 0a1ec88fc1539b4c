#include "tests/evidence/texel_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "texunit/texture_format.hpp"

namespace twofold::evidence {
namespace {

struct Size {
    int width, height;
};

Rgba8 texel_of(const Checkerboard& rule, int x, int y, Size) {
    return ((x / rule.size) ^ (y / rule.size)) & 1 ? rule.second : rule.first;
}

Rgba8 texel_of(const CheckerboardWindow& rule, int x, int y, Size size) {
    const int i = x - rule.x, j = y - rule.y;
    const bool inside = i >= 0 && j >= 0 && i < rule.width && j < rule.height;
    return inside ? texel_of(rule.inside, i, j, size) : rule.outside;
}

Rgba8 texel_of(const ConstantColor& rule, int, int, Size) { return rule.value; }

/// A coordinate scaled to 0..255: the test programs compute in binary32 and cut.
int scaled(int position, int size) {
    return static_cast<int>(
        std::floor(static_cast<float>(position) * 255.0F / static_cast<float>(size)));
}

std::uint8_t value_of(Ramp ramp, int x, int y) {
    switch (ramp) {
        case Ramp::x:
            return static_cast<std::uint8_t>(x);
        case Ramp::y:
            return static_cast<std::uint8_t>(y);
        case Ramp::inverted_y:
            return static_cast<std::uint8_t>(255 - y);
        case Ramp::x_plus_y:
            break;
    }
    return static_cast<std::uint8_t>((x + y) % 256);
}

Rgba8 texel_of(const Gradient& rule, int x, int y, Size size) {
    const int i = scaled(x, size.width), j = scaled(y, size.height);
    const auto channel = [&](std::size_t c) {
        const auto* ramp = std::get_if<Ramp>(&rule.channels[c]);
        return ramp ? value_of(*ramp, i, j) : std::get<std::uint8_t>(rule.channels[c]);
    };
    return {channel(0), channel(1), channel(2), channel(3)};
}

/// The distance in y is counted from half the width as well, as the test programs do.
Rgba8 texel_of(const RadialAlphaPattern&, int x, int y, Size size) {
    const int half_width = std::max(1, size.width / 2), half_height = std::max(1, size.height / 2);
    const int i = scaled(x % half_width, half_width), j = scaled(y % half_height, half_height);
    const float dx = static_cast<float>(x) - 0.5F * static_cast<float>(size.width);
    const float dy = static_cast<float>(y) - 0.5F * static_cast<float>(size.width);
    const float half_w = 0.5F * static_cast<float>(size.width);
    const float half_h = 0.5F * static_cast<float>(size.height);
    const float share = (dx * dx + dy * dy) / (half_w * half_w + half_h * half_h);
    const float alpha = std::floor(255.0F * (1.0F - share));
    return {value_of(Ramp::inverted_y, i, j), value_of(Ramp::x, i, j), value_of(Ramp::y, i, j),
            static_cast<std::uint8_t>(std::clamp(alpha, 0.0F, 255.0F))};
}

Rgba8 texel_of(const ColouredCheckerboard& rule, int x, int y, Size) {
    static constexpr std::array<Rgba8, 8> colors{{{255, 0, 0, 255},
                                                  {255, 0, 0, 0x66},
                                                  {0, 255, 0, 255},
                                                  {0, 255, 0, 0x66},
                                                  {0x44, 0x44, 255, 255},
                                                  {0x44, 0x44, 255, 0x66},
                                                  {255, 255, 255, 255},
                                                  {255, 255, 255, 0x66}}};
    return colors[static_cast<std::size_t>((x / rule.size + y / rule.size) % 8)];
}

bool stores_luminance(TextureFormat format) {
    return format == TextureFormat::l8 || format == TextureFormat::i8 ||
           format == TextureFormat::la88;
}

}  // namespace

ByteImage picture_of(const TexelRule& rule, int width, int height) {
    ByteImage picture{width, height, {}};
    picture.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::visit(
        [&](const auto& r) {
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    picture.pixels.push_back(texel_of(r, x, y, {width, height}));
        },
        rule);
    return picture;
}

ByteImage with_red_and_blue_swapped(ByteImage picture) {
    for (Rgba8& texel : picture.pixels) std::swap(texel.r, texel.b);
    return picture;
}

std::uint8_t luminance(Rgba8 texel) {
    const float sum = 0.299F * static_cast<float>(texel.r) + 0.587F * static_cast<float>(texel.g) +
                      0.114F * static_cast<float>(texel.b);
    return static_cast<std::uint8_t>(std::floor(sum));
}

PackedTexels stored(const ByteImage& picture, TextureFormat format) {
    ByteImage prepared = picture;
    // pack() takes L and I from red.
    if (stores_luminance(format))
        for (Rgba8& texel : prepared.pixels) texel.r = luminance(texel);
    return {format, pack(format, prepared.pixels, picture.width, picture.height)};
}

}  // namespace twofold::evidence
