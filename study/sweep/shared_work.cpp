#include "study/sweep/shared_work.hpp"

#include <fmt/format.h>

#include "scenes/exact_picture.hpp"
#include "study/outline.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

bool has_truth(const Scene& scene) {
    return !scene.objects.empty() && scene.passes.empty() && scene.historical.empty();
}

/// The cell under ideal64, drawn the quickest way.
Cell idealised(Cell cell) {
    cell.scene.presets = {Preset::ideal64};
    cell.draw.way = DrawWay::fused;
    return cell;
}

Seconds part_of(Seconds whole, int part, int all) {
    const double share = static_cast<double>(part) / all;
    return {share * whole.processor, share * whole.wall};
}

}  // namespace

template <class T, class Make>
std::shared_ptr<const T> SharedWork::kept(Kept<T>& place, const std::string& key, Make make) {
    if (!place.value || place.key != key) {
        place.value.reset();
        place.took = seconds_of([&] { place.value = std::make_shared<const T>(make()); });
        place.key = key;
    }
    return place.value;
}

std::shared_ptr<const SampledScene> SharedWork::samples_of(const Cell& cell, const CellKeys& keys) {
    return kept(sampled_, keys.lighting, [&] {
        Scene scene = cell.scene;
        scene.factorization.samples = samples_;
        return sample_scene(scene, threads_, listen_);
    });
}

SharedWork::Inputs SharedWork::inputs_of(const Cell& cell) {
    const CellKeys keys = keys_of(cell, files_);
    const int count = cell.scene.factorization.samples;
    Inputs in;
    in.inputs.assets = kept(assets_, keys.assets, [&] { return load_assets(cell.scene); });
    in.inputs.sampled = samples_of(cell, keys);
    in.inputs.white = *kept(white_, keys.lighting, [&] {
        return white_radiance(cell.scene.white,
                              first_samples(*in.inputs.sampled, cell.white_samples).samples);
    });
    in.inputs.materials = std::make_shared<const FactoredMaterials>();
    if (cell.draw.technique != Technique::factored) return in;
    in.lit = kept(lit_, keys.factors, [&] {
        return factor_scene(cell.scene, first_samples(*in.inputs.sampled, count), in.inputs.white,
                            threads_, listen_);
    });
    in.inputs.materials = {in.lit, &in.lit->materials};
    in.sampling = part_of(sampled_.took, count, samples_);
    in.factoring = lit_.took;
    return in;
}

std::shared_ptr<const Framebuffer> SharedWork::truth_of(const Cell& cell,
                                                        const CellInputs& inputs) {
    if (!has_truth(cell.scene)) return nullptr;
    return kept(truth_, keys_of(cell, files_).truth, [&] {
        listen_("exact picture");
        const LitScene lit{inputs.sampled->lights, inputs.white, inputs.sampled->brdfs, {}, {}};
        return exact_picture(cell.scene, *inputs.assets, lit, threads_).picture;
    });
}

std::shared_ptr<const Framebuffer> SharedWork::ideal_of(const Cell& cell,
                                                        const CellInputs& inputs) {
    if (cell.draw.technique == Technique::exact) return nullptr;
    return kept(ideal_, keys_of(cell, files_).ideal, [&] {
        const Cell ideal = idealised(cell);
        const Drawing drawing = prepare(ideal, inputs);
        drawing.draw();
        return drawing.picture();
    });
}

FrameWork SharedWork::work_of(const Cell& cell, const Frame& frame) {
    const Preset preset = cell.scene.presets.front();
    const CustomSettings custom = counted_settings(cell.scene.custom);
    std::string key = keys_of(cell, files_).ideal + std::string(name_of(preset));
    if (preset == Preset::custom)
        key += fmt::format(" {} {} {}", custom.snap_bits, custom.snap_bias,
                           static_cast<int>(custom.product_rounding));
    const auto known = counted_.find(key);
    if (known != counted_.end()) return with_textures_of(known->second, frame);
    return counted_.emplace(key, twofold::work_of(frame, preset, custom)).first->second;
}

std::vector<bool> SharedWork::outline_of(const Cell& cell, const CellInputs& inputs) {
    if (cell.scene.objects.empty() || cell.draw.technique == Technique::exact) return {};
    const Frame frame = make_surface_frame(cell.scene, *inputs.assets);
    const auto fine =
        kept(surface_, keys_of(cell, files_).truth, [&] { return visible_surface(frame); });
    return with_model(cell.scene.presets.front(), cell.scene.custom,
                      [&](const auto& m) { return outline_pixels(frame, *fine, m.snap()); });
}

}  // namespace twofold
