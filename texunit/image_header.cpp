#include "texunit/image_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "texunit/error.hpp"

namespace twofold {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw Error(ExitCode::bad_file, name + ": " + what);
}

/// Samples of a pixel by colour type: grey, RGB, an index, grey and alpha, RGBA.
/// @source PNG 1.2, 4.1.1
int samples_of(int color_type) {
    constexpr std::array<int, 7> samples{1, 0, 3, 1, 2, 0, 4};
    return color_type < 7 ? samples[static_cast<std::size_t>(color_type)] : 0;
}

}  // namespace

void check_picture_size(std::int64_t width, std::int64_t height, const std::string& name) {
    if (width < 1 || height < 1 || width > max_picture_side || height > max_picture_side ||
        width * height > max_picture_pixels)
        fail(name, fmt::format("{} x {} pixels, allowed are 1 to {} a side", width, height,
                               max_picture_side));
}

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

}  // namespace twofold
