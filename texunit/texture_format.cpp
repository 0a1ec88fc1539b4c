#include "texunit/texture_format.hpp"

#include <fmt/format.h>

#include "texunit/error.hpp"

namespace twofold {
namespace {

std::size_t blocks_along(int texels) { return (static_cast<std::size_t>(texels) + 3) / 4; }

std::uint32_t cut_to(std::uint8_t value, int bits) {
    return static_cast<std::uint32_t>(value >> (8 - bits));
}

/// The word of one texel. A field that several channels share is filled by the first of them.
std::uint32_t word_of(const TexelLayout& layout, Rgba8 texel) {
    const std::array channels{texel.r, texel.g, texel.b, texel.a};
    std::uint32_t word = 0, filled = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const TexelField f = layout.fields[c];
        const std::uint32_t mask = ((1u << f.bits) - 1) << f.shift;
        if (f.bits == 0 || (filled & mask) != 0) continue;
        word |= cut_to(channels[c], f.bits) << f.shift;
        filled |= mask;
    }
    return word;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t word, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> 8 * i));
}

/// colour0 is black and never above colour1, so that the block has three colours and a transparent
/// code: 1 is colour1, 3 transparent.
void append_one_color_block(std::vector<std::uint8_t>& bytes, Rgba8 texel) {
    constexpr int opaque_from = 125;
    append(bytes, word_of(layout_of(TextureFormat::rgb565), texel) << 16, 4);
    append(bytes, texel.a >= opaque_from ? 0x55555555u : 0xffffffffu, 4);
}

std::vector<std::uint8_t> pack_dxt1(std::span<const Rgba8> texels, int width, int height) {
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4)
            append_one_color_block(
                bytes, texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x)]);
    return bytes;
}

}  // namespace

BaseFormat base_format_of(TextureFormat format) {
    switch (format) {
        case TextureFormat::xrgb8888:
        case TextureFormat::rgb565:
        case TextureFormat::xrgb1555:
            return BaseFormat::rgb;
        case TextureFormat::l8:
            return BaseFormat::luminance;
        case TextureFormat::a8:
            return BaseFormat::alpha;
        case TextureFormat::i8:
            return BaseFormat::intensity;
        case TextureFormat::la88:
            return BaseFormat::luminance_alpha;
        default:
            return BaseFormat::rgba;
    }
}

std::size_t bytes_of(TextureFormat format, int width, int height) {
    if (is_block_compressed(format))
        return blocks_along(width) * blocks_along(height) * dxt::bytes_per_block(format);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(layout_of(format).bytes);
}

void require_complete(const PackedTexels& texels, int width, int height) {
    const std::size_t expected = bytes_of(texels.format, width, height);
    if (texels.bytes.size() != expected)
        throw Error(ExitCode::failure,
                    fmt::format("texture: {} bytes of texels, but {} x {} texels of its format "
                                "take {}",
                                texels.bytes.size(), width, height, expected));
}

std::vector<std::uint8_t> pack(TextureFormat format, std::span<const Rgba8> texels, int width,
                               int height) {
    if (format == TextureFormat::dxt1) return pack_dxt1(texels, width, height);
    if (is_block_compressed(format))
        throw Error(ExitCode::failure, "texture: DXT3 and DXT5 can be read, but not written");
    const TexelLayout layout = layout_of(format);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(bytes_of(format, width, height));
    for (const Rgba8 texel : texels) append(bytes, word_of(layout, texel), layout.bytes);
    return bytes;
}

}  // namespace twofold
