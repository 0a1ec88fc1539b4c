#pragma once
#include "raster/coverage.hpp"
#include "raster/lanes.hpp"

/// A triangle's edges as the vector loops take them.
namespace twofold {

/// Edge functions from the first of the pixels to visit on.
struct TileEdges {
    lanes::Triangle triangle;  ///< of which only `cover` and `e` are set
    bool none_covered;         ///< no pixel has its centre inside
    bool usable;  ///< all numbers are exact: 31 bits for coverage, 53 for doubled areas
};

/// The edges of a triangle in a rectangle of pixels that lies in one tile.
TileEdges edges_in_tile(const TriangleSetup& setup, const PixelRectangle& pixels,
                        int fraction_bits);

/// Sets the depth of a triangle as a plane in units of the buffer, and returns whether it is near
/// enough to what divisions give to be of use.
bool set_near_depth(const lanes::DepthRule& rule, lanes::Triangle& t);

}  // namespace twofold
