#include "raster/reference.hpp"

#include "raster/assemble.hpp"
#include "raster/coverage.hpp"
#include "raster/fragment_ops.hpp"
#include "raster/frame_check.hpp"
#include "raster/interpolate.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

/// A texture unit that is on, with what it reads.
template <NumericModel M>
struct BoundUnit {
    TextureUnitState state;
    const UploadedTexture<M>* texture;
    Color<typename M::Channel> border;
    std::size_t index;  ///< 0 or 1
};

/// Everything that is the same for all fragments of a pass.
template <NumericModel M>
struct BoundPass {
    PassState state;
    std::vector<BoundUnit<M>> units;
    typename M::Pixel alpha_reference;
};

template <NumericModel M>
bool undefined(const ProjectiveCoordinates<typename M::Real>& at) {
    const auto u = at.s / at.q, v = at.t / at.q;
    return at.q == 0 || !(u - u == 0) || !(v - v == 0);
}

/// MODULATE and RGB_SCALE of one unit. @source OpenGL 1.3, table 3.22 (RGBA) and 3.8.12
template <NumericModel M>
Color<typename M::Channel> combine(const Color<typename M::Channel>& previous,
                                   const Color<typename M::Channel>& texel, int rgb_scale) {
    Color<typename M::Channel> result;
    for (std::size_t c = 0; c < 4; ++c) result[c] = M::modulate(previous[c], texel[c]);
    if (rgb_scale != 1)
        for (std::size_t c = 0; c < 3; ++c) result[c] = M::scale(result[c], rgb_scale);
    return result;
}

/// The texture units in order: unit 1 takes the colour that unit 0 leaves.
template <NumericModel M>
Color<typename M::Pixel> textured_color(const BoundPass<M>& pass, const WindowTriangle<M>& triangle,
                                        const std::array<std::int64_t, 3>& edge,
                                        DrawCounters& counters) {
    Color<typename M::Channel> color = interpolate_color<M>(edge, triangle);
    for (const BoundUnit<M>& unit : pass.units) {
        const auto at = interpolate_coords<M>(edge, triangle, unit.index);
        if (undefined<M>(at)) ++counters.undefined_coords;
        color = combine<M>(color, sample<M>(*unit.texture, unit.state, at, unit.border),
                           unit.state.rgb_scale);
    }
    return {M::finish(color[0]), M::finish(color[1]), M::finish(color[2]), M::finish(color[3])};
}

template <NumericModel M>
void write_color(const PassState& state, const Color<typename M::Pixel>& source,
                 Color<typename M::Pixel>& destination) {
    const auto result = state.blend ? blended<M>(*state.blend, source, destination) : source;
    for (std::size_t c = 0; c < 4; ++c)
        if (state.color_mask[c]) destination[c] = result[c];
}

/// A fragment's whole life: texture units, alpha test, depth test, blend, write. One that fails a
/// test changes nothing; without a depth test the depth buffer is not written.
template <NumericModel M>
void draw_fragment(const BoundPass<M>& pass, const WindowTriangle<M>& triangle, int x, int y,
                   const std::array<std::int64_t, 3>& edge, RenderTarget<M>& target,
                   DrawCounters& counters) {
    ++counters.fragments;
    const auto source = textured_color<M>(pass, triangle, edge, counters);

    const auto& alpha = pass.state.alpha_test;
    if (alpha && !compare(alpha->func, source[3], pass.alpha_reference)) {
        ++counters.alpha_failed;
        return;
    }
    const std::size_t i = target.index(x, y);
    if (const auto& depth = pass.state.depth_test) {
        const auto z = M::depth(interpolate_depth<M>(edge, triangle));
        if (!compare(depth->func, z, target.depth[i])) {
            ++counters.depth_failed;
            return;
        }
        if (depth->write) target.depth[i] = z;
    }
    write_color<M>(pass.state, source, target.color[i]);
    ++counters.written;
}

template <NumericModel M>
void draw_pass(const BoundPass<M>& pass, const Mesh& mesh, RenderTarget<M>& target,
               DrawCounters& counters) {
    const Viewport viewport = viewport_of(target.width, target.height, M::snap);
    const auto constants = vertex_constants<typename M::Vertex>(pass.state, viewport);
    std::vector<ClipVertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        vertices.push_back(transform_vertex<typename M::Vertex>(constants, pass.state, mesh, i));
    for_each_window_triangle<M>(
        vertices, mesh.indices, viewport, pass.state.cull, counters,
        [&](std::size_t, const WindowTriangle<M>& triangle, const TriangleSetup& setup) {
            for_each_covered_pixel(setup, M::snap.fraction_bits, target.width, target.height,
                                   [&](int x, int y, const std::array<std::int64_t, 3>& edge) {
                                       draw_fragment<M>(pass, triangle, x, y, edge, target,
                                                        counters);
                                   });
        });
}

template <NumericModel M>
BoundPass<M> bind(const PassState& state, const std::vector<UploadedTexture<M>>& textures,
                  const UploadedTexture<M>& white) {
    BoundPass<M> bound{state, {}, M::pixel(state.alpha_test ? state.alpha_test->reference : 0.0)};
    for (std::size_t u = 0; u < 2; ++u) {
        if (!state.units[u]) continue;
        const TextureUnitState& unit = *state.units[u];
        const Vec4 b = unit.border_color;
        const Rgba32f border{static_cast<float>(b.x), static_cast<float>(b.y),
                             static_cast<float>(b.z), static_cast<float>(b.w)};
        bound.units.push_back(
            {unit, unit.texture ? &textures[*unit.texture] : &white, M::texel(border), u});
    }
    return bound;
}

template <NumericModel M>
RenderTarget<M> cleared_target(const Frame& frame) {
    const Vec4& c = frame.clear_color;
    const Color<typename M::Pixel> color{M::pixel(c.x), M::pixel(c.y), M::pixel(c.z),
                                         M::pixel(c.w)};
    const std::size_t size =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    return {frame.width, frame.height, std::vector<Color<typename M::Pixel>>(size, color),
            std::vector<typename M::Depth>(size, M::depth(frame.clear_depth))};
}

template <NumericModel M>
Framebuffer finished(const RenderTarget<M>& target, const DrawCounters& counters) {
    Framebuffer result{target.width, target.height, {}, {}, counters};
    result.bytes.reserve(target.color.size());
    result.values.reserve(target.color.size());
    for (const auto& c : target.color) {
        result.bytes.push_back(
            {M::to_unorm8(c[0]), M::to_unorm8(c[1]), M::to_unorm8(c[2]), M::to_unorm8(c[3])});
        result.values.push_back(
            {M::to_real(c[0]), M::to_real(c[1]), M::to_real(c[2]), M::to_real(c[3])});
    }
    return result;
}

template <NumericModel M>
Framebuffer render(const Frame& frame) {
    std::vector<UploadedTexture<M>> textures;
    for (const Texture& t : frame.textures) textures.push_back(upload<M>(t));
    const UploadedTexture<M> white{1, 1, {M::texel(Rgba8{255, 255, 255, 255})}};
    RenderTarget<M> target = cleared_target<M>(frame);
    DrawCounters counters;
    for (const Pass& pass : frame.passes)
        draw_pass<M>(bind<M>(normalized(pass.state), textures, white), frame.meshes[pass.mesh],
                     target, counters);
    return finished<M>(target, counters);
}

}  // namespace

Framebuffer render_reference(const Frame& frame, Preset preset) {
    check_frame(frame);
    return with_model(preset, [&]<class M>(M) { return render<M>(frame); });
}

}  // namespace twofold
