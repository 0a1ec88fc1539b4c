#include "raster/tile_edges.hpp"

#include <cmath>

namespace twofold {
namespace {

/// The least and the greatest value of an edge function in a rectangle.
struct Extent {
    std::int64_t least, greatest;
};

Extent extent(std::int64_t first, std::int64_t dx, std::int64_t dy) {
    return {first + std::min<std::int64_t>(dx, 0) + std::min<std::int64_t>(dy, 0),
            first + std::max<std::int64_t>(dx, 0) + std::max<std::int64_t>(dy, 0)};
}

constexpr std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

}  // namespace

TileEdges edges_in_tile(const TriangleSetup& setup, const PixelRectangle& pixels,
                        int fraction_bits) {
    const std::int64_t one = std::int64_t{1} << fraction_bits;
    const WindowPoint corner{pixels.x0 * one + one / 2, pixels.y0 * one + one / 2};
    const std::int64_t right = pixels.x1 - pixels.x0 - 1, down = pixels.y1 - pixels.y0 - 1;
    TileEdges out;
    out.none_covered = false;
    out.usable = setup.doubled_area < std::int64_t{1} << 52;
    for (std::size_t k = 0; k < 3; ++k) {
        const EdgeFunction& edge = setup.edge[k];
        const std::int64_t value = edge.at(corner);
        // A step of a pixel is a multiple of `one`, so whole ones are enough to know the sign.
        const std::int64_t first = (value - (edge.holds_its_points ? 0 : 1)) >> fraction_bits;
        const Extent inside = extent(first, edge.a * right, edge.b * down);
        if (inside.greatest < 0) out.none_covered = true;
        const std::int64_t reach =
            magnitude(first) + (magnitude(edge.a) + magnitude(edge.b)) * 2 * lanes::tile_edge;
        if (reach >= std::int64_t{1} << (51 - fraction_bits)) out.usable = false;
        out.triangle.e[k] = {static_cast<double>(value), static_cast<double>(edge.a * one),
                             static_cast<double>(edge.b * one)};
        // No branch: which edges cut the rectangle cannot be guessed.
        const std::int64_t cuts = inside.least < 0 ? -1 : 0;
        if ((reach & cuts) >= std::int64_t{1} << 31) out.usable = false;
        out.triangle.cover[k] = {static_cast<std::int32_t>(first & cuts),
                                 static_cast<std::int32_t>(edge.a & cuts),
                                 static_cast<std::int32_t>(edge.b & cuts)};
    }
    return out;
}

bool set_near_depth(const lanes::DepthRule& rule, lanes::Triangle& t) {
    const auto in_range = [](double z) { return z >= 0.0 && z <= 1.0; };
    if (t.dz1 == 0.0 && t.dz2 == 0.0) {
        // The same everywhere, and as far from doubt as can be.
        t.near_depth = {std::floor(t.z0 * rule.steps + rule.half) + 0.5, 0.0, 0.0};
        return rule.steps < 0x1p24 && in_range(t.z0);
    }
    const double columns = t.x1 - t.x0 + static_cast<int>(lanes::widest), rows = t.y1 - t.y0;
    const double per_unit = rule.steps / t.area;
    const auto weighted = [&](double lanes::Plane::*part) {
        return (t.dz1 * t.e[1].*part + t.dz2 * t.e[2].*part) * per_unit;
    };
    t.near_depth = {t.z0 * rule.steps + rule.half + weighted(&lanes::Plane::first),
                    weighted(&lanes::Plane::dx), weighted(&lanes::Plane::dy)};
    const auto largest = [&](std::size_t k, double dz) {
        return std::fabs(dz) * per_unit *
               (std::fabs(t.e[k].first) + std::fabs(t.e[k].dx) * columns +
                std::fabs(t.e[k].dy) * rows);
    };
    // Each rounding strays by 2^-53 of the largest term, and a row has up to 16 steps of a vector.
    return rule.steps < 0x1p24 && in_range(t.z0) && in_range(t.z0 + t.dz1) &&
           in_range(t.z0 + t.dz2) && largest(1, t.dz1) + largest(2, t.dz2) <= 0x1p27;
}

}  // namespace twofold
