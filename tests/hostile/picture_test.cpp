#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "tests/refusal.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

using namespace twofold;
using namespace std::string_literals;
using Catch::Contains;

namespace {

std::string big_endian(std::uint32_t value, int bytes = 4) {
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
        text.push_back(static_cast<char>(value >> shift & 255U));
    return text;
}

std::string little_endian(std::uint32_t value) {
    const std::string text = big_endian(value);
    return {text.rbegin(), text.rend()};
}

std::string repeated(char c, std::size_t count) { return std::string(count, c); }

/// A Maya IFF picture of 8 x 8 pixels in one tile. Readers of such files write past their buffers
/// when the tile's numbers lie.
std::string iff_file() {
    const std::string header = big_endian(8) + big_endian(8) + big_endian(1, 2) + big_endian(1, 2) +
                               big_endian(1) + big_endian(1) + big_endian(1) + repeated('\0', 8);
    const std::string tile = big_endian(0, 2) + big_endian(0, 2) + big_endian(7, 2) +
                             big_endian(7, 2) + repeated('\x3f', 64);
    const std::string body =
        "TBMPRGBA" + big_endian(static_cast<std::uint32_t>(tile.size())) + tile;
    const std::string tiles = "FOR4" + big_endian(static_cast<std::uint32_t>(body.size())) + body;
    const std::string all = "CIMGTBHD" + big_endian(32) + header + tiles;
    return "FOR4" + big_endian(static_cast<std::uint32_t>(all.size())) + all;
}

/// An SGI picture of 8 x 4 pixels: 512 bytes of header, then planes.
std::string sgi_file() {
    const std::string head = "\x01\xda"s + "\0\x01"s + big_endian(3, 2) + big_endian(8, 2) +
                             big_endian(4, 2) + big_endian(3, 2) + big_endian(0) + big_endian(255);
    return head + repeated('\0', 512 - head.size()) + repeated('\x7f', 8 * 4 * 3);
}

std::span<const unsigned char> bytes_of(const std::string& text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

std::string refusal(const std::string& file, const std::string& name = "a.png") {
    return cases::refusal(ExitCode::bad_file, [&] { decode_float_image(bytes_of(file), name); });
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + little_endian(static_cast<std::uint32_t>(value.size())) +
           value;
}

std::string window(std::array<std::int32_t, 4> edges) {
    std::string text;
    for (const std::int32_t edge : edges) text += little_endian(std::bit_cast<std::uint32_t>(edge));
    return text;
}

/// The start of an OpenEXR file with these attributes and no more.
std::string exr_with(const std::string& attributes, std::uint32_t flags = 2) {
    return "\x76\x2f\x31\x01" + little_endian(flags) + attributes + '\0';
}

/// A PNG without rows. @param checksum of IHDR
std::string png_with(std::uint32_t width, std::uint32_t height, const std::string& kind,
                     std::uint32_t checksum) {
    const std::string header = big_endian(width) + big_endian(height) + kind + "\0\0\0"s;
    return "\x89PNG\r\n\x1a\n" + big_endian(13) + "IHDR" + header + big_endian(checksum) +
           big_endian(0) + "IDAT\x35\xaf\x06\x1e" + big_endian(0) + "IEND\xae\x42\x60\x82";
}

}  // namespace

TEST_CASE("IFF and SGI pictures never reach a reader under any name, however changed",
          "[hostile]") {
    for (std::string file : {iff_file(), sgi_file()})
        for (std::size_t i = 0; i < file.size(); ++i)
            for (const char byte : {'\0', '\x01', '\x7f', '\x80', '\xff'}) {
                const char kept = std::exchange(file[i], byte);
                const std::string error = refusal(file, i % 2 == 0 ? "a.png" : "a.exr");
                file[i] = kept;
                CAPTURE(i, static_cast<int>(byte), error);
                CHECK_THAT(error, Contains(": unknown format (starts with "));
            }
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.hdr", "a.exr", "a.iff", "a.rgb"}) {
        std::ofstream(folder / name, std::ios::binary) << iff_file();
        CHECK_THROWS_WITH(
            read_float_image(folder / name),
            Contains(std::string(name) + ": unknown format (starts with 46 4f 52 34"));
        CHECK_THROWS_WITH(read_png(folder / name), Contains("unknown format"));
    }
}

TEST_CASE("formats that are not on the list are refused by their first bytes", "[hostile]") {
    for (const std::string& magic : {"II*\0"s,
                                     "MM\0*"s,
                                     "\xff\xd8\xff\xe0"s,
                                     "GIF89a"s,
                                     "BM\x36\0"s,
                                     "SDPX"s,
                                     "XPDS"s,
                                     "8BPS"s,
                                     "DDS "s,
                                     "\x53\x80\xf6\x34"s,
                                     "RIFF\0\0\0\0WEBP"s,
                                     "\0\0\x02\0"s,
                                     "FORM"s,
                                     "P7"s,
                                     "P1"s,
                                     "P4"s,
                                     "P2"s,
                                     "P5"s,
                                     "qoif"s,
                                     "\x80\x2a\x5f\xd7"s,
                                     " #?RADIANCE"s,
                                     "\xef\xbb\xbf#?RADIANCE"s,
                                     "\x89PNG\n\x1a\n"s})
        CHECK_THAT(refusal(magic + repeated('x', 64), "a.exr"),
                   Contains("a.exr: unknown format (starts with "));
}

TEST_CASE("a right beginning before another format's bytes goes to that beginning's reader alone",
          "[hostile]") {
    CHECK(refusal("\x89PNG\r\n\x1a\n" + iff_file()) ==
          "a.png: truncated PNG: it ends before its end mark");
    CHECK_THAT(refusal("#?" + iff_file()), Contains("a.png: damaged hdr data"));
    CHECK_THAT(refusal("P6" + sgi_file()), Contains("a.png: ") && Contains("pnm"));
    CHECK_THAT(refusal("\x76\x2f\x31\x01" + iff_file()), Contains("a.png: "));
}

TEST_CASE("an OpenEXR header is held to the file's length and the limits before it is opened",
          "[hostile]") {
    // Without the check OpenEXR allocated 1.7 GB for an attribute of a file of 400 bytes.
    const std::string lying = "a\0b\0"s + little_endian(0x7fffffffU) + "xyz";
    CHECK_THAT(refusal(exr_with(lying)), Contains("truncated: 2147483647 bytes wanted"));
    CHECK_THAT(refusal(exr_with(repeated('n', 300) + "\0int\0"s)), Contains("more than 255 bytes"));
    const std::int32_t most = 2147483647, least = -2147483647 - 1;
    for (const auto& edges : {std::array{0, 0, most, most}, std::array{least, 0, most, 0},
                              std::array{0, 0, 16384, 0}, std::array{0, 0, -1, -1}})
        for (const char* name : {"dataWindow", "displayWindow"})
            CHECK_THAT(refusal(exr_with(attribute(name, "box2i", window(edges)))),
                       Contains("pixels, allowed are 1 to 16384 a side"));
    // OpenEXR reads a window's 16 bytes whatever size the file names.
    CHECK_THAT(refusal(exr_with(attribute("dataWindow", "box2i", "short"))),
               Contains("an attribute of type box2i with 5 bytes, not 16"));
    CHECK_THAT(refusal(exr_with(attribute("dataWindow", "v2f", "12345678"))),
               Contains("truncated"));
    const std::string tiles = little_endian(0xffffffffU) + little_endian(16) + '\0';
    CHECK_THAT(refusal(exr_with(attribute("tiles", "tiledesc", tiles))),
               Contains("tiles of 4294967295 x 16"));
    const std::string preview = little_endian(65536) + little_endian(65536);
    CHECK_THAT(refusal(exr_with(attribute("preview", "preview", preview))),
               Contains("a preview of 65536 x 65536 pixels"));
    std::string channels;
    for (const char c : "ABGRZ"s) channels += std::string(1, c) + '\0' + repeated('\0', 16);
    CHECK_THAT(refusal(exr_with(attribute("channels", "chlist", channels + '\0'))),
               Contains("more than 4 channels"));
    CHECK_THAT(refusal(exr_with(attribute("channels", "chlist", "\0x"s))), Contains("ends early"));
    CHECK_THAT(refusal(exr_with("", 0x802)), Contains("a deep image"));
    CHECK_THAT(refusal(exr_with(attribute("m", "idmanifest", "12345678"))), Contains("idmanifest"));
}

TEST_CASE("a PNG of few bytes cannot ask for more pixels than deflate could give", "[hostile]") {
    // 57 bytes are at most 58,824 bytes of rows: 7,353 pixels of 64 bits.
    CHECK(refusal(png_with(120, 120, "\x10\x06", 0x69f4ea91U)) ==
          "a.png: 120 x 120 pixels do not fit into a file of this length: truncated or damaged");
    CHECK_THAT(refusal(png_with(80, 80, "\x10\x06", 0xde812eeeU)),
               Contains("a.png: truncated or damaged png data"));
    CHECK_THAT(refusal(png_with(20000, 1, "\x01\0"s, 0x13cfa323U)),
               Contains("a.png: 20000 x 1 pixels, allowed are 1 to 16384 a side"));
    CHECK_THAT(refusal(png_with(2147483647, 2147483647, "\x08\x06", 0x14c90b66U)),
               Contains("a.png: "));
    CHECK_THAT(refusal(png_with(0, 0, "\x08\x06", 0x3b8b7c12U)), Contains("damaged png data"));
    CHECK_THAT(refusal(png_with(1, 1, "\x08\x07", 0xa7a9a3ecU)), Contains("damaged png data"));
}

TEST_CASE("a reader's reason is one printable line", "[hostile]") {
    // OpenImageIO reports a damaged stream of rows in two lines.
    const std::string png = png_with(1, 1, "\x08\x02", 0x907753deU);
    for (const std::string& file :
         {png, "#?RADIANCE\nFORMAT=\x1b[31m\n\n-Y 1 +X 1\n"s, "P6\n\x1b[31m"s}) {
        const std::string error = refusal(file);
        CHECK(printable(error, error.size()) == error);
    }
}
