#pragma once
#include <vector>

#include "raster/visible_surface.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// Pixels that see another surface on a preset's snap grid than on ideal64's: the object in place
/// of the background, or the far side of an inner silhouette. Their difference is one of edges, not
/// of colours, and they are counted apart. Triangles that share a corner are one surface.
/// @param frame one plain pass an object (make_surface_frame)
/// @param fine  the frame's surface on ideal64's grid
/// @return one value a pixel, rows top down
std::vector<bool> outline_pixels(const Frame& frame, const VisibleSurface& fine, SnapRule snap);

/// The picture as if nothing were drawn at the pixels of the outline, so that they count as
/// differing in coverage.
ByteImage without_outline(ByteImage picture, const std::vector<bool>& outline);

}  // namespace twofold
