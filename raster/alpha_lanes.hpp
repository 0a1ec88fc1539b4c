#pragma once
#include <cstddef>
#include <cstdint>

/// The bounds of alpha_bounds.hpp on vectors of triangles.
namespace twofold::lanes {

/// A grid over an image of width x height texels. count has (columns + 1) x (rows + 1) words, rows
/// bottom up: of the cells of 2^cell_bits texels a side that lie below and left of a corner, those
/// that hold alpha 0 only in the lower 16 bits, those that hold alpha 1 only in the upper.
struct AlphaGrid {
    int width, height, cell_bits, columns;
    const std::uint32_t* count;
    float scale_u = 1.0f, scale_v = 1.0f;  ///< what places are multiplied by to be in the image
};

/// Places of a mesh's vertices in an image, in texels.
struct TexelPlaces {
    const float *u, *v;
};

/// Triangles whose three vertex numbers begin every `stride` words.
struct TriangleList {
    const std::uint32_t* vertex;
    std::size_t stride, size;
};

/// What the lookups of triangles may read: 1 where alpha is 0 in all cells they meet, 2 where it is
/// 1 in all, 0 elsewhere. Places need not be finite: what is found there means nothing.
/// @param known  has room for a full vector behind the last triangle
void find_alphas(const AlphaGrid& grid, const TexelPlaces& places, const TriangleList& triangles,
                 std::uint8_t* known);

}  // namespace twofold::lanes
