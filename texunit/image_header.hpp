#pragma once
#include <cstdint>
#include <span>
#include <string>

/// What is looked at in the bytes of a picture before a reader of OpenImageIO sees them, because
/// the reader would allocate what a header claims, or take a file that lost its end for whole.
namespace twofold {

constexpr int max_picture_side = 16384;
constexpr std::int64_t max_picture_pixels = std::int64_t{1} << 28;
constexpr int max_picture_channels = 4;

/// 1 to max_picture_side each, at most max_picture_pixels.
/// @throws Error(bad_file) naming the file and the size
void check_picture_size(std::int64_t width, std::int64_t height, const std::string& name);

/// libpng stops at the last row, so a file that lost its end would pass: walks the chunks to IEND.
/// @return bits of a pixel as stored, at least 1
/// @throws Error(bad_file)
int check_png(std::span<const unsigned char> bytes, const std::string& name);

/// Walks the attributes of all headers: each must lie within the file, and windows, tiles, channels
/// and preview must keep the limits.
/// @source openexr.com, OpenEXR File Layout
/// @throws Error(bad_file) naming the attribute
void check_openexr(std::span<const unsigned char> bytes, const std::string& name);

}  // namespace twofold
