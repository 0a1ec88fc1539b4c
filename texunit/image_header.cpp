#include "texunit/image_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

namespace twofold {
namespace {

constexpr std::array<PictureFormat, 7> formats{{{"#?", "hdr", 16},
                                                {"\x76\x2f\x31\x01", "openexr", 1032},
                                                {"\x89PNG\r\n\x1a\n", "png", 1032},
                                                {"PF", "pnm", 1},
                                                {"Pf", "pnm", 1},
                                                {"P6", "pnm", 1},
                                                {"P3", "pnm", 1}}};

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw Error(ExitCode::bad_file, name + ": " + what);
}

/// Samples of a pixel by colour type: grey, RGB, an index, grey and alpha, RGBA.
/// @source PNG 1.2, 4.1.1
int samples_of(int color_type) {
    constexpr std::array<int, 7> samples{1, 0, 3, 1, 2, 0, 4};
    return color_type < 7 ? samples[static_cast<std::size_t>(color_type)] : 0;
}

/// libpng stops at the last row, so a file that lost its end would pass: walks the chunks to IEND.
/// @return bits of a pixel as stored, at least 1
int check_png(std::span<const unsigned char> bytes, const std::string& name) {
    std::size_t at = 8;
    while (bytes.size() - at >= 12) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
        if (length > bytes.size() - at - 12) break;
        // IHDR is the first chunk and has the depth and the colour type at its bytes 8 and 9.
        if (std::memcmp(&bytes[at + 4], "IEND", 4) == 0 && at >= 33)
            return std::max(1, bytes[24] * samples_of(bytes[25]));
        at += length + 12;
    }
    fail(name, "truncated PNG: it ends before its end mark");
}

bool starts_with(std::span<const unsigned char> bytes, std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

std::string first_bytes(std::span<const unsigned char> bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size() && i < 8; ++i)
        text += fmt::format("{}{:02x}", i == 0 ? "" : " ", bytes[i]);
    return text;
}

}  // namespace

void check_picture_size(std::int64_t width, std::int64_t height, const std::string& name) {
    if (width < 1 || height < 1 || width > max_picture_side || height > max_picture_side ||
        width * height > max_picture_pixels)
        fail(name, fmt::format("{} x {} pixels, allowed are 1 to {} a side", width, height,
                               max_picture_side));
}

const PictureFormat& identify_picture(std::span<const unsigned char> bytes,
                                      const std::string& name) {
    if (bytes.empty()) fail(name, "empty file");
    if (is_git_lfs_pointer(bytes))
        fail(name, "a Git LFS pointer instead of the picture; fetch it with 'git lfs pull'");
    for (const PictureFormat& format : formats)
        if (starts_with(bytes, format.magic)) return format;
    fail(name, "unknown format (starts with " + first_bytes(bytes) +
                   "); readable are HDR, OpenEXR, PFM, PPM and PNG");
}

std::int64_t most_pixels(std::span<const unsigned char> bytes, const PictureFormat& format,
                         const std::string& name) {
    const std::string_view reader = format.reader;
    const std::int64_t most = static_cast<std::int64_t>(bytes.size()) * format.max_pixels_per_byte;
    if (reader == "openexr") check_openexr(bytes, name);
    return reader == "png" ? 8 * most / check_png(bytes, name) : most;
}

}  // namespace twofold
