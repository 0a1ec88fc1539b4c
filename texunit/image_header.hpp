#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// What is looked at in the bytes of a picture before a reader of OpenImageIO sees them, because
/// the reader would allocate what a header claims, or take a file that lost its end for whole.
namespace twofold {

constexpr int max_picture_side = 16384;
constexpr std::int64_t max_picture_pixels = std::int64_t{1} << 28;
constexpr int max_picture_channels = 4;

/// 1 to max_picture_side each, at most max_picture_pixels.
/// @throws Error(bad_file) naming the file and the size
void check_picture_size(std::int64_t width, std::int64_t height, const std::string& name);

/// A format that is read, and how OpenImageIO calls it.
struct PictureFormat {
    std::string_view magic;
    const char* reader;
    /// What its compression can reach at best: a header that claims more pixels than the file can
    /// hold is refused before they are allocated. A Radiance run is 127 pixels in 8 bytes; deflate
    /// reaches 1032 : 1, and what a pixel of a PNG takes is in its header.
    std::int64_t max_pixels_per_byte;
};

/// The format by the file's first bytes, whatever its name ends in.
/// @throws Error(bad_file) naming the file, its first bytes and the formats that are read
const PictureFormat& identify_picture(std::span<const unsigned char> bytes,
                                      const std::string& name);

/// Pixels that the file can hold by its length, after its own headers have been looked at.
/// @throws Error(bad_file)
std::int64_t most_pixels(std::span<const unsigned char> bytes, const PictureFormat& format,
                         const std::string& name);

/// Walks the attributes of all headers: each must lie within the file, and windows, tiles, channels
/// and preview must keep the limits.
/// @source openexr.com, OpenEXR File Layout
/// @throws Error(bad_file) naming the attribute
void check_openexr(std::span<const unsigned char> bytes, const std::string& name);

}  // namespace twofold
