#include "texunit/texture_format.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "texunit/error.hpp"
#include "texunit/presets.hpp"
#include "texunit/random.hpp"

namespace {
using namespace twofold;

using AllModels = std::tuple<Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom>;

constexpr std::array word_formats{TextureFormat::argb8888, TextureFormat::xrgb8888,
                                  TextureFormat::rgb565,   TextureFormat::argb1555,
                                  TextureFormat::xrgb1555, TextureFormat::argb4444,
                                  TextureFormat::l8,       TextureFormat::a8,
                                  TextureFormat::i8,       TextureFormat::la88};

/// All 65,536 words of a 16-bit format, or all bytes of an 8-bit one, as one row.
PackedTexels all_words(TextureFormat format, int bits) {
    PackedTexels texels{format, {}};
    for (int w = 0; w < 1 << bits; ++w)
        for (int shift = 0; shift < bits; shift += 8)
            texels.bytes.push_back(static_cast<std::uint8_t>(w >> shift));
    return texels;
}

/// An n-bit value by replication of its bits from the top until eight are full.
int replicated(int v, int bits) {
    int result = 0;
    for (int shift = 8 - bits; shift > -bits; shift -= bits)
        result |= shift >= 0 ? v << shift : v >> -shift;
    return result;
}

/// What a model must make of an n-bit component: k / (2^n - 1) rounded once to the format of its
/// reals, the replication in bytes, or for coarse8 the bits alone.
template <NumericModel M>
typename M::Channel expected(int v, int bits) {
    using Channel = typename M::Channel;
    if constexpr (M::preset == Preset::coarse8)
        return v << (8 - bits);
    else if constexpr (M::is_integer)
        return replicated(v, bits);
    else
        return static_cast<Channel>(v) / static_cast<Channel>((1 << bits) - 1);
}

struct Bits {
    int shift, count;
};

/// Number of texels of a 16- or 8-bit format that differ from their fields; a field without bits is
/// the constant `shift`.
template <NumericModel M>
int wrong_texels(const M& m, TextureFormat format, int bits, const std::array<Bits, 4>& fields) {
    const auto texels = decode(m, all_words(format, bits), 1 << bits, 1);
    REQUIRE(texels.size() == std::size_t{1} << bits);
    int wrong = 0;
    for (int w = 0; w < 1 << bits; ++w)
        for (std::size_t c = 0; c < 4; ++c) {
            const auto [shift, count] = fields[c];
            const auto value = count == 0 ? expected<M>(255 * shift, 8)
                                          : expected<M>(w >> shift & ((1 << count) - 1), count);
            wrong += texels[static_cast<std::size_t>(w)][c] != value;
        }
    return wrong;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("every texel of the 16- and 8-bit formats is its fields, each expanded",
                        "[texture_format]", AllModels) {
    const TestType m{};
    constexpr Bits zero{0, 0}, one{1, 0}, low{0, 8}, high{8, 8};
    CHECK(wrong_texels(m, TextureFormat::rgb565, 16, {{{11, 5}, {5, 6}, {0, 5}, one}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::argb1555, 16, {{{10, 5}, {5, 5}, {0, 5}, {15, 1}}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::xrgb1555, 16, {{{10, 5}, {5, 5}, {0, 5}, one}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::argb4444, 16, {{{8, 4}, {4, 4}, {0, 4}, {12, 4}}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::la88, 16, {{low, low, low, high}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::l8, 8, {{low, low, low, one}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::a8, 8, {{zero, zero, zero, low}}) == 0);
    CHECK(wrong_texels(m, TextureFormat::i8, 8, {{low, low, low, low}}) == 0);
}

TEST_CASE("T10 replication differs from rounding for the listed values alone", "[hard][T10]") {
    struct Difference {
        int value, replicated, rounded;
    };
    const auto differences = [](int bits) {
        std::vector<std::array<int, 3>> found;
        const int last = (1 << bits) - 1;
        for (int v = 0; v <= last; ++v) {
            const int rounded = (2 * 255 * v + last) / (2 * last);
            if (Nv17{}.expand(v, bits) != rounded)
                found.push_back({v, Nv17{}.expand(v, bits), rounded});
        }
        return found;
    };
    using Rows = std::vector<std::array<int, 3>>;
    CHECK(differences(5) == Rows{{3, 24, 25}, {7, 57, 58}, {24, 198, 197}, {28, 231, 230}});
    CHECK(differences(6) == Rows{{11, 44, 45},
                                 {12, 48, 49},
                                 {13, 52, 53},
                                 {14, 56, 57},
                                 {15, 60, 61},
                                 {48, 195, 194},
                                 {49, 199, 198},
                                 {50, 203, 202},
                                 {51, 207, 206},
                                 {52, 211, 210}});
    for (const int bits : {1, 4, 8}) CHECK(differences(bits).empty());
}

TEMPLATE_LIST_TEST_CASE("8-bit components are taken as they are", "[texture_format]", AllModels) {
    const TestType m{};
    const std::vector<std::uint8_t> bytes{1, 2, 3, 4, 255, 0, 254, 128};  // b, g, r, a
    const auto argb = decode(m, PackedTexels{TextureFormat::argb8888, bytes}, 1, 2);
    const auto xrgb = decode(m, PackedTexels{TextureFormat::xrgb8888, bytes}, 1, 2);
    CHECK(argb[0] == m.texel(Rgba8{3, 2, 1, 4}));
    CHECK(argb[1] == m.texel(Rgba8{254, 0, 255, 128}));
    CHECK(xrgb[0] == m.texel(Rgba8{3, 2, 1, 255}));
    CHECK(xrgb[1] == m.texel(Rgba8{254, 0, 255, 255}));
}

TEST_CASE("what is packed comes back without its low bits", "[texture_format]") {
    std::vector<Rgba8> texels;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto byte = [i](std::uint64_t k) {
            return static_cast<std::uint8_t>(random_unit(k, i) * 256.0);
        };
        texels.push_back({byte(0), byte(1), byte(2), byte(3)});
    }
    const Nv17 m{};
    const auto cut = [](std::uint8_t v, int bits) { return replicated(v >> (8 - bits), bits); };
    for (const TextureFormat format : word_formats) {
        const PackedTexels packed{format, pack(format, texels, 100, 50)};
        REQUIRE(packed.bytes.size() == bytes_of(format, 100, 50));
        const auto back = decode(m, packed, 100, 50);
        int wrong = 0;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            const auto [r, g, b, a] = texels[i];
            Color<int> expected{r, g, b, a};
            if (format == TextureFormat::xrgb8888) expected[3] = 255;
            if (format == TextureFormat::rgb565) expected = {cut(r, 5), cut(g, 6), cut(b, 5), 255};
            if (format == TextureFormat::argb1555)
                expected = {cut(r, 5), cut(g, 5), cut(b, 5), cut(a, 1)};
            if (format == TextureFormat::xrgb1555)
                expected = {cut(r, 5), cut(g, 5), cut(b, 5), 255};
            if (format == TextureFormat::argb4444)
                expected = {cut(r, 4), cut(g, 4), cut(b, 4), cut(a, 4)};
            if (format == TextureFormat::l8) expected = {r, r, r, 255};
            if (format == TextureFormat::a8) expected = {0, 0, 0, a};
            if (format == TextureFormat::i8) expected = {r, r, r, r};
            if (format == TextureFormat::la88) expected = {r, r, r, a};
            wrong += back[i] != expected;
        }
        CAPTURE(static_cast<int>(format));
        CHECK(wrong == 0);
    }
}

TEST_CASE("sizes count whole blocks, and another number of bytes is an error", "[texture_format]") {
    CHECK(bytes_of(TextureFormat::argb8888, 3, 5) == 60);
    CHECK(bytes_of(TextureFormat::rgb565, 3, 5) == 30);
    CHECK(bytes_of(TextureFormat::l8, 3, 5) == 15);
    CHECK(bytes_of(TextureFormat::dxt1, 4, 4) == 8);
    CHECK(bytes_of(TextureFormat::dxt1, 5, 1) == 16);
    CHECK(bytes_of(TextureFormat::dxt5, 9, 9) == 144);
    CHECK(bytes_of(TextureFormat::dxt3, 1, 1) == 16);
    const Nv17 m{};
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{7}, std::size_t{9}}) {
        const PackedTexels packed{TextureFormat::dxt1, std::vector<std::uint8_t>(bytes)};
        CHECK_THROWS_AS(decode(m, packed, 4, 4), Error);
    }
    CHECK_THROWS_AS(pack(TextureFormat::dxt5, {}, 0, 0), Error);
}

TEST_CASE("every format names its base format", "[texture_format]") {
    CHECK(base_format_of(TextureFormat::argb8888) == BaseFormat::rgba);
    CHECK(base_format_of(TextureFormat::xrgb8888) == BaseFormat::rgb);
    CHECK(base_format_of(TextureFormat::rgb565) == BaseFormat::rgb);
    CHECK(base_format_of(TextureFormat::argb1555) == BaseFormat::rgba);
    CHECK(base_format_of(TextureFormat::xrgb1555) == BaseFormat::rgb);
    CHECK(base_format_of(TextureFormat::argb4444) == BaseFormat::rgba);
    CHECK(base_format_of(TextureFormat::l8) == BaseFormat::luminance);
    CHECK(base_format_of(TextureFormat::a8) == BaseFormat::alpha);
    CHECK(base_format_of(TextureFormat::i8) == BaseFormat::intensity);
    CHECK(base_format_of(TextureFormat::la88) == BaseFormat::luminance_alpha);
    CHECK(base_format_of(TextureFormat::dxt1) == BaseFormat::rgba);
    CHECK(base_format_of(TextureFormat::dxt3) == BaseFormat::rgba);
    CHECK(base_format_of(TextureFormat::dxt5) == BaseFormat::rgba);
}
