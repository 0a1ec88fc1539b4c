#pragma once
#include "raster/lane_batch.hpp"
#include "raster/lane_shader.hpp"
#include "raster/packed_bytes.hpp"

/// The inner loops of the fast pipeline, on vectors as wide as the processor has: plain values in,
/// plain values out. They compute what coverage.hpp, interpolate.hpp, texunit/sample.hpp and the
/// presets' models compute, in the same order, so that the bits are the same.
namespace twofold::lanes {

/// A number that is linear in the window: first + x dx + y dy, x and y in pixels from a triangle's
/// (x0, y0).
struct Plane {
    double first, dx, dy;
};

/// The same as integers: where one of a triangle's three is negative no pixel is covered.
struct CoverEdge {
    std::int32_t first, dx, dy;
};

/// A triangle inside a tile. Doubled areas are integers below 2^52 at every pixel of the tile, so
/// binary64 holds them exactly.
struct Triangle {
    /// 0 for an edge that has all pixels to visit on its inner side.
    std::array<CoverEdge, 3> cover;
    std::array<Plane, 3> e;  ///< doubled areas opposite each vertex
    double area;             ///< the sum of the three
    int x0, y0, x1, y1;      ///< pixels to visit, relative to the tile
    double z0, dz1, dz2;     ///< depth of vertex 0 and what the others have more
    Plane near_depth;        ///< depth in units of the buffer, to 2^-21 if it is usable
    bool near_depth_usable;
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

/// What a fragment has yet to pass when it has been shaded.
struct LateTests {
    CompareFunc alpha = CompareFunc::always;
    std::int32_t alpha_reference = 0;  ///< of 255
    DepthRule depth;                   ///< if it is computed
};

/// What a triangle's corners carry into interpolation, where the mesh keeps it.
template <class Real, class Channel>
struct Corners {
    using Coords = std::array<Real, 4>;                           ///< s, t, r, q
    std::array<std::array<const Coords*, 3>, lane_units> coords;  ///< [unit][vertex]
    std::array<const Color<Channel>*, 3> colors;
    bool over_w;                                ///< coordinates are over w already
    bool one_color;                             ///< all three the same
    std::array<bool, lane_units> choose_level;  ///< whether a unit's fragments do
};
using ByteCorners = Corners<double, int>;
template <class Real>
using RealCorners = Corners<Real, Real>;

/// Sets `size` words to a value.
void fill(std::uint32_t* words, std::size_t size, std::uint32_t value);

/// Where covering a triangle stands: the row to go on with, and the fragments found.
struct Covered {
    int row;
    std::size_t count;
};

/// Covers rows of the tile from `row` until `cover_capacity` pixels are found or the triangle ends,
/// tests and writes depth as the rule says, and puts the fragments behind the first `size` of a
/// batch.
Covered cover(const Triangle& t, const DepthRule& rule, std::uint32_t* depth, int row,
              std::size_t size, BatchPlaces& out);
Covered cover(const Triangle& t, const DepthRule& rule, double* depth, int row, std::size_t size,
              BatchPlaces& out);

/// Chooses levels for the `count` fragments that have their places behind a batch's last and puts
/// down their footprints, for each unit that has levels. Where the corners say that there is no
/// choice the footprints are left to interpolate().
void choose_levels(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                   std::size_t count, ByteBatch& out);
void choose_levels(const Triangle& t, const RealCorners<double>& c, const Shader<Color<double>>& s,
                   std::size_t count, RealBatch<double>& out);
void choose_levels(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                   std::size_t count, RealBatch<float>& out);
void choose_levels(const Triangle& t, const ByteCorners& c, const RoundedShader& s,
                   std::size_t count, RealBatch<double>& out);

/// Adds to a batch the `count` fragments that have their places behind its last: their footprints
/// in the texture of each unit that does not choose levels, and colours.
void interpolate(const Triangle& t, const ByteCorners& c, const Shader<std::uint32_t>& s,
                 std::size_t count, ByteBatch& out);
void interpolate(const Triangle& t, const RealCorners<double>& c, const Shader<Color<double>>& s,
                 std::size_t count, RealBatch<double>& out);
void interpolate(const Triangle& t, const RealCorners<float>& c, const Shader<Color<float>>& s,
                 std::size_t count, RealBatch<float>& out);

/// The same for a preset of integers, which the batch holds as real numbers.
void interpolate(const Triangle& t, const ByteCorners& c, const RoundedShader& s, std::size_t count,
                 RealBatch<double>& out);

/// Looks textures up and combines them with the colours. Real ones are limited to [0, 1], rounded
/// ones to [0, 255].
void shade(const Shader<std::uint32_t>& s, ByteBatch& batch);
void shade(const Shader<Color<double>>& s, RealBatch<double>& batch);
void shade(const Shader<Color<float>>& s, RealBatch<float>& batch);
void shade(const RoundedShader& s, RealBatch<double>& batch);

/// Of `size` shaded fragments, no two of one pixel, moves those that pass the tests to the front,
/// writes their depth, and returns their number. Words of colours have alpha highest.
std::size_t keep_survivors(const LateTests& tests, std::uint32_t* depth, std::size_t size,
                           BatchPlaces& places, std::uint32_t* words);

/// Puts colours to their pixels in their order. The tile's rows lie `stride` pixels apart.
void write_colors(const BatchPlaces& places, const std::uint32_t* words, std::size_t size,
                  std::uint32_t* tile, std::size_t stride);

/// The fragments' shaded colours as bytes: floor(factor x + 1/2).
void round_to_bytes(double factor, RealBatch<double>& batch);

/// The name of the instruction set that was chosen.
const char* instruction_set();

}  // namespace twofold::lanes
