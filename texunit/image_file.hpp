#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "texunit/texture.hpp"

/// Image files. The format is chosen by the first bytes alone, never by the name, from a list of
/// four: OpenImageIO would try all its readers on a strange file, and some of them crash
/// (docs/exactness.md, section 8). Sizes are checked before anything is allocated: 1 to 16384 a
/// side, 2^28 pixels, 1 to 4 channels.
namespace twofold {

/// A picture and what the user should be told about it.
struct ReadImage {
    FloatImage image;
    std::vector<std::string> notes;  ///< each a sentence without the file's name
};

/// Reads Radiance HDR, OpenEXR, PFM, PPM or PNG.
/// Values are as stored: NaN, Inf and negative numbers are kept, an EXPOSURE of an HDR file is
/// reported and never divided by, integers become v / 255 or v / 65535 without any curve, alpha is
/// not multiplied in. The scale of a PFM file is multiplied in, as that format says.
/// @throws Error(bad_file) naming the file and what is wrong with it.
ReadImage decode_float_image(std::span<const unsigned char> bytes, const std::string& name);
ReadImage read_float_image(const std::filesystem::path& path);

/// Reads a PNG of 8 bits a channel (or fewer) as RGBA: RGB gets alpha 255, grey is spread over r, g
/// and b.
/// @throws Error(bad_file) naming the file and what is wrong with it; 16 bits a channel are
/// refused.
ByteImage decode_png(std::span<const unsigned char> bytes, const std::string& name);
ByteImage read_png(const std::filesystem::path& path);

/// A PNG of 8-bit RGBA, never premultiplied. Same picture, same bytes (for one release of zlib).
/// The bytes are decoded again and compared, because OpenImageIO reports success on failed writes.
/// @throws Error(failure) if the picture is inconsistent, Error(bad_file) if encoding failed.
std::vector<unsigned char> encode_png(const ByteImage& image);

/// An OpenEXR file of binary32 channels, ZIP compressed, with the date pinned to 1970; checked in
/// the same way. Every bit pattern is kept, NaN, -0 and denormals included.
/// @throws Error(failure) if the picture is inconsistent, Error(bad_file) if encoding failed.
std::vector<unsigned char> encode_exr(const FloatImage& image);

}  // namespace twofold
