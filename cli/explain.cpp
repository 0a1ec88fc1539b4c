#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/cost.hpp"
#include "raster/fast_plan.hpp"
#include "raster/plan.hpp"
#include "raster/reference.hpp"
#include "scenes/scene_file.hpp"
#include "study/results_json.hpp"
#include "study/run.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

Json table_json(Preset preset) {
    Json stages = Json::array();
    for (const StageRule& r : stage_rules(preset))
        stages.push_back({{"stage", r.stage},
                          {"rule", r.rule},
                          {"mark", name_of(r.mark)},
                          {"source", r.source}});
    const MarkCounts n = count_marks(preset);
    return {{"preset", name_of(preset)},
            {"version", version_of(preset)},
            {"purpose", purpose_of(preset)},
            {"sentence", exactness_sentence(preset)},
            {"sourced", n.sourced},
            {"inferred", n.inferred},
            {"chosen", n.chosen},
            {"stages", stages}};
}

void print_table(Preset preset) {
    fmt::print("{} v{}: {}\n\n", name_of(preset), version_of(preset), purpose_of(preset));
    int number = 0;
    for (const StageRule& r : stage_rules(preset))
        fmt::print("{:>2} {:<40} {:<9} {}\n   {:<40} {:<9} from: {}\n", ++number, r.stage,
                   name_of(r.mark), r.rule, "", "", r.source);
    fmt::print("\n{}\n", exactness_sentence(preset));
}

/// A lighting function that stands for one not yet factored: one white texel a face, scale 1, one
/// light.
/// @param vertices of the object's mesh
FactoredLighting stand_in(const FactorSettings& settings, std::size_t vertices) {
    const MapShape shape{1, settings.guard, settings.map_form};
    const NormalisedChannel white = white_channel(shape);
    ProductTerm term;
    term.t1 = term.t2 = make_factor_map({white, white, white}, shape, "stand-in");
    if (settings.model == Model::slf) {
        term.t1 = make_factor_map({white, white, white}, {1, 1.0, MapForm::chart}, "stand-in");
        if (settings.surface_rows == SurfaceRow::vertices) term.vertices.assign(vertices, Rgb(1.0));
    }
    term.sum_of_maps = settings.model == Model::prefilter;
    FactoredLighting lighting;
    lighting.lights.push_back({0.0, 0.0, 1.0}, Rgb(1.0));
    lighting.model = settings.model;
    lighting.terms.assign(static_cast<std::size_t>(settings.terms), term);
    return lighting;
}

Frame explained_frame(const Scene& scene) {
    const SceneAssets assets = load_assets(scene);
    FactoredMaterials materials;
    for (const FactoredObject& object : scene.objects)
        materials[object.material] =
            stand_in(scene.factorization, assets.meshes.at(object.mesh).positions.size());
    return make_frame(scene, assets, materials, scene.presets.front());
}

/// What one pass alone does to a cleared picture: its counted work.
DrawCounters work_of(const Frame& frame, std::size_t pass, const Scene& scene) {
    Frame alone = frame;
    alone.passes = {frame.passes[pass]};
    return render_reference(alone, scene.presets.front(), scene.custom).counters;
}

/// How the fast pipeline computes something, with the reason where not on vectors.
std::string way_of(const std::string& why_scalar) {
    return why_scalar.empty() ? "on vectors" : "one by one: " + why_scalar;
}

std::string sharing_of(const FastRoute& route, std::size_t pass) {
    if (pass == 0) return "the first pass";
    if (route.apart.empty()) return "fused: shares vertices and set-up with the pass before";
    return "not fused with the pass before: " + route.apart;
}

Json route_json(const FastRoute& route, std::size_t pass) {
    return {{"vertices", way_of(route.scalar_vertices)},
            {"fragments", way_of(route.scalar_fragments)},
            {"fused", pass > 0 && route.apart.empty()},
            {"geometry", sharing_of(route, pass)}};
}

void print_route(const FastRoute& route, std::size_t pass) {
    fmt::print("  fast pipeline: vertices {}; fragments {}; {}\n", way_of(route.scalar_vertices),
               way_of(route.scalar_fragments), sharing_of(route, pass));
}

Json pass_json(const PassState& state, const DrawCounters& work) {
    Json stages = Json::array();
    for (const PlannedStage& s : plan(state))
        stages.push_back({{"stage", s.stage}, {"runs", s.runs}, {"why", s.why}, {"cost", s.cost}});
    return {{"stages", stages},
            {"work", to_json(work)},
            {"texel_fetches", work.fragments * static_cast<std::uint64_t>(texel_fetches(state))}};
}

void print_pass(std::size_t i, const PassState& state, const DrawCounters& work) {
    fmt::print("pass {}: {} triangles, {} set up, {} fragments, {} texel fetches\n", i,
               work.triangles, work.set_up, work.fragments,
               work.fragments * static_cast<std::uint64_t>(texel_fetches(state)));
    for (const PlannedStage& s : plan(state))
        fmt::print("  {:<3} {:<18} {:<42} {}\n", s.runs ? "on" : "-", s.stage, s.why, s.cost);
}

ExitCode explain_scene(const ExplainOptions& options, const CommonOptions& common) {
    const Scene scene = read_scene(options.scene, common.overrides);
    const Frame frame = explained_frame(scene);
    const auto routes = fast_routes(frame, scene.presets.front(), scene.custom);
    Json passes = Json::array();
    for (std::size_t i = 0; i < frame.passes.size(); ++i) {
        const PassState state = normalized(frame, frame.passes[i]);
        const DrawCounters work = work_of(frame, i, scene);
        if (common.json) {
            passes.push_back(pass_json(state, work));
            passes.back()["fast"] = route_json(routes[i], i);
        } else {
            print_pass(i, state, work);
            print_route(routes[i], i);
        }
    }
    const std::string note =
        "before factoring: rgb_scale is taken as 1; a scale above 4 adds doubling passes, "
        "and each signed product takes up to four passes in place of one";
    const std::string triangles =
        "on vectors but for triangles whose coordinates are beyond bounds or whose q changes sign";
    if (common.json) {
        fmt::print("{}\n",
                   Json{{"passes", passes}, {"note", note}, {"vectors", triangles}}.dump(2));
        return ExitCode::ok;
    }
    fmt::print("{}\n", triangles);
    if (!scene.objects.empty()) fmt::print("{}\n", note);
    return ExitCode::ok;
}

constexpr const char* cost_note =
    "percent of the frame's processor time, one thread, measured by leaving the effect out: of "
    "this "
    "machine, noisy, and not additive; negative where it saves work";

Json cost_json(Preset preset, const FrameCost& cost) {
    Json effects = Json::array();
    for (const EffectCost& e : cost.effects)
        effects.push_back(
            {{"effect", e.effect}, {"percent", e.percent}, {"least", e.least}, {"most", e.most}});
    return {{"preset", name_of(preset)},
            {"frame_ms", cost.seconds * 1e3},
            {"effects", effects},
            {"note", cost_note}};
}

void print_cost(Preset preset, const FrameCost& cost) {
    fmt::print("{}: {:.3f} ms a frame\n", name_of(preset), cost.seconds * 1e3);
    for (const EffectCost& e : cost.effects)
        fmt::print("  {:<24} {:>6.1f} %  ({:.1f} to {:.1f})\n", e.effect, e.percent, e.least,
                   e.most);
    fmt::print("{}\n", cost_note);
}

/// The scene is lit first, since what its textures hold decides what is drawn.
ExitCode explain_cost(const ExplainOptions& options, const CommonOptions& common) {
    const Scene scene = read_scene(options.scene, common.overrides);
    const Preset preset = scene.presets.front();
    const LitScene lit = light_scene(scene, common.threads, [](const std::string&) {});
    const Frame frame = make_frame(scene, load_assets(scene), lit.materials, preset);
    constexpr int rounds = 9;
    const FrameCost cost = measure_cost(frame, preset, scene.custom, rounds);
    if (common.json)
        fmt::print("{}\n", cost_json(preset, cost).dump(2));
    else
        print_cost(preset, cost);
    return ExitCode::ok;
}

}  // namespace

Preset preset_or_error(const std::string& name) {
    if (const auto preset = preset_named(name)) return *preset;
    std::string known;
    for (const Preset p : all_presets) known += fmt::format(" {}", name_of(p));
    known += " custom";
    throw Error(ExitCode::failure,
                fmt::format("--preset: no preset '{}'; there are:{}", name, known));
}

ExitCode explain_command(const ExplainOptions& options, const CommonOptions& common) {
    if (options.scene.empty() == options.preset.empty())
        throw Error(ExitCode::failure, "explain: give either a scene or --preset NAME");
    if (options.cost && options.scene.empty())
        throw Error(ExitCode::failure, "--cost: needs a scene to measure");
    if (options.cost) return explain_cost(options, common);
    if (!options.scene.empty()) return explain_scene(options, common);
    const Preset preset = preset_or_error(options.preset);
    if (common.json)
        fmt::print("{}\n", table_json(preset).dump(2));
    else
        print_table(preset);
    return ExitCode::ok;
}

}  // namespace twofold
