#include "raster/reference.hpp"

#include "raster/assemble.hpp"
#include "raster/bind.hpp"
#include "raster/coverage.hpp"
#include "raster/first_target.hpp"
#include "raster/fragment.hpp"
#include "raster/frame_check.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

template <NumericModel M>
void draw_pass(const BoundPass<M>& pass, const Mesh& mesh, RenderTarget<M>& target,
               DrawCounters& counters) {
    const WindowRules rules =
        window_rules(pass.state, {target.width, target.height}, pass.m.snap());
    const auto vertices = transform_mesh<typename M::Vertex>(pass.state, mesh, rules.viewport);
    const auto triangles = assemble(mesh.primitive, mesh.indices, pass.state.provoking_vertex);
    const PixelRectangle pixels = drawable_pixels(pass.state, target.width, target.height);
    const int bits = pass.m.snap().fraction_bits;
    for_each_window_triangle(
        pass.m, vertices, triangles, rules, counters,
        [&](std::size_t, const WindowTriangle<M>& triangle, const TriangleSetup& setup) {
            for_each_covered_pixel(setup, bits, pixels, [&](int x, int y, const EdgeValues& edge) {
                draw_fragment(pass, {x, y, triangle, setup, edge}, target, counters);
            });
        });
}

template <NumericModel M>
std::vector<Color<typename M::Pixel>> first_colors(const M& m, const Frame& frame) {
    const std::size_t size =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    std::vector<Color<typename M::Pixel>> colors(size, clear_color(m, frame));
    if (frame.initial_color)
        for (std::size_t i = 0; i < size; ++i) colors[i] = initial_color(m, frame, i);
    return colors;
}

template <NumericModel M>
RenderTarget<M> first_target(const M& m, const Frame& frame) {
    auto colors = first_colors(m, frame);
    const auto depth = m.depth(frame.clear_depth, frame.depth_bits);
    const std::size_t size = colors.size();
    return {frame.width,      frame.height,      frame.color_format,
            frame.depth_bits, std::move(colors), std::vector<typename M::Depth>(size, depth)};
}

template <NumericModel M>
Framebuffer finished(const M& m, const RenderTarget<M>& target, const DrawCounters& counters) {
    Framebuffer result{target.width, target.height, {}, {}, counters};
    result.bytes.reserve(target.color.size());
    result.values.reserve(target.color.size());
    for (const auto& c : target.color) append_pixel(m, c, result);
    return result;
}

template <NumericModel M>
Framebuffer render(const M& m, const Frame& frame) {
    std::vector<UploadedTexture<M>> textures;
    for (const Texture& t : frame.textures) textures.push_back(upload(m, t));
    const UploadedTexture<M> white = white_texture(m);
    RenderTarget<M> target = first_target(m, frame);
    DrawCounters counters;
    for (const Pass& pass : frame.passes)
        draw_pass(twofold::bind(m, normalized(pass.state), frame.color_format, textures, white),
                  frame.meshes[pass.mesh], target, counters);
    return finished(m, target, counters);
}

}  // namespace

Framebuffer render_reference(const Frame& frame, Preset preset, const CustomSettings& custom) {
    check_frame(frame);
    return with_model(preset, custom, [&](const auto& m) { return render(m, frame); });
}

}  // namespace twofold
