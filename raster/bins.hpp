#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/alpha_outcome.hpp"
#include "raster/coverage.hpp"
#include "raster/mesh_triangle.hpp"

/// Which triangles are drawn into which tile.
namespace twofold {

/// A triangle that a pass draws into a tile.
struct BinEntry {
    std::uint32_t triangle;     ///< of the pass's mesh
    std::uint32_t pass : 31;    ///< in the order in which they are drawn
    std::uint32_t certain : 1;  ///< its alpha test is known to pass
};

/// The entries of all tiles one after the other, in drawing order within a tile.
struct Bins {
    int columns = 0, rows = 0;         ///< tiles
    std::vector<std::uint32_t> first;  ///< entry of each tile, and the end
    std::vector<BinEntry> entries;

    std::size_t tiles() const { return static_cast<std::size_t>(columns * rows); }
    bool is_empty(std::size_t tile) const { return first[tile] == first[tile + 1]; }
};

/// What a pass has to draw.
struct BinPass {
    const std::vector<MeshTriangle>* triangles;
    PixelRectangle pixels;  ///< that the pass may change
    bool tests_alpha;
    const std::vector<AlphaOutcome>* outcomes;  ///< of the triangles; empty if nothing is known
};

/// Sorts the triangles of all passes into the tiles of a picture; `bins` keeps its memory.
void fill_bins(const std::vector<BinPass>& passes, int width, int height, Bins& bins);

/// The part of the picture that a tile is.
PixelRectangle tile_rectangle(const Bins& bins, std::size_t tile, int width, int height);

}  // namespace twofold
