#include "tests/evidence/surface_memory.hpp"

#include "texunit/texture_format.hpp"

namespace twofold::evidence {
namespace {

/// The texture format with the same bits in the same places.
TextureFormat layout_of_surface(ColorFormat format) {
    switch (format) {
        case ColorFormat::rgb565:
            return TextureFormat::rgb565;
        case ColorFormat::xrgb1555_z:
        case ColorFormat::xrgb1555_o:
            return TextureFormat::argb1555;
        case ColorFormat::rgba8888:
        case ColorFormat::xrgb8888_z:
        case ColorFormat::xrgb8888_o:
            break;
    }
    return TextureFormat::argb8888;
}

std::uint32_t word_at(const std::vector<std::uint8_t>& bytes, std::size_t first, int count) {
    std::uint32_t word = 0;
    for (int k = 0; k < count; ++k)
        word |= std::uint32_t{bytes[first + static_cast<std::size_t>(k)]} << 8 * k;
    return word;
}

void put_word(std::vector<std::uint8_t>& bytes, std::size_t first, int count, std::uint32_t word) {
    for (int k = 0; k < count; ++k)
        bytes[first + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(word >> 8 * k);
}

/// A component of `bits` bits as the highest bits of a byte; all ones for a missing one.
std::uint8_t high_bits(std::uint32_t word, const TexelField& field) {
    if (field.bits == 0) return 255;
    const std::uint32_t value = word >> field.shift & ((1U << field.bits) - 1);
    // A single bit stands for all or nothing.
    return static_cast<std::uint8_t>(field.bits == 1 ? value * 255 : value << (8 - field.bits));
}

std::uint32_t swapped(std::uint32_t word, const TexelField& red, const TexelField& blue) {
    const std::uint32_t mask = (1U << red.bits) - 1;
    const std::uint32_t r = word >> red.shift & mask, b = word >> blue.shift & mask;
    const std::uint32_t rest = word & ~(mask << red.shift) & ~(mask << blue.shift);
    return rest | r << blue.shift | b << red.shift;
}

}  // namespace

int bytes_per_pixel(ColorFormat format) { return layout_of(layout_of_surface(format)).bytes; }

std::vector<std::uint8_t> memory_of(const ByteImage& pixels, ColorFormat format) {
    return pack(layout_of_surface(format), pixels.pixels, pixels.width, pixels.height);
}

ByteImage as_stored(const ByteImage& pixels, ColorFormat format) {
    const TexelLayout layout = layout_of(layout_of_surface(format));
    const std::vector<std::uint8_t> memory = memory_of(pixels, format);
    ByteImage result{pixels.width, pixels.height, {}};
    result.pixels.reserve(pixels.pixels.size());
    const auto bytes = static_cast<std::size_t>(layout.bytes);
    for (std::size_t i = 0; i < pixels.pixels.size(); ++i) {
        const std::uint32_t word = word_at(memory, i * bytes, layout.bytes);
        const auto& [r, g, b, a] = layout.fields;
        result.pixels.push_back(
            {high_bits(word, r), high_bits(word, g), high_bits(word, b), high_bits(word, a)});
    }
    return result;
}

PackedTexels reread(std::vector<std::uint8_t> memory, TextureFormat format, int width, int height) {
    memory.resize(bytes_of(format, width, height), std::uint8_t{0});
    return {format, std::move(memory)};
}

PackedTexels with_red_and_blue_swapped(PackedTexels texels) {
    const TexelLayout layout = layout_of(texels.format);
    const auto bytes = static_cast<std::size_t>(layout.bytes);
    for (std::size_t i = 0; i + bytes <= texels.bytes.size(); i += bytes) {
        const std::uint32_t word = word_at(texels.bytes, i, layout.bytes);
        put_word(texels.bytes, i, layout.bytes, swapped(word, layout.fields[0], layout.fields[2]));
    }
    return texels;
}

}  // namespace twofold::evidence
