#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "texunit/dxt.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/preset.hpp"
#include "texunit/texture.hpp"

/// Stored texel formats: their layout, decoding into a preset's channels, and packing.
namespace twofold {

/// One component within a texel's little-endian word. Without bits it is `constant`, 0 or 1.
struct TexelField {
    int shift = 0;
    int bits = 0;
    int constant = 0;
};

/// A texel of one word: where r, g, b, a are. L and I formats name one field several times.
struct TexelLayout {
    int bytes;
    std::array<TexelField, 4> fields;
};

constexpr bool is_block_compressed(TextureFormat format) {
    return format == TextureFormat::dxt1 || format == TextureFormat::dxt3 ||
           format == TextureFormat::dxt5;
}

/// Of a format that is not block compressed. Components of a base format that a texel lacks read 0
/// for colour and 1 for alpha. @source OpenGL 1.3, tables 3.15 and 3.21
constexpr TexelLayout layout_of(TextureFormat format) {
    constexpr TexelField zero{0, 0, 0}, one{0, 0, 1}, low{0, 8}, high{8, 8};
    switch (format) {
        case TextureFormat::xrgb8888:
            return {4, {{{16, 8}, {8, 8}, {0, 8}, one}}};
        case TextureFormat::rgb565:
            return {2, {{{11, 5}, {5, 6}, {0, 5}, one}}};
        case TextureFormat::argb1555:
            return {2, {{{10, 5}, {5, 5}, {0, 5}, {15, 1}}}};
        case TextureFormat::xrgb1555:
            return {2, {{{10, 5}, {5, 5}, {0, 5}, one}}};
        case TextureFormat::argb4444:
            return {2, {{{8, 4}, {4, 4}, {0, 4}, {12, 4}}}};
        case TextureFormat::l8:
            return {1, {{low, low, low, one}}};
        case TextureFormat::a8:
            return {1, {{zero, zero, zero, low}}};
        case TextureFormat::i8:
            return {1, {{low, low, low, low}}};
        case TextureFormat::la88:
            return {2, {{low, low, low, high}}};
        default:
            break;
    }
    return {4, {{{16, 8}, {8, 8}, {0, 8}, {24, 8}}}};
}

BaseFormat base_format_of(TextureFormat format);

/// Bytes of an image; DXTn stores whole blocks of 4 x 4.
std::size_t bytes_of(TextureFormat format, int width, int height);

/// @throws Error if `texels` holds another number of bytes than its format and the size ask for
void require_complete(const PackedTexels& texels, int width, int height);

/// Texels in a stored format: components lose their low bits, L and I come from red. DXT1 blocks
/// get one colour, that of their first texel, and are transparent if its alpha is below 125.
/// @param texels  width x height, rows bottom up
/// @throws Error for DXT3 and DXT5
std::vector<std::uint8_t> pack(TextureFormat format, std::span<const Rgba8> texels, int width,
                               int height);

template <NumericModel M>
std::vector<Color<typename M::Channel>> decode_words(const M& m, const PackedTexels& texels,
                                                     std::size_t count) {
    const TexelLayout layout = layout_of(texels.format);
    const auto component = [&](std::uint32_t word, const TexelField& f) {
        if (f.bits == 0) return f.constant == 0 ? typename M::Channel{0} : m.one();
        return m.expand(static_cast<int>(word >> f.shift & ((1u << f.bits) - 1)), f.bits);
    };
    std::vector<Color<typename M::Channel>> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto bytes = static_cast<std::size_t>(layout.bytes);
        const auto word = static_cast<std::uint32_t>(
            dxt::little_endian(std::span(texels.bytes).subspan(i * bytes, bytes)));
        const auto& [r, g, b, a] = layout.fields;
        result.push_back(
            {component(word, r), component(word, g), component(word, b), component(word, a)});
    }
    return result;
}

/// The texels of a stored image in the preset's channels, rows bottom up.
/// @throws Error if `texels` holds another number of bytes than its format and the size ask for
template <NumericModel M>
std::vector<Color<typename M::Channel>> decode(const M& m, const PackedTexels& texels, int width,
                                               int height) {
    require_complete(texels, width, height);
    if (is_block_compressed(texels.format)) return dxt::decode(m, texels, width, height);
    return decode_words(m, texels,
                        static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

}  // namespace twofold
