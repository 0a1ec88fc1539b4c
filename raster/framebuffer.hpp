#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/numeric_model.hpp"

namespace twofold {

/// Colour and depth in a preset's formats, rows top down.
template <NumericModel M>
struct RenderTarget {
    int width;
    int height;
    ColorFormat format;
    int depth_bits;
    std::vector<Color<typename M::Pixel>> color;
    std::vector<typename M::Depth> depth;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    Color<typename M::Pixel> color_at(std::size_t i) const { return color[i]; }
    void store_color(std::size_t i, const Color<typename M::Pixel>& c) { color[i] = c; }
    typename M::Depth& depth_at(std::size_t i) { return depth[i]; }
};

/// What happened while drawing, over all passes.
struct DrawCounters {
    std::uint64_t triangles = 0;   ///< submitted
    std::uint64_t rejected = 0;    ///< outside one clip plane
    std::uint64_t not_finite = 0;  ///< dropped for a vertex that is NaN, infinite or beyond 2^64
    std::uint64_t clipped = 0;     ///< cut by a clip plane
    std::uint64_t culled = 0;      ///< facing away, pieces of clipped triangles included
    std::uint64_t zero_area = 0;   ///< without area after the snap
    std::uint64_t set_up = 0;      ///< triangles and pieces that reached coverage
    std::uint64_t fragments = 0;   ///< covered pixels
    std::uint64_t undefined_coords =
        0;  ///< texture coordinates with q = 0 or not finite, read as 0
    std::uint64_t alpha_failed = 0;
    std::uint64_t depth_failed = 0;
    std::uint64_t written = 0;

    bool operator==(const DrawCounters&) const = default;
};

/// A finished picture, in a form that is the same for every preset. Rows top down.
struct Framebuffer {
    int width = 0;
    int height = 0;
    std::vector<Rgba8> bytes;                   ///< what is displayed
    std::vector<std::array<double, 4>> values;  ///< 0..1, as the preset's framebuffer holds them
    DrawCounters counters;
};

}  // namespace twofold
