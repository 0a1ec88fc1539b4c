#include "study/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>

#include "raster/renderer.hpp"
#include "scenes/object_passes.hpp"
#include "study/outline.hpp"
#include "study/pictures.hpp"
#include "texunit/presets.hpp"

namespace twofold {
namespace {

/// Passes the step names on and keeps the time between them.
class StepClock {
  public:
    StepClock(std::vector<RunStep>& steps, const StepListener& listen)
        : steps_(steps), listen_(listen) {}

    void begin(const std::string& name) {
        end();
        steps_.push_back({name, 0.0});
        started_ = std::chrono::steady_clock::now();
        if (listen_) listen_(name);
    }
    void end() {
        if (!started_) return;
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - *started_;
        steps_.back().seconds = taken.count();
        started_.reset();
    }

  private:
    std::vector<RunStep>& steps_;
    const StepListener& listen_;
    std::optional<std::chrono::steady_clock::time_point> started_;
};

void draw_exact(RunResult& run, const SceneAssets& assets, int threads) {
    ExactPicture exact = exact_picture(run.scene, assets, run.lit, threads);
    run.turned_away = exact.turned_away;
    run.pictures.push_back({"exact", std::move(exact.picture)});
}

void draw_preset(RunResult& run, const SceneAssets& assets, int threads, Preset preset) {
    const Frame frame = make_frame(run.scene, assets, run.lit.materials, preset);
    run.pictures.push_back({std::string(name_of(preset)),
                            render(frame, preset, run.scene.custom, {run.pipeline, threads})});
}

/// The outline pixels of each preset's picture. A scene without objects has none, nor has exact,
/// which is on ideal64's snap grid.
std::map<std::string, std::vector<bool>> outlines_of(const Scene& scene,
                                                     const SceneAssets& assets) {
    std::map<std::string, std::vector<bool>> outlines;
    if (scene.objects.empty()) return outlines;
    const Frame frame = make_surface_frame(scene, assets);
    const VisibleSurface fine = visible_surface(frame);
    for (const Preset preset : scene.presets)
        outlines[std::string(name_of(preset))] =
            with_model(preset, scene.custom,
                       [&](const auto& m) { return outline_pixels(frame, fine, m.snap()); });
    return outlines;
}

/// Whether there is more to see than objects.
bool draws_more(const Scene& scene) { return !scene.passes.empty() || !scene.historical.empty(); }

/// Every picture against exact, and every other against ideal64. The exact picture knows nothing of
/// explicit passes: a scene that has them is not compared with it.
void compare_all(RunResult& run, std::map<std::string, std::vector<bool>> outlines) {
    for (const char* reference : {"exact", "ideal64"}) {
        if (std::string_view(reference) == "exact" && draws_more(run.scene)) continue;
        for (const RunPicture& a : run.pictures)
            for (const RunPicture& b : run.pictures)
                if (b.name == reference && a.name != "exact" && a.name != reference)
                    run.comparisons.push_back(
                        {a.name, b.name,
                         difference_where_covered(
                             without_outline(byte_image(a.picture), outlines[a.name]),
                             byte_image(b.picture))});
    }
}

/// A channel without any light: nothing was solved for it.
void note_black_channels(RunResult& run) {
    for (const auto& [name, lighting] : run.lit.materials)
        for (std::size_t c = 0; c < 3; ++c)
            if (lighting.terms[0].c[static_cast<int>(c)] == 0.0)
                run.notes.push_back(fmt::format(
                    "{}: {} is black everywhere: factors 0, scale 0, no logarithm taken", name,
                    channel_name(c)));
}

/// What a material has beyond two fitted maps.
void note_methods(RunResult& run) {
    for (const auto& [name, lighting] : run.lit.materials) {
        if (!lighting.closed_form.empty())
            run.notes.push_back(fmt::format("{}: in closed form ({}), nothing was fitted", name,
                                            lighting.closed_form));
        run.notes.push_back(fmt::format("{}: model {}, {} products, {} passes", name,
                                        name_of(lighting.model), lighting.terms.size(),
                                        pass_count(lighting)));
        if (!lighting.terms[0].view.empty())
            run.notes.push_back(
                fmt::format("{}: g(n.v), {} knots, is multiplied into the vertex colours", name,
                            lighting.terms[0].view.size()));
    }
}

bool is_empty(const RunPicture& picture) {
    return std::ranges::none_of(picture.picture.bytes, [](Rgba8 pixel) { return pixel.a != 0; });
}

/// Of pictures that show nothing, all of them or some.
void warn_of_empty(RunResult& run) {
    if (std::ranges::all_of(run.pictures, is_empty)) {
        run.warnings.push_back("no pixel of any object is visible");
        return;
    }
    for (const RunPicture& p : run.pictures)
        if (is_empty(p))
            run.warnings.push_back(p.name + ": the picture is empty: no fragment passed its tests");
}

/// What a measured material's file holds, and what of it is no measurement.
void note_measured(std::vector<std::string>& notes, const std::string& name,
                   const MeasuredBrdf& brdf) {
    const MeasuredReport& r = brdf.model->report;
    if (brdf.source.format == MeasuredFormat::merl)
        notes.push_back(fmt::format(
            "{}: sha256 {}, {}", name, r.sha256,
            r.recognised.empty() ? "not in a list of known files" : "known as " + r.recognised));
    for (std::size_t c = 0; c < 3; ++c) {
        const ValueCounts& v = r.counts[c];
        if (v.negative + v.zero + v.not_finite > 0)
            notes.push_back(
                fmt::format("{}, {}: of {} stored values {} are negative, {} zero, {} not finite",
                            name, channel_name(c), v.values, v.negative, v.zero, v.not_finite));
        if (r.factors && (*r.factors)[c].partly_unsupported)
            notes.push_back(fmt::format(
                "{}, {}: partly unsupported: {} of {} samples are not above 0 and masked", name,
                channel_name(c), (*r.factors)[c].zero, r.samples));
    }
}

std::string clustered_note(const std::string& material, const ClusterReport& r) {
    return fmt::format(
        "material {}: {:.0f} merged lights a view in place of {}; relative error {:.2g} % rms over "
        "{} views (bound {:.2g} %)",
        material, r.lights, r.full_lights, 100.0 * r.relative_rms, r.views, 100.0 * r.bound);
}

}  // namespace

std::vector<std::string> notes_about(const LitScene& lit, const SceneAssets& assets) {
    std::vector<std::string> notes = lit.lights.notes;
    const EnvironmentReport& r = lit.lights.report;
    if (r.negative > 0)
        notes.push_back(
            fmt::format("environment: {} negative values ({:.3g} %, least {:.6g}) read as 0",
                        r.negative, 100.0 * r.negative_share, r.least_value));
    if (r.non_finite > 0)
        notes.push_back(
            fmt::format("environment: {} values not finite, repaired to 0", r.non_finite));
    if (r.ignored_channels > 0)
        notes.push_back(fmt::format("environment: {} channels beyond red, green, blue ignored",
                                    r.ignored_channels));
    for (const auto& [name, brdf] : lit.brdfs)
        if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf))
            note_measured(notes, name, *measured);
    for (const auto& [name, report] : lit.clustered) notes.push_back(clustered_note(name, report));
    for (const auto& [name, m] : assets.mesh_reports) {
        if (m.inverted)
            notes.push_back(
                fmt::format("mesh {}: triangles run clockwise seen from outside", name));
        if (m.degenerate > 0)
            notes.push_back(fmt::format("mesh {}: {} of {} triangles have no area", name,
                                        m.degenerate, m.triangles));
    }
    return notes;
}

std::vector<std::string> warnings_of(const FactoredMaterials& materials) {
    std::vector<std::string> warnings;
    for (const auto& [name, lighting] : materials)
        for (const std::string& text : lighting.warnings) warnings.push_back(name + ": " + text);
    return warnings;
}

std::vector<std::string> warnings_of(const Scene& scene, const FactoredMaterials& materials) {
    std::vector<std::string> warnings = warnings_of(materials);
    for (std::size_t p = 0; p < scene.passes.size(); ++p)
        for (std::size_t u = 0; u < max_units; ++u)
            if (scene.passes[p].state.units[u] && scene.passes[p].textures[u].empty())
                warnings.push_back(
                    fmt::format("passes.{}.units.{}: no texture, reads as white", p, u));
    return warnings;
}

RunResult run_scene(const Scene& scene, int threads, const StepListener& listen,
                    Pipeline pipeline) {
    RunResult run{scene, pipeline, {}, {}, 0, {}, {}, {}, {}, {}};
    StepClock clock(run.steps, listen);
    clock.begin("meshes and textures");
    const SceneAssets assets = load_assets(scene);
    run.lit = light_scene(scene, threads, [&](const std::string& step) { clock.begin(step); });
    run.notes = notes_about(run.lit, assets);
    for (const auto& [name, lighting] : run.lit.materials) {
        clock.begin("averaging cost " + name);
        run.averaging_cost[name] =
            averaging_cost(scene, run.lit.lights, run.lit.brdfs.at(name), threads);
    }
    run.warnings = warnings_of(scene, run.lit.materials);
    if (!scene.objects.empty()) {
        clock.begin("exact picture");
        draw_exact(run, assets, threads);
    }
    for (const Preset preset : scene.presets) {
        clock.begin(fmt::format("draw {}", name_of(preset)));
        draw_preset(run, assets, threads, preset);
    }
    clock.begin("compare");
    compare_all(run, outlines_of(scene, assets));
    note_black_channels(run);
    note_methods(run);
    if (!scene.objects.empty() && draws_more(scene))
        run.notes.push_back(
            "exact shows the objects alone, without historical ones and explicit passes; no "
            "picture is "
            "compared with it");
    warn_of_empty(run);
    clock.end();
    return run;
}

}  // namespace twofold
