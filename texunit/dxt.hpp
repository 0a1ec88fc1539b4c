#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "texunit/numeric_model.hpp"
#include "texunit/preset.hpp"
#include "texunit/texture.hpp"

/// Decoding of DXT1, DXT3 and DXT5: blocks of 4 x 4 texels, each a choice between colours on the
/// line from one 5:6:5 colour to another.
/// @source EXT_texture_compression_s3tc
namespace twofold::dxt {

/// The number that up to eight bytes hold, lowest first.
constexpr std::uint64_t little_endian(std::span<const std::uint8_t> bytes) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) word |= std::uint64_t{bytes[i]} << 8 * i;
    return word;
}

constexpr std::size_t bytes_per_block(TextureFormat format) {
    return format == TextureFormat::dxt1 ? 8 : 16;
}

/// (wa a + wb b) / (wa + wb): in reals, or to the nearest step of an integer channel, halves up
/// (thirds, fifths and sevenths have none). Rounded thirds of the 8-bit values are measured on NV2A
/// (floor: 683 of 1,908 texels wrong) and inferred for NV17; the other means follow their rule.
template <class Channel>
Channel weighted_mean(int wa, Channel a, int wb, Channel b) {
    if constexpr (std::integral<Channel>) {
        const int n = wa + wb;
        return (wa * a + wb * b + n / 2) / n;
    } else {
        const auto weight = [](int w) { return static_cast<Channel>(w); };
        return (weight(wa) * a + weight(wb) * b) / weight(wa + wb);
    }
}

template <NumericModel M>
using Palette = std::array<Color<typename M::Channel>, 4>;

template <NumericModel M>
Color<typename M::Channel> endpoint(const M& m, std::uint32_t rgb565) {
    const auto bits = [rgb565](int shift, unsigned mask) {
        return static_cast<int>(rgb565 >> shift & mask);
    };
    return {m.expand(bits(11, 31), 5), m.expand(bits(5, 63), 6), m.expand(bits(0, 31), 5), m.one()};
}

template <class Channel>
Color<Channel> mean_color(int wa, const Color<Channel>& a, int wb, const Color<Channel>& b) {
    return {weighted_mean(wa, a[0], wb, b[0]), weighted_mean(wa, a[1], wb, b[1]),
            weighted_mean(wa, a[2], wb, b[2]), a[3]};
}

/// The four colours of a block. DXT1 has three and transparent black where colour0 <= colour1.
template <NumericModel M>
Palette<M> palette_of(const M& m, std::uint64_t color_block, bool is_dxt1) {
    const auto c0 = static_cast<std::uint32_t>(color_block & 0xffff);
    const auto c1 = static_cast<std::uint32_t>(color_block >> 16 & 0xffff);
    const auto a = endpoint(m, c0), b = endpoint(m, c1);
    if (c0 > c1 || !is_dxt1) return {a, b, mean_color(2, a, 1, b), mean_color(1, a, 2, b)};
    constexpr typename M::Channel zero{0};
    return {a, b, mean_color(1, a, 1, b), {zero, zero, zero, zero}};
}

/// Alpha of texel `k` of a DXT3 block: four bits each.
template <NumericModel M>
typename M::Channel dxt3_alpha(const M& m, std::uint64_t alpha_block, int k) {
    return m.expand(static_cast<int>(alpha_block >> 4 * k & 15), 4);
}

/// Alpha of texel `k` of a DXT5 block: three bits choose one of eight on the line from alpha0 to
/// alpha1, or one of six, 0 and 1 where alpha0 <= alpha1.
template <NumericModel M>
typename M::Channel dxt5_alpha(const M& m, std::uint64_t alpha_block, int k) {
    const int first = static_cast<int>(alpha_block & 0xff);
    const int second = static_cast<int>(alpha_block >> 8 & 0xff);
    const int code = static_cast<int>(alpha_block >> (16 + 3 * k) & 7);
    const int steps = first > second ? 7 : 5;
    if (code == 0) return m.expand(first, 8);
    if (code == 1) return m.expand(second, 8);
    if (code > steps) return code == 6 ? typename M::Channel{0} : m.one();
    return weighted_mean(steps + 1 - code, m.expand(first, 8), code - 1, m.expand(second, 8));
}

/// Whether the chip dithers what it decodes from DXT1 by texel position. Measured on NV2A; nothing
/// public says so of NV17, which is taken not to.
constexpr bool dithers_dxt1(Preset preset) { return preset == Preset::nv2x; }

/// The largest value of `cell` modulo `step` that exceeds v by less than half a step. Black and
/// white stay; the value one step above black is reached from below or falls to black.
/// @param step  8 for red and blue, 4 for green: what 5 and 6 bits leave open of eight
/// @source NV2A captures: all of 6,144 samples
constexpr int dithered(int v, int step, int cell) {
    const int half = step / 2;
    if (v == 0 || v == 255) return v;
    if (v == step) return cell == half - 1 ? step + cell : 0;
    const int ceiling = v + half - 1;
    const int below = ceiling - ((ceiling - cell) % step + step) % step;
    return below < 0 ? 0 : (below < 255 ? below : 255);
}

/// The dither cells by row and column of the texel modulo 4; blue takes red's rows in reverse
/// order.
inline constexpr std::array<std::array<int, 4>, 4> red_cells{
    {{3, 7, 4, 0}, {5, 1, 6, 2}, {0, 4, 7, 3}, {2, 6, 1, 5}}};
inline constexpr std::array<std::array<int, 4>, 4> green_cells{
    {{0, 2, 3, 1}, {3, 1, 2, 0}, {2, 0, 1, 3}, {1, 3, 0, 2}}};

/// A decoded DXT1 texel of 8-bit channels after the dither. @param k  place in the block, 0..15
constexpr Color<int> dithered(const Color<int>& c, std::size_t k) {
    const std::size_t x = k % 4, y = k / 4;
    return {dithered(c[0], 8, red_cells[y][x]), dithered(c[1], 4, green_cells[y][x]),
            dithered(c[2], 8, red_cells[3 - y][x]), c[3]};
}

/// The 16 texels of one block, row by row.
template <NumericModel M>
std::array<Color<typename M::Channel>, 16> decode_block(const M& m, TextureFormat format,
                                                        std::span<const std::uint8_t> bytes) {
    const bool is_dxt1 = format == TextureFormat::dxt1;
    const std::uint64_t color_block = little_endian(bytes.last(8));
    const std::uint64_t alpha_block = little_endian(bytes.first(8));
    const Palette<M> palette = palette_of(m, color_block, is_dxt1);
    std::array<Color<typename M::Channel>, 16> texels;
    for (std::size_t k = 0; k < 16; ++k) {
        texels[k] = palette[color_block >> (32 + 2 * k) & 3];
        const int place = static_cast<int>(k);
        if (format == TextureFormat::dxt3) texels[k][3] = dxt3_alpha(m, alpha_block, place);
        if (format == TextureFormat::dxt5) texels[k][3] = dxt5_alpha(m, alpha_block, place);
        if constexpr (dithers_dxt1(M::preset))
            if (is_dxt1) texels[k] = dithered(texels[k], k);
    }
    return texels;
}

/// The texels of an image, rows bottom up. What blocks hold beyond its rim is dropped.
template <NumericModel M>
std::vector<Color<typename M::Channel>> decode(const M& m, const PackedTexels& packed, int width,
                                               int height) {
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    const std::size_t across = (w + 3) / 4, size = bytes_per_block(packed.format);
    std::vector<Color<typename M::Channel>> result(w * h);
    for (std::size_t block = 0; block < across * ((h + 3) / 4); ++block) {
        const auto texels =
            decode_block(m, packed.format, std::span(packed.bytes).subspan(block * size, size));
        for (std::size_t k = 0; k < 16; ++k) {
            const std::size_t x = block % across * 4 + k % 4, y = block / across * 4 + k / 4;
            if (x < w && y < h) result[y * w + x] = texels[k];
        }
    }
    return result;
}

}  // namespace twofold::dxt
