#include "raster/fast.hpp"

#include <deque>
#include <memory>

#include "raster/alpha_bounds.hpp"
#include "raster/first_target.hpp"
#include "raster/frame_check.hpp"
#include "raster/tile.hpp"
#include "raster/vertex_stage.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

/// A triangle that a pass draws into a tile.
struct BinEntry {
    std::uint32_t triangle;  ///< of the pass's mesh
    std::uint16_t pass;
    bool certain;  ///< its alpha test is known to pass
};

/// The entries of all tiles one after the other, in drawing order within a tile.
struct Bins {
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> first;  ///< of each tile, and the end
    std::vector<BinEntry> entries;
};

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

/// A frame on its way through the fast pipeline, with all memory that the next frame can use again.
template <NumericModel M>
struct FastState {
    FastState(const M& model, const Frame& f, FastOptions o)
        : m(model), frame(f), options(o), white(white_texture(model)) {}

    M m;
    const Frame& frame;
    FastOptions options;
    std::vector<UploadedTexture<M>> textures;
    UploadedTexture<M> white;
    std::vector<GroupGeometry<M>> geometry;
    std::vector<VertexColumns> columns;  ///< one per group, and so on
    std::vector<WindowMesh<M>> meshes;
    std::vector<GroupAlpha<M>> alphas;
    std::deque<std::vector<LaneTexel<M>>> images;
    std::vector<TilePass<M>> passes;
    Bins bins;
    TileMemoryPool<M> pool;
    std::vector<StoredColor<M>> color;  ///< rows top down

    /// What a pass's alpha test does with each triangle of its mesh; empty if nothing is known.
    const std::vector<AlphaOutcome>& outcomes(const TilePass<M>& pass) const {
        static const std::vector<AlphaOutcome> unknown;
        const auto& of_group = alphas[pass.group].outcomes;
        return pass.member < of_group.size() ? of_group[pass.member] : unknown;
    }
};

template <NumericModel M>
lanes::Shader<LaneTexel<M>> make_shader(FastState<M>& state, const BoundPass<M>& pass) {
    lanes::Shader<LaneTexel<M>> shader{};
    for (const BoundUnit<M>& unit : pass.units) {
        state.images.push_back(surrounded<M>(unit.texture->levels[0], unit));
        shader.unit[shader.units++] = lane_unit<M>(unit, state.images.back().data());
    }
    return shader;
}

template <NumericModel M>
lanes::DepthRule depth_rule(const PassState& state, int depth_bits) {
    lanes::DepthRule rule;
    if (!state.depth_test) return rule;
    rule.computed = true;
    rule.func = state.depth_test->func;
    rule.write = state.depth_test->write;
    rule.steps = static_cast<double>((std::uint64_t{1} << depth_bits) - 1);
    rule.half = lane_kind<M>() == LaneKind::reals ? 0.5 : 0.0;
    return rule;
}

bool writes_plainly(const PassState& state, ColorFormat format) {
    return !state.blend && format == ColorFormat::rgba8888 &&
           state.color_mask == PassState{}.color_mask;
}

template <NumericModel M>
TilePass<M> tile_pass(FastState<M>& state, std::size_t pass, std::size_t group, std::size_t member,
                      const std::array<std::size_t, max_units>& set_of) {
    const Frame& frame = state.frame;
    const PassState normal = normalized(frame.passes[pass].state);
    BoundPass<M> bound = twofold::bind(state.m, normal, state.textures, state.white);
    const bool known = lanes_know<M>(bound);
    auto shader = known ? make_shader(state, bound) : lanes::Shader<LaneTexel<M>>{};
    return {std::move(bound),
            &state.meshes[group],
            group,
            member,
            set_of,
            drawable_pixels(normal, frame.width, frame.height),
            known,
            shader,
            depth_rule<M>(normal, frame.depth_bits),
            writes_plainly(normal, frame.color_format)};
}

template <NumericModel M>
std::shared_ptr<FastState<M>> make_state(const M& m, const Frame& frame, FastOptions options) {
    auto state = std::make_shared<FastState<M>>(m, frame, options);
    for (const Texture& t : frame.textures) state->textures.push_back(upload(m, t));
    const auto groups = group_passes(frame, options.fuse);
    state->meshes.resize(groups.size());
    state->columns.resize(groups.size());
    state->alphas.resize(groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        state->geometry.push_back(group_geometry(m, frame, groups[g]));
        make_columns(m, state->geometry[g], state->columns[g]);
        color_vertices(m, state->geometry[g], state->meshes[g]);
        for (std::size_t k = 0; k < groups[g].passes.size(); ++k) {
            const auto& set_of = groups[g].set_of[k];
            state->passes.push_back(tile_pass(*state, groups[g].passes[k], g, k, set_of));
            if (lane_kind<M>() != LaneKind::none)
                add_pass(state->alphas[g], state->passes.back().bound, set_of);
        }
    }
    state->color.resize(static_cast<std::size_t>(frame.width) *
                        static_cast<std::size_t>(frame.height));
    return state;
}

/// Calls visit(tile number, entry) for every triangle of every pass, in drawing order.
template <NumericModel M, class Visit>
void for_each_entry(const FastState<M>& state, Visit&& visit) {
    for (std::size_t p = 0; p < state.passes.size(); ++p) {
        const TilePass<M>& pass = state.passes[p];
        const auto& triangles = pass.mesh->triangles;
        const bool certain = !pass.bound.state.alpha_test;
        const auto& outcomes = state.outcomes(pass);
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            const AlphaOutcome outcome = outcomes.empty() ? AlphaOutcome::open : outcomes[k];
            if (outcome == AlphaOutcome::fails) continue;
            const BinEntry entry{static_cast<std::uint32_t>(k), static_cast<std::uint16_t>(p),
                                 certain || outcome == AlphaOutcome::passes};
            const TileRange r = tiles_of(triangles[k], pass.pixels);
            for (int y = r.y0; y < r.y1; ++y)
                for (int x = r.x0; x < r.x1; ++x)
                    visit(static_cast<std::size_t>(y * state.bins.columns + x), entry);
        }
    }
}

/// Sorts all triangles of all passes into tiles: counts, then places.
template <NumericModel M>
void fill_bins(FastState<M>& state) {
    Bins& bins = state.bins;
    const auto tiles = [](int pixels) { return (pixels + lanes::tile_edge - 1) / lanes::tile_edge; };
    bins.columns = tiles(state.frame.width);
    bins.rows = tiles(state.frame.height);
    bins.first.assign(static_cast<std::size_t>(bins.columns * bins.rows) + 2, 0);
    for_each_entry(state, [&](std::size_t tile, const BinEntry&) { ++bins.first[tile + 2]; });
    for (std::size_t k = 2; k < bins.first.size(); ++k) bins.first[k] += bins.first[k - 1];
    bins.entries.resize(bins.first.back());
    for_each_entry(state, [&](std::size_t tile, const BinEntry& entry) {
        bins.entries[bins.first[tile + 1]++] = entry;
    });
}

/// The part of the picture that a tile is.
PixelRectangle tile_rectangle(const Bins& bins, std::size_t tile, const Frame& frame) {
    const auto column = static_cast<int>(tile) % bins.columns;
    const auto row = static_cast<int>(tile) / bins.columns;
    const int x0 = column * lanes::tile_edge, y0 = row * lanes::tile_edge;
    return {x0, y0, std::min(frame.width, x0 + lanes::tile_edge),
            std::min(frame.height, y0 + lanes::tile_edge)};
}

template <NumericModel M>
void start_tile(const FastState<M>& state, const PixelRectangle& area, TileMemory<M>& tile) {
    const Frame& frame = state.frame;
    tile.x0 = static_cast<int>(area.x0);
    tile.y0 = static_cast<int>(area.y0);
    tile.format = frame.color_format;
    tile.depth_bits = frame.depth_bits;
    tile.depth.fill(state.m.depth(frame.clear_depth, frame.depth_bits));
    if (!frame.initial_color) {
        tile.color.fill(stored_color<M>(clear_color(state.m, frame)));
        return;
    }
    for (auto y = area.y0; y < area.y1; ++y)
        for (auto x = area.x0; x < area.x1; ++x)
            tile.store_color(tile.index(static_cast<int>(x), static_cast<int>(y)),
                             initial_color(state.m, frame, static_cast<std::size_t>(y * frame.width + x)));
}

template <NumericModel M>
void finish_tile(FastState<M>& state, const PixelRectangle& area, const TileMemory<M>& tile) {
    const auto width = static_cast<std::size_t>(area.x1 - area.x0);
    for (auto y = area.y0; y < area.y1; ++y) {
        const std::size_t from = static_cast<std::size_t>(y - area.y0) * lanes::tile_edge;
        const std::size_t to = static_cast<std::size_t>(y * state.frame.width + area.x0);
        std::copy_n(tile.color.begin() + static_cast<std::ptrdiff_t>(from), width,
                    state.color.begin() + static_cast<std::ptrdiff_t>(to));
    }
}

template <NumericModel M>
void draw_entry(const TilePass<M>& pass, const BinEntry& entry, const PixelRectangle& area,
                TileMemory<M>& tile) {
    const MeshTriangle& triangle = pass.mesh->triangles[entry.triangle];
    const auto point = [&](std::size_t k) {
        const PlacedVertex<M>& v = pass.mesh->vertices[triangle.vertex[k]];
        return WindowPoint{v.x, v.y};
    };
    const PixelRectangle pixels{
        std::max({area.x0, pass.pixels.x0, std::int64_t{triangle.x0}}),
        std::max({area.y0, pass.pixels.y0, std::int64_t{triangle.y0}}),
        std::min({area.x1, pass.pixels.x1, std::int64_t{triangle.x1}}),
        std::min({area.y1, pass.pixels.y1, std::int64_t{triangle.y1}})};
    const TileTriangle<M> t{pass, triangle, set_up({point(0), point(1), point(2)}), pixels,
                            entry.certain};
    draw_triangle(t, tile);
}

/// Nothing is drawn into the tile, and it starts from one colour.
template <NumericModel M>
bool is_empty(const FastState<M>& state, std::size_t tile) {
    return !state.frame.initial_color && state.bins.first[tile] == state.bins.first[tile + 1];
}

template <NumericModel M>
void clear_tile(FastState<M>& state, const PixelRectangle& area) {
    const auto clear = stored_color<M>(clear_color(state.m, state.frame));
    for (auto y = area.y0; y < area.y1; ++y)
        std::fill_n(state.color.begin() + static_cast<std::ptrdiff_t>(y * state.frame.width + area.x0),
                    area.x1 - area.x0, clear);
}

template <NumericModel M>
void draw_tile(FastState<M>& state, std::size_t number) {
    const PixelRectangle area = tile_rectangle(state.bins, number, state.frame);
    if (is_empty(state, number)) return clear_tile(state, area);
    auto tile = state.pool.take();
    start_tile(state, area, *tile);
    const TilePass<M>* drawing = nullptr;
    for (std::uint32_t k = state.bins.first[number]; k < state.bins.first[number + 1]; ++k) {
        const BinEntry& entry = state.bins.entries[k];
        const TilePass<M>& pass = state.passes[entry.pass];
        if constexpr (lane_kind<M>() != LaneKind::none)
            if (drawing && drawing != &pass) flush(*drawing, true, *tile);
        drawing = &pass;
        draw_entry(pass, entry, area, *tile);
    }
    if constexpr (lane_kind<M>() != LaneKind::none)
        if (drawing) flush(*drawing, true, *tile);
    finish_tile(state, area, *tile);
    state.pool.give_back(std::move(tile));
}

template <NumericModel M>
void draw_frame(FastState<M>& state) {
    for (std::size_t g = 0; g < state.meshes.size(); ++g) {
        const GroupGeometry<M>& geometry = state.geometry[g];
        place_vertices(state.m, geometry, state.columns[g], state.options.threads, state.meshes[g]);
        place_triangles(state.m, geometry, state.options.threads, state.meshes[g]);
        std::vector<const BoundPass<M>*> passes;
        for (const TilePass<M>& pass : state.passes)
            if (pass.group == g) passes.push_back(&pass.bound);
        find_outcomes(state.meshes[g], passes, state.alphas[g]);
    }
    fill_bins(state);
    const auto tiles = static_cast<std::size_t>(state.bins.columns * state.bins.rows);
    parallel_for(tiles, state.options.threads, [&](std::size_t k) { draw_tile(state, k); });
}

template <NumericModel M>
Framebuffer picture_of(const FastState<M>& state) {
    Framebuffer result{state.frame.width, state.frame.height, {}, {}, {}};
    result.bytes.reserve(state.color.size());
    result.values.reserve(state.color.size());
    for (const StoredColor<M>& stored : state.color)
        append_pixel(state.m, pixel_color<M>(stored), result);
    return result;
}

}  // namespace

FastFrame prepare_fast(const Frame& frame, Preset preset, const CustomSettings& custom,
                       FastOptions options) {
    check_frame(frame);
    return with_model(preset, custom, [&](const auto& m) {
        const auto state = make_state(m, frame, options);
        return FastFrame{[state] { draw_frame(*state); }, [state] { return picture_of(*state); }};
    });
}

Framebuffer render_fast(const Frame& frame, Preset preset, const CustomSettings& custom,
                        FastOptions options) {
    const FastFrame fast = prepare_fast(frame, preset, custom, options);
    fast.draw();
    return fast.picture();
}

}  // namespace twofold
