#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/lane_shader.hpp"

/// Fragments on their way through the vector loops.
namespace twofold::lanes {

inline constexpr int tile_edge_bits = 7;
inline constexpr int tile_edge = 1 << tile_edge_bits;  ///< pixels
inline constexpr std::size_t tile_pixels = std::size_t{tile_edge} * tile_edge;
inline constexpr std::size_t widest = 16;  ///< lanes that a load or store may run past an end
inline constexpr std::size_t cover_capacity = 192;  ///< pixels of a triangle covered at once
inline constexpr std::size_t batch_capacity = 256;  ///< fragments shaded at once

inline constexpr std::size_t batch_room =
    batch_capacity + cover_capacity + 2 * tile_edge + 2 * widest;
template <class T>
using BatchColumn = std::array<T, batch_room>;

/// Where a batch's fragments lie: triangle after triangle, rows from the top, left to right.
struct BatchPlaces {
    alignas(64) BatchColumn<std::int32_t> at;  ///< number of the pixel in the tile
    alignas(64)
        BatchColumn<double> z;  ///< as the depth buffer holds it, unless it was decided early
};

/// A unit's footprints in its texture: the offset of the lesser texel and the weights of the next
/// ones in 1/256, the second from bit 16 on.
struct ByteFootprints {
    alignas(64) BatchColumn<std::int32_t> offset;
    alignas(64) BatchColumn<std::uint32_t> weights;
};

/// Fragments of one pass, perhaps of several triangles, of an 8-bit preset: colours have red in the
/// lowest byte.
struct ByteBatch {
    std::size_t size = 0;
    BatchPlaces places;
    std::array<ByteFootprints, lane_units> fine;
    /// Of units that choose levels: the second footprint, and what it gives in 1/256; 0 of it is
    /// given by none.
    std::array<ByteFootprints, lane_units> coarse;
    alignas(64) std::array<BatchColumn<std::uint32_t>, lane_units> coarse_share;
    alignas(64) BatchColumn<std::uint32_t> color;
};

template <class Real>
struct RealFootprints {
    alignas(64) BatchColumn<std::int32_t> offset;
    alignas(64) BatchColumn<Real> a, b;
};

/// The same of a preset that computes in real numbers.
template <class Real>
struct RealBatch {
    std::size_t size = 0;
    BatchPlaces places;
    std::array<RealFootprints<Real>, lane_units> fine, coarse;
    alignas(64) std::array<BatchColumn<Real>, lane_units> coarse_share;
    alignas(64) BatchColumn<Color<Real>> color;
    alignas(64) BatchColumn<std::uint32_t> rounded;  ///< by round_to_bytes()
};

/// Vectors that reach behind the last fragment find addresses there, too.
template <class Shader, class Batch>
void end_with_addresses(const Shader& s, Batch& batch) {
    const auto end = [&](BatchColumn<std::int32_t>& offset) {
        for (std::size_t i = batch.size; i < batch.size + widest; ++i) offset[i] = 0;
    };
    for (std::size_t u = 0; u < s.units; ++u) {
        end(batch.fine[u].offset);
        if (s.unit[u].rule.blends) end(batch.coarse[u].offset);
    }
}

}  // namespace twofold::lanes
