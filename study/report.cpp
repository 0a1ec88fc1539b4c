#include "study/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "study/page_text.hpp"

/// The files of study/report/, made into string views by study/report/embed.cmake.
namespace twofold::report_files {
extern const std::string_view report_html, report_css, elements_js, viewer_js, charts_js, page_js;
}

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

template <typename T, typename ToJson>
Json list_of(const T& values, ToJson to_json) {
    Json list = Json::array();
    for (const auto& value : values) list.push_back(to_json(value));
    return list;
}

template <typename Second>
Json pair_json(const std::pair<std::string, Second>& pair) {
    return Json::array({pair.first, pair.second});
}

Json picture_json(const ReportPicture& picture) {
    return {{"name", picture.name}, {"src", image_source(picture.png)}, {"hash", picture.hash}};
}

Json position_json(const std::optional<std::pair<int, int>>& at) {
    return at ? Json::array({at->first, at->second}) : Json();
}

/// The histogram ends at the largest difference: what follows is zero.
Json histogram_json(const PictureDifference& d) {
    const auto end = d.histogram.begin() + std::clamp(d.max_steps, 0, 255) + 1;
    return Json(std::vector<std::size_t>(d.histogram.begin(), end));
}

Json comparison_json(const ReportComparison& comparison) {
    const PictureDifference& d = comparison.difference;
    return {{"picture", comparison.picture},
            {"reference", comparison.reference},
            {"compared", d.pixels_compared},
            {"differing", d.differing_pixels},
            {"coverage", d.coverage_differs},
            {"first", position_json(d.first_difference)},
            {"max", d.max_steps},
            {"perChannel", d.max_per_channel},
            {"rms", d.rms_steps},
            {"psnr", d.psnr_db},
            {"histogram", histogram_json(d)},
            {"heat", image_source(comparison.heat_png)},
            {"fullScale", comparison.heat_full_scale_steps}};
}

Json fit_json(const ReportChannelFit& fit) {
    return {{"status", fit.solver_status},
            {"iterations", fit.iterations},
            {"residual", fit.relative_residual},
            {"history", fit.history},
            {"relativeRms", fit.relative_rms},
            {"logRms", fit.log_rms},
            {"median", fit.median},
            {"p95", fit.p95},
            {"psnr", fit.psnr},
            {"scale", fit.scale_c},
            {"treated", list_of(fit.treated_samples, pair_json<std::size_t>)}};
}

Json material_json(const ReportMaterial& material) {
    return {{"name", material.name},
            {"brdf", material.brdf},
            {"model", material.model},
            {"passes", material.passes},
            {"mapSize", material.map_size},
            {"combinerScale", material.combiner_scale},
            {"doublingPasses", material.doubling_passes},
            {"scaleColor", material.scale_color},
            {"channels", list_of(material.channels, fit_json)},
            {"maps", list_of(material.maps, picture_json)}};
}

Json step_json(const ReportStep& step) { return {{"name", step.name}, {"seconds", step.seconds}}; }

std::string css_color(Rgba8 color) {
    return fmt::format("rgb({} {} {})", color.r, color.g, color.b);
}

Json report_json(const Report& report) {
    return {{"title", report.title},
            {"scene", report.scene_path},
            {"version", report.version},
            {"command", report.command},
            {"notes", report.notes},
            {"warnings", report.warnings},
            {"white", report.white},
            {"environment", report.environment},
            {"averagingCost", report.averaging_cost},
            {"heatColors", list_of(heat_colors, css_color)},
            {"coverageColor", css_color(coverage_color)},
            {"pictures", list_of(report.pictures, picture_json)},
            {"comparisons", list_of(report.comparisons, comparison_json)},
            {"materials", list_of(report.materials, material_json)},
            {"steps", list_of(report.steps, step_json)},
            {"presets", list_of(report.preset_sentences, pair_json<std::string>)},
            {"provenance", list_of(report.provenance, pair_json<std::string>)}};
}

std::string script() {
    using namespace report_files;
    return fmt::format("{}\n{}\n{}\n{}", elements_js, viewer_js, charts_js, page_js);
}

const ReportComparison* find_comparison(const Report& report, std::string_view picture,
                                        std::string_view reference) {
    for (const ReportComparison& c : report.comparisons) {
        if (c.picture == picture && c.reference == reference) return &c;
    }
    return nullptr;
}

/// What the summary speaks of: nv17, the project's subject, or else the last picture that was
/// compared with `exact`.
const ReportComparison* subject(const Report& report) {
    if (const ReportComparison* nv17 = find_comparison(report, "nv17", "exact")) return nv17;
    const ReportComparison* last = nullptr;
    for (const ReportComparison& c : report.comparisons) {
        if (c.reference == "exact") last = &c;
    }
    return last;
}

}  // namespace

std::string summary_sentence(const Report& report) {
    const ReportComparison* whole = subject(report);
    if (!whole) return "No picture was compared with the exact one.";
    if (whole->difference.pixels_compared == 0)
        return whole->picture + " has no pixel in common with the exact picture.";
    const std::string first = fmt::format("{} differs from exact by {:.2f} of 255 steps RMS",
                                          whole->picture, whole->difference.rms_steps);
    const ReportComparison* arithmetic = find_comparison(report, whole->picture, "ideal64");
    const ReportComparison* factorisation = find_comparison(report, "ideal64", "exact");
    if (!arithmetic || !factorisation || arithmetic == factorisation) return first + ".";
    return first + fmt::format(
                       ": the factorisation alone makes {:.2f}, the preset's arithmetic "
                       "alone {:.2f}.",
                       factorisation->difference.rms_steps, arithmetic->difference.rms_steps);
}

std::string report_html(const Report& report) {
    return filled(report_files::report_html, {{"title", html_text(report.title)},
                                              {"summary", html_text(summary_sentence(report))},
                                              {"style", std::string(report_files::report_css)},
                                              {"data", script_data(report_json(report))},
                                              {"script", script()}});
}

}  // namespace twofold
