#pragma once
#include <vector>

#include "texunit/texture.hpp"

namespace twofold {

/// Whether the sides inside the border are powers of two, so that box_mipmaps() can halve them.
/// @param border  0 or 1
bool has_sides_to_halve(int width, int height, int border);

/// Levels 1, 2, ... down to one texel, each the average of 2 x 2 texels of the one above (of 2
/// where that is one texel wide or high), computed in binary64 and stored as binary32. The averages
/// are of the level above before it was stored, so that the last level is the mean of the image.
///
/// A border has its own averages: of two texels along an edge, of a corner itself.
///
/// @param texels  width x height, rows bottom up, border texels included
/// @param border  0 or 1
/// @throws Error unless has_sides_to_halve()
std::vector<TextureImage> box_mipmaps(int width, int height, const Texels& texels, int border);

}  // namespace twofold
