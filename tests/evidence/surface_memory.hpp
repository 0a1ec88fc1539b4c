#pragma once
#include <cstdint>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/texture.hpp"

/// Off-screen targets as bytes in memory, for textures that read those bytes.
namespace twofold::evidence {

/// Bytes of one pixel.
int bytes_per_pixel(ColorFormat format);

/// Rows one behind the other from the top, each pixel a little-endian word with its components in
/// the order a, r, g, b from the high bits down. Alpha of an x format is its unused bits.
std::vector<std::uint8_t> memory_of(const ByteImage& pixels, ColorFormat format);

/// The pixels that `memory_of` would store for `pixels`: what the format has no bits for is lost.
ByteImage as_stored(const ByteImage& pixels, ColorFormat format);

/// The bytes reread as a texture of `format`, from the first one on, its rows without gaps. A
/// texture that is larger than the memory is filled up with zero bytes.
PackedTexels reread(std::vector<std::uint8_t> memory, TextureFormat format, int width, int height);

/// The same texture with red and blue exchanged.
/// @param texels in a format of one word with as many bits for red as for blue
PackedTexels with_red_and_blue_swapped(PackedTexels texels);

}  // namespace twofold::evidence
