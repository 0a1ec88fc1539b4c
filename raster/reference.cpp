#include "raster/reference.hpp"

#include "raster/assemble.hpp"
#include "raster/bind.hpp"
#include "raster/color_format.hpp"
#include "raster/coverage.hpp"
#include "raster/fragment_ops.hpp"
#include "raster/frame_check.hpp"
#include "raster/shade.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

/// Blends, cuts to the format's bits and writes. A target of 16 bits cuts the source before the
/// blend too; what it stores enters with zero low bits. Missing alpha reads 1.
/// @source captures of NV2A for the order of cut and blend
template <NumericModel M>
void write_color(const BoundPass<M>& pass, Color<typename M::Pixel> source, int x, int y,
                 RenderTarget<M>& target) {
    const M& m = pass.m;
    Color<typename M::Pixel>& stored = target.color[target.index(x, y)];
    const FormatBits format = bits_of(target.format);
    source = pass.state.dither ? dithered(m, source, format, x, y) : cut(m, source, format);
    if (pass.state.blend) {
        auto destination = stored;
        if (!format.has_alpha) destination[3] = m.pixel(1.0);
        source =
            cut(m, blended(m, *pass.state.blend, {source, destination, pass.blend_color}), format);
    }
    if (!format.has_alpha) source[3] = m.pixel(format.stored_alpha);
    for (std::size_t c = 0; c < 4; ++c)
        if (pass.state.color_mask[c]) stored[c] = source[c];
}

/// A fragment's whole life: colour, alpha test, depth test, blend, write. One that fails a test
/// changes nothing; without a depth test the depth buffer is not written.
template <NumericModel M>
void draw_fragment(const BoundPass<M>& pass, const Fragment<M>& f, RenderTarget<M>& target,
                   DrawCounters& counters) {
    ++counters.fragments;
    const auto source = shade(pass, f, counters);

    const auto& alpha = pass.state.alpha_test;
    if (alpha && !compare(alpha->func, source[3], pass.alpha_reference)) {
        ++counters.alpha_failed;
        return;
    }
    if (const auto& depth = pass.state.depth_test) {
        auto& stored = target.depth[target.index(f.x, f.y)];
        const auto z = pass.m.depth(interpolate_depth<M>(f.edge, f.triangle), target.depth_bits);
        if (!compare(depth->func, z, stored)) {
            ++counters.depth_failed;
            return;
        }
        if (depth->write) stored = z;
    }
    write_color(pass, source, f.x, f.y, target);
    ++counters.written;
}

PixelRectangle drawable_pixels(const PassState& state, int width, int height) {
    if (!state.scissor) return {0, 0, width, height};
    const Scissor& s = *state.scissor;
    return {std::max(0, s.x), std::max(0, s.y),
            std::min<std::int64_t>(width, std::int64_t{s.x} + s.width),
            std::min<std::int64_t>(height, std::int64_t{s.y} + s.height)};
}

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
    const FormatBits format = bits_of(frame.color_format);
    if (!frame.initial_color)
        return std::vector<Color<typename M::Pixel>>(
            size, cut(m, pixels_of(m, frame.clear_color), format));
    std::vector<Color<typename M::Pixel>> colors;
    colors.reserve(size);
    for (const Rgba8 p : frame.initial_color->pixels)
        colors.push_back(cut(m, pixels_of(m, Vec4{p.r, p.g, p.b, p.a} / 255.0), format));
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
    for (const auto& c : target.color) {
        result.bytes.push_back(
            {m.to_unorm8(c[0]), m.to_unorm8(c[1]), m.to_unorm8(c[2]), m.to_unorm8(c[3])});
        result.values.push_back(
            {m.to_real(c[0]), m.to_real(c[1]), m.to_real(c[2]), m.to_real(c[3])});
    }
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
        draw_pass(bind(m, normalized(pass.state), textures, white), frame.meshes[pass.mesh], target,
                  counters);
    return finished(m, target, counters);
}

}  // namespace

Framebuffer render_reference(const Frame& frame, Preset preset, const CustomSettings& custom) {
    check_frame(frame);
    return with_model(preset, custom, [&](const auto& m) { return render(m, frame); });
}

}  // namespace twofold
