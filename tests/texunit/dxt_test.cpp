#include "texunit/dxt.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <concepts>

#include "texunit/presets.hpp"
#include "texunit/random.hpp"
#include "texunit/texture_format.hpp"

namespace {
using namespace twofold;

std::uint8_t random_byte(std::uint64_t seed, std::uint64_t i) {
    return static_cast<std::uint8_t>(random_unit(seed, i) * 256.0);
}

/// An image of random blocks; every fourth has equal endpoints, so that ties of the order occur.
PackedTexels random_blocks(TextureFormat format, int width, int height, std::uint64_t seed) {
    PackedTexels texels{format, {}};
    const std::size_t size = format == TextureFormat::dxt1 ? 8 : 16;
    for (std::size_t i = 0; i < bytes_of(format, width, height); ++i)
        texels.bytes.push_back(random_byte(seed, i));
    for (std::size_t i = 0; i < texels.bytes.size(); i += 4 * size) {
        auto* color = texels.bytes.data() + i + size - 8;
        color[2] = color[0];
        color[3] = color[1];
        if (size == 16) texels.bytes[i + 1] = texels.bytes[i];
    }
    return texels;
}

/// A value of [0, 1] as a fraction.
struct Fraction {
    std::int64_t numerator, denominator;
};

/// An independent decoder of one texel: bit by bit, every channel as weights of two stored values.
struct Mean {
    int first, second;  ///< stored values
    int bits;           ///< of them
    int w1, w2;         ///< weights
};

using MeanTexel = std::array<Mean, 4>;

int bit_field(const std::uint8_t* bytes, int from, int count) {
    int value = 0;
    for (int i = count - 1; i >= 0; --i)
        value = 2 * value + (bytes[(from + i) / 8] >> (from + i) % 8 & 1);
    return value;
}

Mean decoded_alpha(TextureFormat format, const std::uint8_t* block, int k) {
    if (format == TextureFormat::dxt3) return {bit_field(block, 4 * k, 4), 0, 4, 1, 0};
    const int a0 = block[0], a1 = block[1], code = bit_field(block, 16 + 3 * k, 3);
    static constexpr int eight[8][2] = {{1, 0}, {0, 1}, {6, 1}, {5, 2},
                                        {4, 3}, {3, 4}, {2, 5}, {1, 6}};
    static constexpr int six[6][2] = {{1, 0}, {0, 1}, {4, 1}, {3, 2}, {2, 3}, {1, 4}};
    if (a0 > a1) return {a0, a1, 8, eight[code][0], eight[code][1]};
    if (code == 6) return {0, 0, 8, 1, 0};
    if (code == 7) return {255, 0, 8, 1, 0};
    return {a0, a1, 8, six[code][0], six[code][1]};
}

MeanTexel decoded_texel(TextureFormat format, const std::uint8_t* block, int k) {
    const bool dxt1 = format == TextureFormat::dxt1;
    const std::uint8_t* color = dxt1 ? block : block + 8;
    const int code = bit_field(color, 32 + 2 * k, 2);
    const bool four = !dxt1 || bit_field(color, 0, 16) > bit_field(color, 16, 16);
    static constexpr int four_weights[4][2] = {{1, 0}, {0, 1}, {2, 1}, {1, 2}};
    static constexpr int three_weights[4][2] = {{1, 0}, {0, 1}, {1, 1}, {0, 0}};
    const auto* w = four ? four_weights[code] : three_weights[code];
    const auto mean = [&](int from, int count) {
        return Mean{bit_field(color, from, count), bit_field(color, 16 + from, count), count, w[0],
                    w[1]};
    };
    const bool clear = !four && code == 3;
    const Mean alpha = dxt1 ? Mean{clear ? 0 : 255, 0, 8, 1, 0} : decoded_alpha(format, block, k);
    return {mean(11, 5), mean(5, 6), mean(0, 5), alpha};
}

/// The oracle's channel in bytes: replicated ends, mean to nearest.
int in_bytes(const Mean& mean) {
    const auto end = [&](int v) {
        if (mean.bits == 8) return v;
        if (mean.bits == 4) return v * 17;
        return v << (8 - mean.bits) | v >> (2 * mean.bits - 8);
    };
    const int n = mean.w1 + mean.w2;
    if (n == 0) return 0;
    return static_cast<int>(
        std::floor((mean.w1 * end(mean.first) + mean.w2 * end(mean.second)) / double(n) + 0.5));
}

/// The oracle's channel as a fraction of exact integers.
double in_reals(const Mean& mean) {
    const int n = mean.w1 + mean.w2;
    if (n == 0) return 0.0;
    const Fraction exact{mean.w1 * mean.first + mean.w2 * mean.second,
                         n * ((std::int64_t{1} << mean.bits) - 1)};
    return static_cast<double>(exact.numerator) / static_cast<double>(exact.denominator);
}

/// Number of channels off the oracle: none may be for bytes, reals have three roundings.
template <NumericModel M>
int wrong_channels(const M& m, TextureFormat format, int width, int height) {
    const PackedTexels packed = random_blocks(format, width, height, 77);
    const auto texels = decode(m, packed, width, height);
    const int across = (width + 3) / 4;
    const int size = format == TextureFormat::dxt1 ? 8 : 16;
    int wrong = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto* block = packed.bytes.data() + (y / 4 * across + x / 4) * size;
            const auto expected = decoded_texel(format, block, y % 4 * 4 + x % 4);
            const auto& texel = texels[static_cast<std::size_t>(y * width + x)];
            for (std::size_t c = 0; c < 4; ++c)
                if constexpr (std::same_as<typename M::Channel, int>) {
                    wrong += texel[c] != in_bytes(expected[c]);
                } else {
                    constexpr double ulp = sizeof(typename M::Channel) == 4 ? 0x1p-23 : 0x1p-52;
                    const auto exact = in_reals(expected[c]);
                    wrong += !(std::fabs(static_cast<double>(texel[c]) - exact) <= 2 * ulp * exact);
                }
        }
    return wrong;
}
}  // namespace

TEMPLATE_TEST_CASE("DXT texels are those of an independent decoder", "[dxt]", Ideal64, Float32,
                   Gl13, Nv17, Custom) {
    const TestType m{};
    for (const TextureFormat format :
         {TextureFormat::dxt1, TextureFormat::dxt3, TextureFormat::dxt5})
        for (const auto& [width, height] : {std::array{128, 64}, std::array{4, 4}, std::array{1, 1},
                                            std::array{7, 9}, std::array{2, 12}}) {
            CAPTURE(static_cast<int>(format), width, height);
            CHECK(wrong_channels(m, format, width, height) == 0);
        }
}

TEST_CASE("NV2x decodes DXT3 and DXT5 without dither", "[dxt]") {
    CHECK(wrong_channels(Nv2x{}, TextureFormat::dxt3, 64, 64) == 0);
    CHECK(wrong_channels(Nv2x{}, TextureFormat::dxt5, 64, 64) == 0);
    CHECK(wrong_channels(Nv2x{}, TextureFormat::dxt1, 64, 64) > 0);
}

TEST_CASE("thirds are rounded to nearest and not cut", "[dxt]") {
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            const int thirds = dxt::weighted_mean(2, a, 1, b);
            if (std::abs(3 * thirds - (2 * a + b)) > 1) CHECK(thirds == 0);
            const int half = dxt::weighted_mean(1, a, 1, b);
            if (half != (a + b + 1) / 2) CHECK(half == (a + b + 1) / 2);
        }
}

TEST_CASE("the dither keeps black and white, and moves others by half a step at most", "[dxt]") {
    for (const int step : {4, 8})
        for (int cell = 0; cell < step; ++cell) {
            CHECK(dxt::dithered(0, step, cell) == 0);
            CHECK(dxt::dithered(255, step, cell) == 255);
            for (int v = step + 1; v < 255; ++v) {
                const int seen = dxt::dithered(v, step, cell);
                CAPTURE(v, step, cell);
                CHECK(seen <= std::min(v + step / 2 - 1, 255));
                CHECK(seen >= v - step / 2);
                CHECK((seen % step == cell || seen == 255));
            }
        }
    CHECK(dxt::dithered(8, 8, 3) == 11);
    CHECK(dxt::dithered(4, 4, 1) == 5);
    for (int cell = 0; cell < 8; ++cell) CHECK(dxt::dithered(8, 8, cell) == (cell == 3 ? 11 : 0));
    for (int cell = 0; cell < 4; ++cell) CHECK(dxt::dithered(4, 4, cell) == (cell == 1 ? 5 : 0));
}

TEST_CASE("NV2x dithers a grey of one block as the captures show", "[dxt]") {
    const std::vector<Rgba8> grey(16, Rgba8{132, 130, 132, 255});  // 5:6:5 gives 132, 130, 132
    const PackedTexels packed{TextureFormat::dxt1, pack(TextureFormat::dxt1, grey, 4, 4)};
    const auto texels = decode(Nv2x{}, packed, 4, 4);
    const std::array red{131, 135, 132, 128, 133, 129, 134, 130,
                         128, 132, 135, 131, 130, 134, 129, 133};
    const std::array green{128, 130, 131, 129, 131, 129, 130, 128,
                           130, 128, 129, 131, 129, 131, 128, 130};
    for (std::size_t k = 0; k < 16; ++k) {
        const std::size_t mirrored = (3 - k / 4) * 4 + k % 4;
        CHECK(texels[k] == Color<int>{red[k], green[k], red[mirrored], 255});
    }
    CHECK(decode(Nv17{}, packed, 4, 4)[5] == Color<int>{132, 130, 132, 255});
}

TEST_CASE("one-colour blocks are opaque from alpha 125 on", "[dxt]") {
    for (const int alpha : {0, 124, 125, 255}) {
        const std::vector<Rgba8> texels(16, Rgba8{255, 0, 255, static_cast<std::uint8_t>(alpha)});
        const PackedTexels packed{TextureFormat::dxt1, pack(TextureFormat::dxt1, texels, 4, 4)};
        const Color<int> seen = alpha >= 125 ? Color<int>{255, 0, 255, 255} : Color<int>{};
        for (const auto& texel : decode(Nv17{}, packed, 4, 4)) CHECK(texel == seen);
        for (const auto& texel : decode(Nv2x{}, packed, 4, 4)) CHECK(texel == seen);
    }
}

TEST_CASE("only NV2x dithers DXT1", "[dxt]") {
    CHECK(dxt::dithers_dxt1(Preset::nv2x));
    for (const Preset preset : {Preset::ideal64, Preset::float32, Preset::gl13, Preset::nv17})
        CHECK_FALSE(dxt::dithers_dxt1(preset));
}
