#include "raster/bins.hpp"

#include <algorithm>

#include "raster/lanes.hpp"

namespace twofold {
namespace {

/// The tiles that a rectangle of pixels meets.
struct TileRange {
    int x0, y0, x1, y1;
};

TileRange tiles_of(const MeshTriangle& t, const PixelRectangle& pixels) {
    const auto tile = [](std::int64_t pixel) { return static_cast<int>(pixel / lanes::tile_edge); };
    const auto x0 = std::max<std::int64_t>(t.x0, pixels.x0);
    const auto y0 = std::max<std::int64_t>(t.y0, pixels.y0);
    const auto x1 = std::min<std::int64_t>(t.x1, pixels.x1);
    const auto y1 = std::min<std::int64_t>(t.y1, pixels.y1);
    if (x0 >= x1 || y0 >= y1) return {0, 0, 0, 0};
    return {tile(x0), tile(y0), tile(x1 - 1) + 1, tile(y1 - 1) + 1};
}

/// Calls visit(tile number, entry) for every triangle of every pass, in drawing order.
template <class Visit>
void for_each_entry(const std::vector<BinPass>& passes, int columns, Visit&& visit) {
    for (std::size_t p = 0; p < passes.size(); ++p) {
        const BinPass& pass = passes[p];
        for (std::size_t k = 0; k < pass.triangles->size(); ++k) {
            const AlphaOutcome outcome =
                pass.outcomes->empty() ? AlphaOutcome::open : (*pass.outcomes)[k];
            if (outcome == AlphaOutcome::fails) continue;
            const bool certain = !pass.tests_alpha || outcome == AlphaOutcome::passes;
            const BinEntry entry{static_cast<std::uint32_t>(k),
                                 static_cast<std::uint32_t>(p) & 0x7fffffffu, certain ? 1u : 0u};
            const TileRange r = tiles_of((*pass.triangles)[k], pass.pixels);
            for (int y = r.y0; y < r.y1; ++y)
                for (int x = r.x0; x < r.x1; ++x)
                    visit(static_cast<std::size_t>(y * columns + x), entry);
        }
    }
}

}  // namespace

void fill_bins(const std::vector<BinPass>& passes, int width, int height, Bins& bins) {
    const auto tiles = [](int n) { return (n + lanes::tile_edge - 1) / lanes::tile_edge; };
    bins.columns = tiles(width);
    bins.rows = tiles(height);
    // Counts first, then places: first[t + 1] runs from the beginning of tile t to its end.
    auto& first = bins.first;
    first.assign(bins.tiles() + 2, 0);
    for_each_entry(passes, bins.columns,
                   [&](std::size_t tile, const BinEntry&) { ++first[tile + 2]; });
    for (std::size_t k = 2; k < first.size(); ++k) first[k] += first[k - 1];
    bins.entries.resize(first.back());
    for_each_entry(passes, bins.columns, [&](std::size_t tile, const BinEntry& entry) {
        bins.entries[first[tile + 1]++] = entry;
    });
}

PixelRectangle tile_rectangle(const Bins& bins, std::size_t tile, int width, int height) {
    const int x0 = static_cast<int>(tile) % bins.columns * lanes::tile_edge;
    const int y0 = static_cast<int>(tile) / bins.columns * lanes::tile_edge;
    return {x0, y0, std::min(width, x0 + lanes::tile_edge),
            std::min(height, y0 + lanes::tile_edge)};
}

}  // namespace twofold
