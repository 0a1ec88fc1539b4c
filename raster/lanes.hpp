#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/pass.hpp"
#include "raster/packed_bytes.hpp"
#include "texunit/numeric_model.hpp"

/// The inner loops of the fast pipeline, on vectors as wide as the processor has: plain values in,
/// plain values out. They compute what coverage.hpp, interpolate.hpp, texunit/sample.hpp and the
/// presets' models compute, in the same order, so that the bits are the same.
namespace twofold::lanes {

inline constexpr int tile_edge_bits = 7;
inline constexpr int tile_edge = 1 << tile_edge_bits;  ///< pixels
inline constexpr std::size_t tile_pixels = std::size_t{tile_edge} * tile_edge;
inline constexpr std::size_t widest = 16;          ///< lanes that a load or store may run past an end
inline constexpr std::size_t lane_units = 2;         ///< texture units that vectors know
inline constexpr std::size_t cover_capacity = 192;   ///< pixels of a triangle covered at once
inline constexpr std::size_t batch_capacity = 256;  ///< fragments shaded at once

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
    std::array<CoverEdge, 3> cover;  ///< 0 for an edge that has all pixels to visit on its inner side
    std::array<Plane, 3> e;          ///< doubled areas opposite each vertex
    double area;                     ///< the sum of the three
    int x0, y0, x1, y1;              ///< pixels to visit, relative to the tile
    double z0, dz1, dz2;             ///< depth of vertex 0 and what the others have more
    Plane near_depth;                ///< depth in units of the buffer, to 2^-21 if it is usable
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

inline constexpr std::size_t batch_room = batch_capacity + cover_capacity + 2 * tile_edge + 2 * widest;
template <class T>
using BatchColumn = std::array<T, batch_room>;

/// Where a batch's fragments lie: triangle after triangle, rows from the top, left to right.
struct BatchPlaces {
    alignas(64) BatchColumn<std::int32_t> at;  ///< number of the pixel in the tile
    alignas(64) BatchColumn<double> z;         ///< as the depth buffer holds it, unless it was decided early
};

/// Fragments of one pass, perhaps of several triangles, of an 8-bit preset: colours have red in the
/// lowest byte; a unit's footprint is the offset of its lesser texel and the weights of the next
/// ones in 1/256, the second from bit 16 on.
struct ByteBatch {
    std::size_t size = 0;
    BatchPlaces places;
    alignas(64) std::array<BatchColumn<std::int32_t>, lane_units> offset;
    alignas(64) std::array<BatchColumn<std::uint32_t>, lane_units> weights;
    alignas(64) BatchColumn<std::uint32_t> color;
};

/// The same of a preset that computes in real numbers.
template <class Real>
struct RealBatch {
    std::size_t size = 0;
    BatchPlaces places;
    alignas(64) std::array<BatchColumn<std::int32_t>, lane_units> offset;
    alignas(64) std::array<BatchColumn<Real>, lane_units> a, b;
    alignas(64) BatchColumn<Color<Real>> color;
    alignas(64) BatchColumn<std::uint32_t> rounded;  ///< by round_to_bytes()
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
    /// What of s, t, r, q makes places in 1/256 texel, with LINEAR from the centre of texel (0, 0):
    /// the coordinate times `scale`, less q times `shift`.
    std::array<double, 4> scale, shift;
};

template <class Texel>
struct Shader {
    std::size_t units;
    std::array<Unit<Texel>, lane_units> unit;
};

/// How a preset of integers rounds. Its numbers have at most 24 bits and the filter's weights 16,
/// so that binary64 holds sums and products exactly until they are rounded.
struct Rounding {
    bool cuts_colors;     ///< colours are iterated as Coarse8's, else as Nv17's
    double weight_steps;  ///< the filter's weights are cut to 1 / weight_steps
    bool filters_once;    ///< the four weights at once, else along s, then along t
    double filter_half;   ///< added before the filter cuts
    struct Quotient {
        double add, factor;
        double identity;  ///< the b that leaves a alone; not 1.0 everywhere
    } product;            ///< a b becomes floor((a b + add) factor)
    double one;           ///< 1.0 in the texture units
    /// A colour c becomes c finish_factor, then floor(that + finish_half) if it rounds.
    double finish_factor, finish_half;
    bool finish_rounds;
};

struct RoundedShader : Shader<Color<double>> {
    Rounding rounding;
};

/// What a triangle's corners carry into interpolation, where the mesh keeps it.
template <class Real, class Channel>
struct Corners {
    using Coords = std::array<Real, 4>;                              ///< s, t, r, q
    std::array<std::array<const Coords*, 3>, lane_units> coords;  ///< [unit][vertex]
    std::array<const Color<Channel>*, 3> colors;
    bool over_w;     ///< coordinates are over w already
    bool one_color;  ///< all three the same
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

/// Adds to a batch the `count` fragments that have their places behind its last: their footprints
/// in each unit's texture, and colours.
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
