#include "texunit/image_file.hpp"

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

#include "tests/temporary_folder.hpp"
#include "texunit/error.hpp"

namespace {
using namespace twofold;
using namespace std::string_literals;
using Bytes = std::vector<unsigned char>;
using Catch::Contains;
namespace fs = std::filesystem;

const TemporaryFolder& folder() {
    static const TemporaryFolder result;
    return result;
}

/// A file of these bytes whose name says nothing about its format.
fs::path file_of(const Bytes& bytes) {
    // Not write_file_atomically(): thousands of flushes to the disk would take half a minute.
    std::ofstream(folder() / "picture", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return folder() / "picture";
}

fs::path file_of(const std::string& text) { return file_of(Bytes(text.begin(), text.end())); }

/// Bytes from hexadecimal text.
Bytes from_hex(const std::string& hex) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<unsigned char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

std::string little_endian(const std::vector<float>& values) {
    std::string text;
    for (const float value : values)
        for (int shift = 0; shift < 32; shift += 8)
            text.push_back(static_cast<char>(std::bit_cast<std::uint32_t>(value) >> shift & 255U));
    return text;
}

/// A Radiance file of one row of two pixels, (128, 64, 32, 129) each, with extra header lines.
std::string hdr_with(const std::string& lines) {
    const std::string pixel = "\x80\x40\x20\x81";
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n-Y 1 +X 2\n" + pixel + pixel;
}

/// PNG files of one pixel, made with zlib: RGB (1, 2, 3), grey 7, grey 7 with alpha 9, 16-bit grey.
const char* const png_head = "89504e470d0a1a0a0000000d49484452";
const char* const png_end = "0000000049454e44ae426082";
Bytes small_png(const std::string& middle) { return from_hex(png_head + middle + png_end); }
Bytes rgb_png() {
    return small_png(
        "00000001000000010802000000907753de"
        "0000000c4944415478da636064620600000e0007e99237d4");
}
Bytes grey_png() {
    return small_png(
        "000000010000000108000000003a7e9b55"
        "0000000a4944415478da63600700000900088dabb901");
}
Bytes grey_alpha_png() {
    return small_png(
        "00000001000000010804000000b51c0c02"
        "0000000b4944415478da6360e70400001a0011f3695375");
}
Bytes sixteen_bit_png() {
    return small_png(
        "000000010000000110000000006aee4716"
        "0000000b4944415478da6360e70400001a0011f3695375");
}
Bytes huge_png() {
    return small_png(
        "7fffffff7fffffff08020000009bab9c31"
        "000000094944415478da63000000010001b10db693");
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

/// Every special value, and ordinary ones up to the wanted number.
std::vector<float> difficult_samples(std::size_t count) {
    using Limits = std::numeric_limits<float>;
    std::vector<float> samples{Limits::quiet_NaN(),
                               std::bit_cast<float>(0xffc12345U),
                               Limits::infinity(),
                               -Limits::infinity(),
                               -0.0F,
                               Limits::denorm_min(),
                               Limits::max(),
                               -3894.0F};
    for (std::size_t i = samples.size(); i < count; ++i)
        samples.push_back(static_cast<float>(i) / 7.0F);
    return samples;
}

/// Small files of every format that is read, complete.
std::vector<Bytes> small_files() {
    const ByteImage byte_image{3, 2, std::vector<Rgba8>(6, Rgba8{1, 2, 3, 4})};
    const FloatImage float_image{3, 2, 3, difficult_samples(18)};
    std::vector<Bytes> files{encode_png(byte_image), encode_exr(float_image), rgb_png()};
    for (const std::string& text : {hdr_with("EXPOSURE=2\n"), "P6\n2 1\n255\n123456"s,
                                    "PF\n2 1\n-1\n" + little_endian({1, 2, 3, 4, 5, 6})})
        files.emplace_back(text.begin(), text.end());
    return files;
}

/// Reading gives a picture or an Error and nothing else; true for a picture.
bool can_be_read(const Bytes& bytes) {
    try {
        return !read_float_image(file_of(bytes)).image.samples.empty();
    } catch (const Error& error) {
        return error.code() != ExitCode::bad_file;
    }
}
}  // namespace

TEST_CASE("all 65,536 pairs of value and alpha survive a PNG", "[image_file]") {
    ByteImage image{256, 256, {}};
    for (int alpha = 0; alpha < 256; ++alpha)
        for (int value = 0; value < 256; ++value) {
            const auto v = static_cast<std::uint8_t>(value);
            const auto other = static_cast<std::uint8_t>(255 - value);
            image.pixels.push_back({v, other, v, static_cast<std::uint8_t>(alpha)});
        }
    const ByteImage read = read_png(file_of(encode_png(image)));
    CHECK(read.width == 256);
    CHECK(read.height == 256);
    CHECK(read.pixels == image.pixels);
}

TEST_CASE("a PNG read as floats is v / 255 in file order with alpha apart", "[image_file]") {
    const ByteImage image{1, 2, {{51, 0, 255, 0}, {1, 2, 3, 128}}};
    const FloatImage read = read_float_image(file_of(encode_png(image))).image;
    CHECK(read.channels == 4);
    const std::vector<float> expected{51 / 255.0F, 0.0F,       1.0F,       0.0F,
                                      1 / 255.0F,  2 / 255.0F, 3 / 255.0F, 128 / 255.0F};
    CHECK(read.samples == expected);
}

TEST_CASE("RGB gets alpha 255, grey is spread, 16 bits are refused", "[image_file]") {
    CHECK(read_png(file_of(rgb_png())).pixels == std::vector{Rgba8{1, 2, 3, 255}});
    CHECK(read_png(file_of(grey_png())).pixels == std::vector{Rgba8{7, 7, 7, 255}});
    CHECK(read_png(file_of(grey_alpha_png())).pixels == std::vector{Rgba8{7, 7, 7, 9}});
    CHECK_THROWS_WITH(read_png(file_of(sixteen_bit_png())), Contains("more than 8 bits"));
    CHECK_THROWS_WITH(read_png(file_of(hdr_with(""))), Contains("not a PNG"));
}

TEST_CASE("OpenEXR keeps NaN, Inf, -0 and denormals bit by bit", "[image_file]") {
    for (int channels = 1; channels <= 4; ++channels) {
        const auto count = static_cast<std::size_t>(5 * 3 * channels);
        const FloatImage image{5, 3, channels, difficult_samples(count)};
        const FloatImage read = read_float_image(file_of(encode_exr(image))).image;
        CHECK(read.width == 5);
        CHECK(read.height == 3);
        CHECK(read.channels == channels);
        CHECK(same_bits(read.samples, image.samples));
    }
}

TEST_CASE("the same picture gives the same bytes, without a clock or a program's name",
          "[image_file]") {
    const FloatImage image{2, 2, 3, std::vector<float>(12, 0.5F)};
    const Bytes bytes = encode_exr(image);
    CHECK(bytes == encode_exr(image));
    const std::string text(bytes.begin(), bytes.end());
    CHECK_THAT(text, Contains("1970:01:01 00:00:00"));
    CHECK_THAT(text, !Contains("OpenImageIO"));
    const Bytes png = encode_png({1, 1, {Rgba8{}}});
    CHECK_THAT(std::string(png.begin(), png.end()), !Contains("Software") && !Contains("tIME"));
}

TEST_CASE("an inconsistent picture is not written", "[image_file]") {
    CHECK_THROWS_WITH(encode_png({2, 2, {Rgba8{}}}), Contains("2 x 2 pixels"));
    CHECK_THROWS_AS(encode_png({}), Error);
    CHECK_THROWS_AS(encode_exr({1, 1, 5, std::vector<float>(5)}), Error);
    CHECK_THROWS_AS(encode_exr({-1, -1, 1, std::vector<float>(1)}), Error);
}

TEST_CASE("a PFM file is turned top down and its scale multiplied in", "[image_file]") {
    const std::string text = "Pf\n2 2\n-2.0\n" + little_endian({1, 2, 3, 4});
    CHECK(read_float_image(file_of(text)).image.samples == std::vector<float>{6, 8, 2, 4});
    const FloatImage ppm =
        read_float_image(file_of("P6\n1 2\n255\n\xff\x33\x66\x99\xcc\xff"s)).image;
    // Divisions that round correctly: 3 * (1 / 255) would be another float than 3 / 255.
    CHECK(ppm.samples == std::vector<float>{1.0F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F});
}

TEST_CASE("D05 EXPOSURE and GAMMA are reported and never applied", "[image_file][hard][D05]") {
    const std::vector<float> stored{1.0F, 0.5F, 0.25F, 1.0F, 0.5F, 0.25F};
    const ReadImage plain = read_float_image(file_of(hdr_with("")));
    CHECK(plain.image.samples == stored);
    CHECK(plain.notes.empty());
    CHECK(read_float_image(file_of(hdr_with("EXPOSURE=1\nGAMMA=1\n"))).notes.empty());
    for (const std::string value : {"0", "2", "1e-30"}) {
        const ReadImage read = read_float_image(file_of(hdr_with("EXPOSURE=" + value + "\n")));
        CHECK(read.image.samples == stored);
        REQUIRE(read.notes.size() == 1);
        CHECK(read.notes[0] == "EXPOSURE=" + value + " in the header is not applied");
    }
}

TEST_CASE("a product environment has the size and the maximum of its provenance", "[image_file]") {
    const fs::path path = fs::path(TWOFOLD_SOURCE_DIR) / "scenes/data/env/studio.hdr";
    const FloatImage image = read_float_image(path).image;
    CHECK(image.width == 512);
    CHECK(image.height == 256);
    CHECK(image.channels == 3);
    CHECK(*std::max_element(image.samples.begin(), image.samples.end()) == 104.5F);
}

TEST_CASE("D08 sizes that are not powers of two and four channels are read",
          "[image_file][hard][D08]") {
    const FloatImage image{1000, 500, 4, std::vector<float>(2'000'000, 0.25F)};
    const FloatImage read = read_float_image(file_of(encode_exr(image))).image;
    CHECK(read.width == 1000);
    CHECK(read.height == 500);
    CHECK(read.channels == 4);
}

TEST_CASE("D04 a file that is no picture is named with the reason", "[image_file][hard][D04]") {
    CHECK_THROWS_WITH(read_float_image(folder() / "none.hdr"),
                      Contains("none.hdr: cannot open: No such file"));
    CHECK_THROWS_WITH(read_float_image(file_of(""s)), Contains("picture: empty file"));
    CHECK_THROWS_WITH(read_float_image(file_of("FOR4\x01\x02\x03\x04\x05"s)),
                      Contains("unknown format (starts with 46 4f 52 34 01 02 03 04)"));
    CHECK_THROWS_WITH(read_float_image(file_of("version https://git-lfs.github.com/spec/v1\n"
                                               "oid sha256:4665\nsize 12345\n"s)),
                      Contains("Git LFS pointer"));
}

TEST_CASE("a header cannot claim more than the limits or the file's length", "[image_file]") {
    for (const std::string& text :
         {"P6\n99999 1\n255\n"s, "P6\n2147483647 2147483647\n255\n"s, "P6\n-1 -1\n255\n"s,
          "P6\n0 0\n255\n"s, "PF\n16385 1\n-1\n"s, "PF\n16384 16384\n-1\n"s, "P6\n"s, "PF"s,
          "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n"s,
          "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y -1 +X 99999999999\n"s,
          "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"s})
        CHECK_THROWS_AS(read_float_image(file_of(text)), Error);
    CHECK_THROWS_AS(read_float_image(file_of(huge_png())), Error);
    CHECK_THROWS_WITH(read_float_image(file_of("P6\n4000 4000\n255\nabc"s)),
                      Contains("do not fit into a file of this length"));
}

TEST_CASE("a file truncated anywhere is an error", "[image_file]") {
    for (const Bytes& whole : small_files()) {
        REQUIRE(can_be_read(whole));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
            CAPTURE(length, whole.size(), whole[0]);
            CHECK_FALSE(can_be_read(part));
        }
    }
}

TEST_CASE("a file with one changed byte is a picture or an error", "[image_file]") {
    int pictures = 0;
    for (Bytes bytes : small_files())
        for (unsigned char& byte : bytes)
            for (const int change : {0x01, 0x80, 0xff}) {
                byte = static_cast<unsigned char>(byte ^ change);
                pictures += can_be_read(bytes) ? 1 : 0;
                byte = static_cast<unsigned char>(byte ^ change);
            }
    CHECK(pictures > 0);
}
