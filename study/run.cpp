#include "study/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "raster/reference.hpp"
#include "study/pictures.hpp"

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
    ExactPicture exact =
        exact_picture(run.scene, assets, run.lit.lights.lights, run.lit.white, threads);
    run.turned_away = exact.turned_away;
    run.pictures.push_back({"exact", std::move(exact.picture)});
}

void draw_preset(RunResult& run, const SceneAssets& assets, Preset preset) {
    const Frame frame = make_frame(run.scene, assets, run.lit.materials, preset);
    run.pictures.push_back({std::string(name_of(preset)), render_reference(frame, preset)});
}

/// Every picture against exact, and every other against ideal64.
void compare_all(RunResult& run) {
    for (const char* reference : {"exact", "ideal64"})
        for (const RunPicture& a : run.pictures)
            for (const RunPicture& b : run.pictures)
                if (b.name == reference && a.name != "exact" && a.name != reference)
                    run.comparisons.push_back(
                        {a.name, b.name,
                         difference_where_covered(byte_image(a.picture), byte_image(b.picture))});
}

}  // namespace

std::vector<std::string> notes_about(const SceneLights& lights, const SceneAssets& assets) {
    std::vector<std::string> notes = lights.notes;
    const EnvironmentReport& r = lights.report;
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

RunResult run_scene(const Scene& scene, int threads, const StepListener& listen) {
    RunResult run{scene, {}, {}, 0, {}, {}, {}, {}, {}};
    StepClock clock(run.steps, listen);
    clock.begin("meshes and textures");
    const SceneAssets assets = load_assets(scene);
    run.lit = light_scene(scene, threads, [&](const std::string& step) { clock.begin(step); });
    run.notes = notes_about(run.lit.lights, assets);
    for (const auto& [name, lighting] : run.lit.materials) {
        clock.begin("averaging cost " + name);
        run.averaging_cost[name] =
            averaging_cost(scene, run.lit.lights, scene.materials.at(name), threads);
        for (const std::string& w : lighting.warnings) run.warnings.push_back(name + ": " + w);
    }
    if (!scene.objects.empty()) {
        clock.begin("exact picture");
        draw_exact(run, assets, threads);
    }
    for (const Preset preset : scene.presets) {
        clock.begin(fmt::format("draw {}", name_of(preset)));
        draw_preset(run, assets, preset);
    }
    clock.begin("compare");
    compare_all(run);
    clock.end();
    return run;
}

}  // namespace twofold
