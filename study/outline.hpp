#pragma once
#include <vector>

#include "raster/pass.hpp"

namespace twofold {

/// Pixels that see another surface on the 1/16 pixel snap grid of the hardware presets than on
/// ideal64's: the object in place of the background, or the far side of an inner silhouette. Their
/// difference is one of edges, not of colours, and they are counted apart. Triangles that share a
/// corner are one surface.
/// @param frame one plain pass an object (make_surface_frame)
/// @return one value a pixel, rows top down
std::vector<bool> outline_pixels(const Frame& frame);

}  // namespace twofold
