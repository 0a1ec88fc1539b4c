#include "tests/evidence/texel_rules.hpp"

#include <catch2/catch.hpp>

#include "tests/evidence/surface_memory.hpp"

namespace {

using namespace twofold;
using namespace twofold::evidence;

Rgba8 at(const ByteImage& picture, int x, int y) {
    return picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
}

constexpr Rgba8 red{255, 0, 0, 255}, blue{0, 0, 255, 128}, grey{9, 9, 9, 9};

}  // namespace

TEST_CASE("a checkerboard begins with its first colour, also with squares of 24", "[evidence]") {
    const ByteImage board = picture_of(Checkerboard{red, blue, 24}, 64, 64);
    CHECK(at(board, 0, 0) == red);
    CHECK(at(board, 23, 23) == red);
    CHECK(at(board, 24, 0) == blue);
    CHECK(at(board, 0, 24) == blue);
    CHECK(at(board, 24, 24) == red);
}

TEST_CASE("a checkerboard in a window counts from the window's corner", "[evidence]") {
    const ByteImage board = picture_of(CheckerboardWindow{{red, blue, 2}, grey, 3, 1, 4, 4}, 16, 8);
    CHECK(at(board, 2, 1) == grey);
    CHECK(at(board, 3, 0) == grey);
    CHECK(at(board, 3, 1) == red);
    CHECK(at(board, 5, 1) == blue);
    CHECK(at(board, 6, 4) == red);
    CHECK(at(board, 7, 4) == grey);
}

TEST_CASE("a gradient runs from 0 to just below 255, whatever the size", "[evidence]") {
    const ByteImage picture =
        picture_of(Gradient{{Ramp::y, Ramp::x, Ramp::inverted_y, Ramp::x_plus_y}}, 256, 128);
    CHECK(at(picture, 0, 0) == Rgba8{0, 0, 255, 0});
    CHECK(at(picture, 255, 0) == Rgba8{0, 254, 255, 254});
    CHECK(at(picture, 0, 127) == Rgba8{253, 0, 2, 253});
    CHECK(at(picture, 128, 127) == Rgba8{253, 127, 2, 124});
    const ByteImage constants = picture_of(
        Gradient{{std::uint8_t{255}, std::uint8_t{0}, Ramp::x, std::uint8_t{255}}}, 4, 1);
    CHECK(at(constants, 2, 0) == Rgba8{255, 0, 127, 255});
}

TEST_CASE("the radial pattern is opaque in its centre and transparent in its corner",
          "[evidence]") {
    const ByteImage picture = picture_of(RadialAlphaPattern{}, 64, 64);
    CHECK(at(picture, 32, 32).a == 255);
    CHECK(at(picture, 0, 0) == Rgba8{255, 0, 0, 0});
    CHECK(at(picture, 32, 0).a == 127);  // half of dmax
    CHECK(at(picture, 33, 34).r == at(picture, 1, 2).r);
}

TEST_CASE("the coloured checkerboard goes through eight colours along the diagonal", "[evidence]") {
    const ByteImage board = picture_of(ColouredCheckerboard{2}, 32, 32);
    CHECK(at(board, 0, 0) == Rgba8{255, 0, 0, 255});
    CHECK(at(board, 2, 0) == Rgba8{255, 0, 0, 0x66});
    CHECK(at(board, 2, 2) == Rgba8{0, 255, 0, 255});
    CHECK(at(board, 14, 0) == Rgba8{255, 255, 255, 0x66});
    CHECK(at(board, 14, 2) == at(board, 0, 0));
}

TEST_CASE("luminance is cut, not rounded", "[evidence]") {
    CHECK(luminance({255, 255, 255, 0}) == 255);
    CHECK(luminance({255, 0, 0, 0}) == 76);   // 76.245
    CHECK(luminance({0, 255, 0, 0}) == 149);  // 149.685
    CHECK(luminance({0, 0, 255, 0}) == 29);   // 29.07
    const ByteImage one{1, 1, {{0, 255, 0, 7}}};
    CHECK(stored(one, TextureFormat::l8).bytes == std::vector<std::uint8_t>{149});
    CHECK(stored(one, TextureFormat::i8).bytes == std::vector<std::uint8_t>{149});
    CHECK(stored(one, TextureFormat::la88).bytes == std::vector<std::uint8_t>{149, 7});
}

TEST_CASE("DXT1 blocks hold their first texel's colour, transparent below an alpha of 125",
          "[evidence]") {
    ByteImage block{4, 4, std::vector<Rgba8>(16, Rgba8{1, 2, 3, 255})};
    block.pixels[0] = {255, 0, 8, 125};
    const std::vector<std::uint8_t> opaque{0, 0, 0x01, 0xf8, 0x55, 0x55, 0x55, 0x55};
    CHECK(stored(block, TextureFormat::dxt1).bytes == opaque);
    block.pixels[0].a = 124;
    const auto transparent = stored(block, TextureFormat::dxt1).bytes;
    CHECK(std::vector<std::uint8_t>(transparent.begin() + 4, transparent.end()) ==
          std::vector<std::uint8_t>(4, 0xff));
}

TEST_CASE("a surface of 16 bits keeps the high bits, in little-endian words", "[evidence]") {
    const ByteImage pixel{1, 1, {{0xff, 0x87, 0x0f, 0xff}}};
    CHECK(memory_of(pixel, ColorFormat::rgb565) == std::vector<std::uint8_t>{0x21, 0xfc});
    CHECK(memory_of(pixel, ColorFormat::xrgb1555_z) == std::vector<std::uint8_t>{0x01, 0xfe});
    CHECK(memory_of(pixel, ColorFormat::rgba8888) ==
          std::vector<std::uint8_t>{0x0f, 0x87, 0xff, 0xff});
    const Rgba8 kept = as_stored(pixel, ColorFormat::rgb565).pixels[0];
    CHECK(kept == Rgba8{0xf8, 0x84, 0x08, 0xff});
    CHECK(as_stored({1, 1, {{0, 0, 0, 0}}}, ColorFormat::xrgb1555_o).pixels[0] == Rgba8{});
}

TEST_CASE("a surface reread as wider words is followed by zero bytes", "[evidence]") {
    const PackedTexels reread_words = reread({1, 2, 3, 4, 5, 6}, TextureFormat::argb8888, 2, 1);
    CHECK(reread_words.bytes == std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 0, 0});
}

TEST_CASE("red and blue change places within a stored word", "[evidence]") {
    CHECK(with_red_and_blue_swapped(PackedTexels{TextureFormat::argb8888, {1, 2, 3, 4}}).bytes ==
          std::vector<std::uint8_t>{3, 2, 1, 4});
    CHECK(with_red_and_blue_swapped(PackedTexels{TextureFormat::rgb565, {0x21, 0xfc}}).bytes ==
          std::vector<std::uint8_t>{0x3f, 0x0c});
}
