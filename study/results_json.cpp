#include "study/results_json.hpp"

#include <nlohmann/json.hpp>

#include "scenes/object_passes.hpp"
#include "scenes/scene_file.hpp"
#include "study/pictures.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

Json rgb_json(const Rgb& c) { return Json::array({c.x, c.y, c.z}); }

Json treated_json(const TreatedSamples& t) {
    return {{"used", t.used}, {"non_finite", t.non_finite}, {"negative", t.negative},
            {"zero", t.zero}, {"floored", t.floored},       {"capped", t.capped}};
}

Json channel_json(std::size_t channel, const FactoredLighting& lighting) {
    const ChannelFit& fit = lighting.fit[channel];
    const ProductTerm& term = lighting.terms[0];
    const ByteLoss &t1 = term.t1.loss[channel], &t2 = term.t2.loss[channel];
    return {{"channel", channel_name(channel)},
            {"status", status_text(lighting, channel)},
            {"iterations", fit.solver.iterations},
            {"best_iteration", fit.solver.best_iteration},
            {"relative_residual", fit.solver.relative_residual},
            {"relative_rms", fit.relative_rms},
            {"relative_rms_8bit", fit.byte_rms},
            {"log_rms", fit.log_rms},
            {"median", fit.median},
            {"p95", fit.p95},
            {"psnr_db", fit.psnr},
            {"samples", treated_json(fit.counts)},
            {"untouched_share", fit.untouched_share},
            {"components", fit.components},
            {"levels", {{"t1", t1.levels}, {"t2", t2.levels}}},
            {"zero_share", {{"t1", t1.zero_share}, {"t2", t2.zero_share}}},
            {"clipped_share", {{"t1", t1.clipped_share}, {"t2", t2.clipped_share}}},
            {"history", fit.solver.history}};
}

/// What the term's passes do.
const char* operation_of(const ProductTerm& term) {
    if (term.sum_of_maps) return "sum of maps";
    return term.subtract ? "subtract product" : "add product";
}

Json term_json(const ProductTerm& term) {
    Json view = Json::array();
    for (const Rgb& value : term.view) view.push_back(rgb_json(value));
    return {
        {"scale", {{"color", rgb_json(term.scale_color)}, {"combiner_scale", term.combiner_scale}}},
        {"operation", operation_of(term)},
        {"max1", rgb_json(term.max1)},
        {"max2", rgb_json(term.max2)},
        {"c", rgb_json(term.c)},
        {"view", view},
        {"hash_t1", hash_of_t1(term)},
        {"hash_t2", hash_of(term.t2)}};
}

Json lighting_json(const FactoredLighting& lighting) {
    Json channels = Json::array(), terms = Json::array();
    for (std::size_t c = 0; c < 3; ++c) channels.push_back(channel_json(c, lighting));
    for (const ProductTerm& term : lighting.terms) terms.push_back(term_json(term));
    return {{"model", name_of(lighting.model)},
            {"passes", pass_count(lighting)},
            {"map_form", name_of(lighting.terms[0].t2.shape.form)},
            {"map_size", lighting.terms[0].t2.shape.size},
            {"closed_form", lighting.closed_form},
            {"doubling_passes", lighting.doubling_passes},
            {"terms", terms},
            {"warnings", lighting.warnings},
            {"channels", channels}};
}

Json factor_json(const ProductFit& fit) {
    return {{"used", fit.used},
            {"unmeasured", fit.unmeasured},
            {"zero", fit.zero},
            {"floored", fit.floored},
            {"partly_unsupported", fit.partly_unsupported},
            {"status", name_of(fit.solver.status)},
            {"iterations", fit.solver.iterations},
            {"relative_rms", fit.relative_rms},
            {"log_rms", fit.log_rms}};
}

/// What a measured material's file holds and how its gaps were filled; null for other materials.
Json measured_json(const Brdf& brdf) {
    const auto* measured = std::get_if<MeasuredBrdf>(&brdf);
    if (measured == nullptr) return nullptr;
    const MeasuredReport& r = measured->model->report;
    Json channels = Json::array();
    for (std::size_t c = 0; c < 3; ++c) {
        const ValueCounts& v = r.counts[c];
        channels.push_back({{"channel", channel_name(c)},
                            {"values", v.values},
                            {"negative", v.negative},
                            {"zero", v.zero},
                            {"not_finite", v.not_finite},
                            {"filled_nodes", r.filled[c]},
                            {"factors", r.factors ? factor_json((*r.factors)[c]) : Json(nullptr)}});
    }
    return {{"file", measured->source.path},
            {"sha256", r.sha256},
            {"recognised", r.recognised.empty() ? Json(nullptr) : Json(r.recognised)},
            {"samples", r.samples},
            {"channels", channels}};
}

Json environment_json(const SceneLights& lights) {
    const EnvironmentReport& r = lights.report;
    return {{"lights", lights.lights.size()},
            {"width", r.width},
            {"height", r.height},
            {"negative", r.negative},
            {"least_value", r.least_value},
            {"non_finite", r.non_finite},
            {"brightest_share", r.brightest_share}};
}

Json pictures_json(const RunResult& run, bool with_counters) {
    Json pictures = Json::object();
    for (const RunPicture& p : run.pictures) {
        pictures[p.name] = {{"hash", hash_of(p.picture)}};
        if (with_counters && p.name != "exact" && run.pipeline == Pipeline::reference)
            pictures[p.name]["counters"] = to_json(p.picture.counters);
    }
    return pictures;
}

}  // namespace

std::string status_text(const FactoredLighting& lighting, std::size_t channel) {
    if (lighting.terms[0].c[static_cast<int>(channel)] == 0.0) return "black";
    if (!lighting.closed_form.empty()) return "closed form: " + lighting.closed_form;
    return name_of(lighting.fit[channel].solver.status);
}

std::string map_name(const std::string& factor, std::size_t term) {
    return term == 0 ? factor : factor + "-" + std::to_string(term + 1);
}

std::string program_version() { return TWOFOLD_VERSION; }

Json to_json(const PictureDifference& d) {
    Json first = nullptr;
    if (d.first_difference) first = {d.first_difference->first, d.first_difference->second};
    return {{"pixels_compared", d.pixels_compared},
            {"differing_pixels", d.differing_pixels},
            {"coverage_differs", d.coverage_differs},
            {"first_difference", first},
            {"max_steps", d.max_steps},
            {"rms_steps", d.rms_steps},
            {"psnr_db", d.psnr_db},
            {"max_per_channel", d.max_per_channel},
            {"histogram", d.histogram}};
}

Json to_json(const FloatDifference& d) {
    Json first = nullptr;
    if (d.first_difference) first = {d.first_difference->first, d.first_difference->second};
    return {{"samples_compared", d.samples_compared},
            {"differing_samples", d.differing_samples},
            {"differing_pixels", d.differing_pixels},
            {"without_distance", d.without_distance},
            {"coverage_differs", d.coverage_differs},
            {"first_difference", first},
            {"max_abs", d.max_abs},
            {"rms", d.rms},
            {"psnr_db", d.psnr_db}};
}

Json to_json(const DrawCounters& c) {
    return {{"triangles", c.triangles},
            {"rejected", c.rejected},
            {"not_finite", c.not_finite},
            {"clipped", c.clipped},
            {"culled", c.culled},
            {"zero_area", c.zero_area},
            {"set_up", c.set_up},
            {"fragments", c.fragments},
            {"undefined_coords", c.undefined_coords},
            {"alpha_failed", c.alpha_failed},
            {"depth_failed", c.depth_failed},
            {"written", c.written}};
}

namespace {

Json lighting_sum_json(const LitScene& lit, const std::string& material) {
    const auto found = lit.clustered.find(material);
    if (found == lit.clustered.end())
        return {{"sum", "full"}, {"lights", lit.lights.lights.size()}};
    const ClusterReport& r = found->second;
    return {{"sum", "clustered"},       {"lights", r.full_lights}, {"merged_lights", r.lights},
            {"tolerance", r.tolerance}, {"bound", r.bound},        {"relative_rms", r.relative_rms},
            {"judged_views", r.views}};
}

}  // namespace

Json factors_json(const Scene& scene, const LitScene& lit) {
    Json materials = Json::object();
    for (const auto& [name, lighting] : lit.materials) {
        materials[name] = lighting_json(lighting);
        materials[name]["measured"] = measured_json(lit.brdfs.at(name));
        materials[name]["lighting_sum"] = lighting_sum_json(lit, name);
    }
    const FactorSettings& settings = scene.factorization;
    return {{"title", scene.title},
            {"version", program_version()},
            {"method", name_of(settings.method)},
            {"solver", name_of(settings.solver)},
            {"fit_samples", settings.samples},
            {"held_out_samples", settings.held_out},
            {"white", lit.white},
            {"environment", environment_json(lit.lights)},
            {"materials", materials}};
}

Json run_json(const RunResult& run) {
    Json comparisons = Json::array();
    for (const RunComparison& c : run.comparisons) {
        Json row = {{"picture", c.picture}, {"reference", c.reference}};
        row.update(to_json(c.difference));
        comparisons.push_back(row);
    }
    Json steps = Json::object();
    for (const RunStep& s : run.steps) steps[s.name] = s.seconds;
    return {{"factors", factors_json(run.scene, run.lit)},
            {"averaging_cost", run.averaging_cost},
            {"turned_away", run.turned_away},
            {"pipeline", name_of(run.pipeline)},
            {"pictures", pictures_json(run, true)},
            {"comparisons", comparisons},
            {"seconds", steps},
            {"notes", run.notes},
            {"warnings", run.warnings}};
}

std::string manifest_json(const RunResult& run) {
    Json manifest = Json::parse(scene_to_json(run.scene));
    Json factors = Json::object();
    for (const auto& [name, lighting] : run.lit.materials) {
        Json& hashes = factors[name] = Json::object();
        for (std::size_t k = 0; k < lighting.terms.size(); ++k) {
            hashes[map_name("t1", k)] = hash_of_t1(lighting.terms[k]);
            hashes[map_name("t2", k)] = hash_of(lighting.terms[k].t2);
        }
    }
    manifest["results"] = {{"version", program_version()},
                           {"white", run.lit.white},
                           {"factors", factors},
                           {"pictures", pictures_json(run, false)}};
    return manifest.dump(2) + "\n";
}

}  // namespace twofold
