#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/pass.hpp"
#include "texunit/numeric_model.hpp"

/// The inner loops of the fast pipeline, on vectors as wide as the processor has: plain values in,
/// plain values out. They compute what coverage.hpp, interpolate.hpp, texunit/sample.hpp and the
/// presets' models compute, in the same order, so that the bits are the same.
namespace twofold::lanes {

inline constexpr int tile_edge = 64;  ///< pixels
inline constexpr std::size_t tile_pixels = std::size_t{tile_edge} * tile_edge;
inline constexpr std::size_t widest = 16;          ///< lanes that a load or store may run past an end
inline constexpr std::size_t span_capacity = 512;  ///< pixels of a triangle covered at once
inline constexpr std::size_t batch_capacity = 1024;  ///< fragments shaded at once
inline constexpr std::size_t lane_units = 2;         ///< texture units that vectors know

/// A triangle inside a tile. Doubled areas e[k] are integers below 2^52 at every pixel of the tile,
/// so binary64 holds them exactly.
struct Triangle {
    std::array<double, 3> e, dx, dy;  ///< at the centre of pixel (x0, y0); a pixel to the right, below
    std::array<double, 3> least;      ///< 0 where the edge holds its own points, else 1
    double area;                      ///< the sum of the three
    int x0, y0, x1, y1;               ///< pixels to visit, relative to the tile
    double z0, dz1, dz2;              ///< depth of vertex 0 and what the others have more
    std::array<double, 3> inverse_w;
    bool equal_w;
};

/// What is done with a fragment's depth while it is being covered.
struct DepthRule {
    bool computed = false;  ///< there is a depth test
    bool early = false;     ///< it is decided here; otherwise after the fragment was shaded
    CompareFunc func = CompareFunc::always;
    bool write = false;
    double steps = 0.0, half = 0.0;  ///< integer = z steps + half, cut; unused for binary64 depth
};

/// Covered pixels of one triangle, rows from the top, left to right.
template <class Depth>
struct Span {
    std::size_t size = 0;
    alignas(64) std::array<double, span_capacity + 2 * tile_edge> e1, e2;
    alignas(64) std::array<std::uint32_t, span_capacity + 2 * tile_edge> at;  ///< in the tile
    alignas(64) std::array<Depth, span_capacity + 2 * tile_edge> z;           ///< unless early
};

/// Fragments of one pass, perhaps of several triangles.
template <class Real, class Depth>
struct Batch {
    static constexpr std::size_t room = batch_capacity + span_capacity + 2 * tile_edge + 2 * widest;
    std::size_t size = 0;
    alignas(64) std::array<std::uint32_t, room> at;
    alignas(64) std::array<Depth, room> z;
    alignas(64) std::array<std::array<std::array<Real, room>, 3>, lane_units> coords;  ///< s, t, q
    alignas(64) std::array<std::uint32_t, room> bytes;    ///< colours of 8-bit presets, red lowest
    alignas(64) std::array<Color<Real>, room> reals;      ///< colours of the others
};

/// A texture with one texel of surroundings on its left and lower sides and two on the others, as
/// the wrap modes see them: every texel of a footprint is there without a question.
template <class Texel>
struct Image {
    const Texel* texels;
    int width, height;  ///< without surroundings
    int stride;         ///< texels from a row to the next
};

template <class Texel>
struct Unit {
    Image<Texel> image;
    Wrap wrap_s, wrap_t;
    bool linear;
    bool divide_by_q;
    bool in_texels;
    bool replace;  ///< else MODULATE
    int rgb_scale, alpha_scale;
};

template <class Texel>
struct Shader {
    std::size_t units;
    std::array<Unit<Texel>, lane_units> unit;
};

/// What a triangle's corners carry into interpolation.
template <class Real>
struct Corners {
    std::array<std::array<std::array<Real, 3>, 3>, lane_units> coords;  ///< [unit][s, t, q][vertex]
    bool over_w;         ///< coordinates are over w already
    bool one_color;      ///< all three the same
    std::array<Color<int>, 3> bytes;
    std::array<Color<Real>, 3> reals;
};

/// Covers rows of the tile from `row` until the span is full or the triangle ends, tests and writes
/// depth as the rule says, and returns the row to go on with.
int cover(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
          Span<std::uint32_t>& out);
int cover(const Triangle& t, const DepthRule& rule, double* depth, int row, Span<double>& out);

/// Appends a span's fragments to a batch: their coordinates for `units` units, and colours.
void interpolate_bytes(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out);
void interpolate_reals(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<double, std::uint32_t>& out);
void interpolate_reals(const Triangle& t, const Corners<double>& c, std::size_t units,
                       const Span<double>& span, Batch<double, double>& out);
void interpolate_reals(const Triangle& t, const Corners<float>& c, std::size_t units,
                       const Span<std::uint32_t>& span, Batch<float, std::uint32_t>& out);

/// Looks textures up and combines: batch.bytes, or batch.reals (not yet limited to [0, 1]).
void shade(const Shader<std::uint32_t>& s, Batch<double, std::uint32_t>& batch);
void shade(const Shader<Color<double>>& s, Batch<double, std::uint32_t>& batch);
void shade(const Shader<Color<double>>& s, Batch<double, double>& batch);
void shade(const Shader<Color<float>>& s, Batch<float, std::uint32_t>& batch);

/// The fragments' real colours as bytes: floor(255 x + 1/2) of x limited to [0, 1].
void round_to_bytes(Batch<double, std::uint32_t>& batch);

/// The name of the instruction set that was chosen.
const char* instruction_set();

}  // namespace twofold::lanes
