#include "raster/fast.hpp"

#include <deque>
#include <memory>

#include "raster/alpha_bounds.hpp"
#include "raster/bins.hpp"
#include "raster/first_target.hpp"
#include "raster/frame_check.hpp"
#include "raster/tile.hpp"
#include "raster/vertex_stage.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

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
    std::vector<TriangleBlock<M>> blocks;
    std::vector<GroupAlpha<M>> alphas;
    std::deque<LaneImages<M>> images;
    std::vector<TilePass<M>> passes;
    Bins bins;
    TileMemoryPool<M> pool;
    std::vector<StoredColor<M>> color;  ///< rows top down
};

template <NumericModel M>
LaneShader<M> make_shader(FastState<M>& state, const BoundPass<M>& pass) {
    LaneShader<M> shader{};
    if constexpr (lane_kind<M>() == LaneKind::rounded) shader.rounding = rounding_of(pass.m);
    for (const BoundUnit<M>& unit : pass.units) {
        state.images.push_back(lane_images(pass.m, unit));
        shader.unit[shader.units++] = lane_unit(unit, state.images.back());
    }
    return shader;
}

template <NumericModel M>
lanes::DepthRule depth_rule(const M& m, const PassState& state, int depth_bits) {
    lanes::DepthRule rule;
    if (!state.depth_test) return rule;
    rule.computed = true;
    rule.func = state.depth_test->func;
    rule.write = state.depth_test->write;
    rule.steps = static_cast<double>(m.depth(1.0, depth_bits));
    rule.half = M::is_integer ? 0.0 : 0.5;
    return rule;
}

template <NumericModel M>
TilePass<M> tile_pass(FastState<M>& state, std::size_t pass, std::size_t group, std::size_t member,
                      const std::array<std::size_t, max_units>& set_of) {
    const Frame& frame = state.frame;
    const PassState normal = normalized(frame, frame.passes[pass]);
    BoundPass<M> bound =
        twofold::bind(state.m, normal, frame.color_format, state.textures, state.white);
    const bool known = lanes_know<M>(bound);
    auto shader = known ? make_shader(state, bound) : LaneShader<M>{};
    unsigned bounded_sets = 0, far_q_sets = 0;
    std::array<double, lanes::lane_units> reach{};
    for (std::size_t u = 0; u < shader.units; ++u) reach[u] = only_base_reach(bound.units[u]);
    for (const BoundUnit<M>& unit : bound.units) {
        bounded_sets |= 1u << set_of[unit.index];
        if (unit.state.divide_by_q) far_q_sets |= 1u << set_of[unit.index];
    }
    return {std::move(bound),
            &state.meshes[group],
            group,
            member,
            set_of,
            drawable_pixels(normal, frame.width, frame.height),
            known,
            known && (!shader.unit[0].levels.empty() || !shader.unit[1].levels.empty()),
            bounded_sets,
            far_q_sets,
            shader,
            reach,
            depth_rule(state.m, normal, frame.depth_bits)};
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
            add_pass(state->alphas[g], state->passes.back().bound, set_of);
        }
    }
    state->color.resize(static_cast<std::size_t>(frame.width) *
                        static_cast<std::size_t>(frame.height));
    return state;
}

/// Other values than words are copied from the first ones on: copies use wider stores than fill_n.
template <class T>
void fill(T* first, std::size_t size, const T& value) {
    if constexpr (std::is_same_v<T, std::uint32_t>) return lanes::fill(first, size, value);
    std::size_t done = std::min<std::size_t>(size, 16);
    std::fill_n(first, done, value);
    for (; done < size; done += std::min(done, size - done))
        std::copy_n(first, std::min(done, size - done), first + done);
}

template <NumericModel M>
void clear_tile(FastState<M>& state, const PixelRectangle& area) {
    const auto clear = stored_color<M>(clear_color(state.m, state.frame));
    const auto width = static_cast<std::size_t>(area.x1 - area.x0);
    for (auto y = area.y0; y < area.y1; ++y)
        fill(state.color.data() + y * state.frame.width + area.x0, width, clear);
}

template <NumericModel M>
void start_tile(FastState<M>& state, const PixelRectangle& area, TileMemory<M>& tile) {
    const Frame& frame = state.frame;
    tile.x0 = static_cast<int>(area.x0);
    tile.y0 = static_cast<int>(area.y0);
    tile.format = frame.color_format;
    tile.depth_bits = frame.depth_bits;
    tile.stride = static_cast<std::size_t>(frame.width);
    tile.color = state.color.data() + area.y0 * frame.width + area.x0;
    const auto used = static_cast<std::size_t>(area.y1 - area.y0) * lanes::tile_edge;
    fill(tile.depth.data(), used, state.m.depth(frame.clear_depth, frame.depth_bits));
    if (!frame.initial_color) return clear_tile(state, area);
    for (auto y = area.y0; y < area.y1; ++y)
        for (auto x = area.x0; x < area.x1; ++x)
            tile.store_color(
                tile.index(static_cast<int>(x), static_cast<int>(y)),
                initial_color(state.m, frame, static_cast<std::size_t>(y * frame.width + x)));
}

template <NumericModel M>
void draw_entry(const TilePass<M>& pass, const BinEntry& entry, const PixelRectangle& area,
                TileMemory<M>& tile) {
    const MeshTriangle& triangle = pass.mesh->triangles[entry.triangle];
    const PixelRectangle pixels{std::max({area.x0, pass.pixels.x0, std::int64_t{triangle.x0}}),
                                std::max({area.y0, pass.pixels.y0, std::int64_t{triangle.y0}}),
                                std::min({area.x1, pass.pixels.x1, std::int64_t{triangle.x1}}),
                                std::min({area.y1, pass.pixels.y1, std::int64_t{triangle.y1}})};
    const TileTriangle<M> t{pass, triangle, setup_of(*pass.mesh, triangle), pixels,
                            entry.certain != 0};
    draw_triangle(t, tile);
}

template <NumericModel M>
void draw_tile(FastState<M>& state, std::size_t number) {
    const Frame& frame = state.frame;
    const PixelRectangle area = tile_rectangle(state.bins, number, frame.width, frame.height);
    if (!frame.initial_color && state.bins.is_empty(number)) return clear_tile(state, area);
    auto tile = state.pool.take();
    start_tile(state, area, *tile);
    const TilePass<M>* drawing = nullptr;
    for (std::uint32_t k = state.bins.first[number]; k < state.bins.first[number + 1]; ++k) {
        const BinEntry& entry = state.bins.entries[k];
        const TilePass<M>& pass = state.passes[entry.pass];
        if (drawing && drawing != &pass) flush(*drawing, true, *tile);
        drawing = &pass;
        draw_entry(pass, entry, area, *tile);
    }
    if (drawing) flush(*drawing, true, *tile);
    state.pool.give_back(std::move(tile));
}

template <NumericModel M>
std::vector<BinPass> bin_passes(const FastState<M>& state) {
    std::vector<BinPass> passes;
    for (const TilePass<M>& pass : state.passes)
        passes.push_back({&pass.mesh->triangles, pass.pixels,
                          pass.bound.state.alpha_test.has_value(),
                          &state.alphas[pass.group].outcomes[pass.member]});
    return passes;
}

template <NumericModel M>
void draw_frame(FastState<M>& state) {
    for (std::size_t g = 0; g < state.meshes.size(); ++g) {
        const GroupGeometry<M>& geometry = state.geometry[g];
        place_vertices(state.m, geometry, state.columns[g], state.options.threads, state.meshes[g]);
        place_triangles(state.m, geometry, state.options.threads, state.blocks, state.meshes[g]);
        std::vector<const BoundPass<M>*> passes;
        for (const TilePass<M>& pass : state.passes)
            if (pass.group == g) passes.push_back(&pass.bound);
        find_outcomes(state.meshes[g], passes, state.options.threads, state.alphas[g]);
    }
    fill_bins(bin_passes(state), state.frame.width, state.frame.height, state.bins);
    parallel_for(state.bins.tiles(), state.options.threads,
                 [&](std::size_t k) { draw_tile(state, k); });
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
