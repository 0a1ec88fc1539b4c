#include "study/sweep/drawing.hpp"

#include "raster/fast.hpp"
#include "raster/reference.hpp"
#include "scenes/box_mipmaps.hpp"
#include "scenes/exact_picture.hpp"
#include "scenes/vertex_lighting.hpp"

namespace twofold {
namespace {

constexpr int one_thread = 1;

void give_mipmaps(Texture& texture) {
    if (!texture.mipmaps.empty() || std::holds_alternative<PackedTexels>(texture.texels)) return;
    texture.mipmaps = box_mipmaps(texture.width, texture.height, texture.texels, texture.border);
    for (TextureFace& face : texture.cube_faces)
        face.mipmaps = box_mipmaps(face.width, face.height, face.texels, texture.border);
}

void set_filter(TextureUnitState& unit, TexelFilter filter) {
    const Filter texels = filter == TexelFilter::nearest ? Filter::nearest : Filter::linear;
    unit.min_filter = unit.mag_filter = texels;
    unit.mip_filter = filter == TexelFilter::trilinear ? MipFilter::linear : MipFilter::off;
}

/// Keeps the last picture of a way of drawing that returns one.
Drawing drawing_of(std::shared_ptr<const Frame> frame, std::function<Framebuffer()> render) {
    auto last = std::make_shared<Framebuffer>();
    return {std::move(frame), [render, last] { *last = render(); }, [last] { return *last; }};
}

Drawing prepare_exact(const Cell& cell, const CellInputs& inputs) {
    return drawing_of(nullptr, [&cell, &inputs] {
        const LitScene lit{inputs.sampled->lights, inputs.white, inputs.sampled->brdfs, {}, {}};
        return exact_picture(cell.scene, *inputs.assets, lit, one_thread).picture;
    });
}

Frame vertex_frame(const Cell& cell, const CellInputs& in) {
    if (cell.draw.technique == Technique::vertex_sum)
        return make_vertex_sum_frame(cell.scene, *in.assets, *in.sampled, in.white, one_thread);
    return make_vertex_lights_frame(cell.scene, *in.assets, *in.sampled, in.white,
                                    cell.draw.lights);
}

/// The light at the vertices depends on the view: it is part of every frame.
Drawing prepare_vertex_lit(const Cell& cell, const CellInputs& inputs) {
    const Preset preset = cell.scene.presets.front();
    return drawing_of(std::make_shared<Frame>(vertex_frame(cell, inputs)), [=, &cell, &inputs] {
        return render_fast(vertex_frame(cell, inputs), preset, cell.scene.custom);
    });
}

Drawing prepare_passes(const Cell& cell, const CellInputs& inputs) {
    const Preset preset = cell.scene.presets.front();
    const CustomSettings custom = cell.scene.custom;
    auto frame = std::make_shared<const Frame>(with_filter(
        make_frame(cell.scene, *inputs.assets, *inputs.materials, preset), cell.draw.filter));
    if (cell.draw.way == DrawWay::reference)
        return drawing_of(frame, [=] { return render_reference(*frame, preset, custom); });
    const FastFrame fast =
        prepare_fast(*frame, preset, custom, {one_thread, cell.draw.way == DrawWay::fused});
    return {frame, [frame, fast] { fast.draw(); }, fast.picture};
}

}  // namespace

Frame with_filter(Frame frame, TexelFilter filter) {
    if (filter == TexelFilter::linear) return frame;
    if (filter == TexelFilter::trilinear)
        for (Texture& texture : frame.textures) give_mipmaps(texture);
    for (Pass& pass : frame.passes)
        for (auto& unit : pass.state.units)
            if (unit) set_filter(*unit, filter);
    return frame;
}

Drawing prepare(const Cell& cell, const CellInputs& inputs) {
    switch (cell.draw.technique) {
        case Technique::exact:
            return prepare_exact(cell, inputs);
        case Technique::vertex_sum:
        case Technique::vertex_lights:
            return prepare_vertex_lit(cell, inputs);
        case Technique::factored:
            break;
    }
    return prepare_passes(cell, inputs);
}

}  // namespace twofold
