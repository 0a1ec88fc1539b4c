#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "raster/fragment.hpp"
#include "raster/tile_edges.hpp"
#include "raster/tile_triangle.hpp"

/// A square of the picture with everything that is drawn into it. One thread owns a tile from its
/// clear colour to its last pass.
namespace twofold {

/// A colour as the fast pipeline's framebuffer holds it: a word of bytes, red lowest, or numbers.
template <NumericModel M>
using StoredColor = std::conditional_t<std::is_integral_v<typename M::Pixel>, std::uint32_t,
                                       Color<typename M::Pixel>>;

template <NumericModel M>
StoredColor<M> stored_color(const Color<typename M::Pixel>& c) {
    if constexpr (std::is_integral_v<typename M::Pixel>)
        return packed_bytes(c);
    else
        return c;
}

template <NumericModel M>
Color<typename M::Pixel> pixel_color(const StoredColor<M>& c) {
    if constexpr (std::is_integral_v<typename M::Pixel>)
        return unpacked_bytes(c);
    else
        return c;
}

template <NumericModel M>
using LaneBatch = std::conditional_t<lane_kind<M>() == LaneKind::bytes, lanes::ByteBatch,
                                     lanes::RealBatch<typename M::Real>>;

/// What a thread needs to draw a tile. Colours go to the picture, depth is the tile's own.
template <NumericModel M>
struct TileMemory {
    using Depth = typename M::Depth;
    int x0 = 0, y0 = 0;
    ColorFormat format{};
    int depth_bits = 24;
    StoredColor<M>* color = nullptr;  ///< of the tile's first pixel
    std::size_t stride = 0;           ///< pixels from a row of the picture to the next
    alignas(64) std::array<Depth, lanes::tile_pixels + lanes::widest> depth;
    LaneBatch<M> batch{};

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * lanes::tile_edge +
               static_cast<std::size_t>(x - x0);
    }
    StoredColor<M>& stored_at(std::size_t i) const {
        return color[(i >> lanes::tile_edge_bits) * stride + i % lanes::tile_edge];
    }
    Color<typename M::Pixel> color_at(std::size_t i) const { return pixel_color<M>(stored_at(i)); }
    void store_color(std::size_t i, const Color<typename M::Pixel>& c) {
        stored_at(i) = stored_color<M>(c);
    }
    Depth& depth_at(std::size_t i) { return depth[i]; }
};

/// Memory for as many tiles as are being drawn at once, kept from frame to frame.
template <NumericModel M>
class TileMemoryPool {
  public:
    std::unique_ptr<TileMemory<M>> take() {
        const std::lock_guard lock(mutex_);
        // Not filled with zeros; libc++ 14 has no make_unique_for_overwrite.
        if (free_.empty()) return std::unique_ptr<TileMemory<M>>(new TileMemory<M>);
        auto memory = std::move(free_.back());
        free_.pop_back();
        return memory;
    }
    void give_back(std::unique_ptr<TileMemory<M>> memory) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(memory));
    }

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<TileMemory<M>>> free_;
};

/// The triangle as the vector loops take it: all but its edges.
template <NumericModel M>
void add_corners(const TileTriangle<M>& t, const TileMemory<M>& tile, lanes::Triangle& out) {
    out.area = static_cast<double>(t.setup.doubled_area);
    out.x0 = static_cast<int>(t.pixels.x0) - tile.x0;
    out.y0 = static_cast<int>(t.pixels.y0) - tile.y0;
    out.x1 = static_cast<int>(t.pixels.x1) - tile.x0;
    out.y1 = static_cast<int>(t.pixels.y1) - tile.y0;
    for (std::size_t k = 0; k < 3; ++k)
        out.inverse_w[k] = static_cast<double>(corner(t, k).inverse_w);
    out.equal_w = out.inverse_w[0] == out.inverse_w[1] && out.inverse_w[1] == out.inverse_w[2];
    if (t.pass.depth.computed) add_depth(t, out);
}

/// The colour of fragment i of a batch that has been shaded.
template <NumericModel M>
const StoredColor<M>& shaded_color(const TileMemory<M>& tile, std::size_t i) {
    if constexpr (lane_kind<M>() != LaneKind::bytes && std::is_integral_v<typename M::Pixel>)
        return tile.batch.rounded[i];
    else
        return tile.batch.color[i];
}

/// Finishes a shaded fragment: the tests that are left, the blend and the write.
template <NumericModel M>
void finish_fragment(const TilePass<M>& pass, std::size_t i, bool certain, TileMemory<M>& tile) {
    const auto at = static_cast<std::size_t>(tile.batch.places.at[i]);
    const StoredColor<M>& color = shaded_color(tile, i);
    const auto depth = [&] { return static_cast<typename M::Depth>(tile.batch.places.z[i]); };
    DrawCounters ignored;
    if (!certain && !survives(pass.bound, pixel_color<M>(color)[3], at, depth, tile, ignored))
        return;
    if (pass.bound.plain_write)
        tile.stored_at(at) = color;
    else
        write_color(pass.bound, pixel_color<M>(color),
                    tile.x0 + static_cast<int>(at % lanes::tile_edge),
                    tile.y0 + static_cast<int>(at / lanes::tile_edge), tile);
}

/// Finishes shaded fragments of one colour word each, which replaces what was there.
template <NumericModel M>
void finish_words(const TilePass<M>& pass, bool certain, std::uint32_t* words,
                  TileMemory<M>& tile) {
    auto& batch = tile.batch;
    if (!certain) {
        const auto& alpha = pass.bound.state.alpha_test;
        const lanes::LateTests tests{alpha ? alpha->func : CompareFunc::always,
                                     pass.bound.alpha_reference, pass.depth};
        batch.size =
            lanes::keep_survivors(tests, tile.depth.data(), batch.size, batch.places, words);
    }
    lanes::write_colors(batch.places, words, batch.size, tile.color, tile.stride);
}

/// Finishes shaded fragments in their order.
template <NumericModel M>
void finish_batch(const TilePass<M>& pass, bool certain, TileMemory<M>& tile) {
    auto& batch = tile.batch;
    if constexpr (std::is_integral_v<typename M::Pixel>) {
        if constexpr (lane_kind<M>() != LaneKind::bytes)
            lanes::round_to_bytes(255.0 / static_cast<double>(pass.bound.m.one()), batch);
        if (pass.bound.plain_write) {
            if constexpr (lane_kind<M>() != LaneKind::bytes)
                return finish_words(pass, certain, batch.rounded.data(), tile);
            else
                return finish_words(pass, certain, batch.color.data(), tile);
        }
    }
    if (certain && pass.bound.plain_write)
        for (std::size_t i = 0; i < batch.size; ++i)
            tile.stored_at(static_cast<std::size_t>(batch.places.at[i])) = shaded_color(tile, i);
    else
        for (std::size_t i = 0; i < batch.size; ++i) finish_fragment(pass, i, certain, tile);
}

/// Shades the batch's fragments and finishes them in their order.
/// @param certain  they have passed the alpha test, and the depth test if the rule decides early;
///     otherwise they are of one triangle
template <NumericModel M>
void flush(const TilePass<M>& pass, bool certain, TileMemory<M>& tile) {
    auto& batch = tile.batch;
    if (batch.size == 0) return;
    lanes::shade(pass.shader, batch);
    finish_batch(pass, certain, tile);
    batch.size = 0;
}

/// Covers a triangle on vectors and queues its fragments. Those that replace a pixel without a
/// question wait for more of their kind; the others are finished triangle by triangle, because they
/// look at what is there.
template <NumericModel M>
void draw_on_lanes(const TileTriangle<M>& t, const lanes::Triangle& edges, TileMemory<M>& tile) {
    lanes::DepthRule rule = t.pass.depth;
    rule.early = rule.computed && t.certain;
    const bool waits = t.certain && t.pass.bound.plain_write;
    if (!waits) flush(t.pass, true, tile);
    const auto corners = lane_corners(t);
    for (int row = edges.y0; row < edges.y1;) {
        const lanes::Covered covered =
            lanes::cover(edges, rule, tile.depth.data(), row, tile.batch.size, tile.batch.places);
        row = covered.row;
        if (covered.count == 0) continue;
        if (t.pass.has_levels)
            lanes::choose_levels(edges, corners, t.pass.shader, covered.count, tile.batch);
        lanes::interpolate(edges, corners, t.pass.shader, covered.count, tile.batch);
        if (!waits || tile.batch.size >= lanes::batch_capacity) flush(t.pass, t.certain, tile);
    }
}

/// Draws a triangle of a pass into a tile.
template <NumericModel M>
void draw_triangle(const TileTriangle<M>& t, TileMemory<M>& tile) {
    const int bits = t.pass.bound.m.snap().fraction_bits;
    TileEdges edges = edges_in_tile(t.setup, t.pixels, bits);
    if (edges.none_covered) return;
    if (edges.usable && on_lanes(t)) {
        add_corners(t, tile, edges.triangle);
        return draw_on_lanes(t, edges.triangle, tile);
    }
    flush(t.pass, true, tile);
    const WindowTriangle<M> triangle = window_triangle(*t.pass.mesh, t.triangle, t.pass.set_of);
    DrawCounters ignored;
    for_each_covered_pixel(t.setup, bits, t.pixels, [&](int x, int y, const EdgeValues& edge) {
        draw_fragment(t.pass.bound, {x, y, triangle, t.setup, edge}, tile, ignored);
    });
}

}  // namespace twofold
