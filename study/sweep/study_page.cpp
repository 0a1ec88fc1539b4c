#include "study/sweep/study_page.hpp"

#include <fmt/format.h>

#include <set>

#include "study/metrics.hpp"
#include "study/page_text.hpp"
#include "study/results_json.hpp"
#include "study/sweep/cell_view.hpp"
#include "study/sweep/checks.hpp"
#include "study/sweep/figure.hpp"
#include "study/sweep/work.hpp"
#include "study/write_run.hpp"
#include "texunit/atomic_file.hpp"

/// The files of study/report/, made into string views by study/report/embed.cmake.
namespace twofold::report_files {
extern const std::string_view study_html, report_css, figure_css, study_css, elements_js, viewer_js,
    charts_js, study_js, claim_js, tables_js, hard_cases_json;
}

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// The histogram ends at the largest difference: what follows is zero.
Json shortened(const Json& errors) {
    if (errors.is_null()) return errors;
    Json result = errors;
    Json histogram = Json::array();
    for (std::size_t i = 0; i <= errors.at("max_steps").get<std::size_t>(); ++i)
        histogram.push_back(errors.at("histogram").at(i));
    result["histogram"] = histogram;
    return result;
}

/// The scale of each material, without the solver's history.
Json scales_json(const Json& fit) {
    Json scales = Json::array();
    if (fit.is_null()) return scales;
    for (const auto& [name, material] : fit.items()) {
        const Json& term = material.at("terms").at(0);
        Json channels = Json::array();
        for (const Json& c : material.at("channels"))
            channels.push_back({{"levels", c.at("levels")},
                                {"zero", c.at("zero_share")},
                                {"clipped", c.at("clipped_share")}});
        scales.push_back({{"material", name},
                          {"combinerScale", term.at("scale").at("combiner_scale")},
                          {"doublings", material.at("doubling_passes")},
                          {"c", term.at("c")},
                          {"channels", channels}});
    }
    return scales;
}

Json cell_json(const std::string& name, const Json& result, double anchor) {
    const CellView view = view_of(result, anchor);
    Json json{{"id", result.at("id")},         {"name", name},
              {"preset", result.at("preset")}, {"technique", result.at("technique")},
              {"way", result.at("way")},       {"filter", result.at("filter")},
              {"failed", view.failed}};
    if (!view.failed.empty()) return json;
    json["hash"] = result.at("picture").at("hash");
    json["exact"] = shortened(result.at("errors").at("exact"));
    json["ideal"] = shortened(result.at("errors").at("ideal64"));
    json["frame"] = optional_json(view.frame);
    json["frameTimes"] = result.at("times").at("frame");
    json["before"] = optional_json(view.before);
    json["card"] = optional_json(view.card);
    json["counts"] = result.at("counts");
    json["scales"] = scales_json(result.at("fit"));
    json["warnings"] = result.at("warnings");
    return json;
}

Json axis_json(const StudyPlan& plan, const PlannedAxis& axis) {
    Json points = Json::array();
    for (const PlannedPoint& p : axis.points)
        points.push_back({{"label", p.label},
                          {"scene", p.scene},
                          {"value", optional_json(p.value)},
                          {"cell", plan.cells[p.cell].id}});
    return {{"name", axis.name}, {"title", axis.title}, {"points", points}};
}

/// Each different picture once, by its hash.
Json sources_json(const StudyPage& page) {
    Json sources = Json::object();
    for (const auto& [id, png] : page.pictures) {
        const std::string hash = page.results.cells.at(id).at("picture").at("hash");
        if (!sources.contains(hash)) sources[hash] = image_source(png);
    }
    return sources;
}

Json provenance_json(const StudyPage& page) {
    const StudyPlan& plan = page.results.plan;
    std::set<std::string> machines, compilers;
    for (const auto& [id, result] : page.results.cells) {
        if (!result.contains("times")) continue;
        machines.insert(result.at("times").at("processor").get<std::string>());
        compilers.insert(result.at("times").at("compiler").get<std::string>());
    }
    return {{"program", "twofold " + program_version()},
            {"scene", fmt::format("{} ({})", plan.scene_title, plan.scene_file)},
            {"scene and input files", plan.scene_hash},
            {"command", page.command},
            {"compilers", fmt::format("{}", fmt::join(compilers, "; "))},
            {"processors", fmt::format("{}", fmt::join(machines, "; "))},
            {"predicted times", model_text(mx440_8x)}};
}

std::string css_color(Rgba8 color) {
    return fmt::format("rgb({} {} {})", color.r, color.g, color.b);
}

Json page_json(const StudyPage& page) {
    const StudyPlan& plan = page.results.plan;
    const std::vector<std::string> names = cell_names(plan);
    const double anchor = anchor_seconds(page.results);
    Json cells = Json::array(), axes = Json::array(), colors = Json::array();
    for (std::size_t i = 0; i < plan.cells.size(); ++i)
        cells.push_back(cell_json(names[i], page.results.cells.at(plan.cells[i].id), anchor));
    for (const PlannedAxis& axis : plan.axes) axes.push_back(axis_json(plan, axis));
    for (const Rgba8 color : heat_colors) colors.push_back(css_color(color));
    return {{"version", program_version()},
            {"base", plan.cells[plan.base].id},
            {"heatColors", colors},
            {"coverageColor", css_color(coverage_color)},
            {"cells", cells},
            {"axes", axes},
            {"hardCases", Json::parse(report_files::hard_cases_json)},
            {"checks", page.checks},
            {"sources", sources_json(page)},
            {"provenance", provenance_json(page)}};
}

std::string figures_html(const std::vector<StudyFigure>& figures) {
    std::string html;
    for (const StudyFigure& f : figures)
        html += fmt::format(
            "<figure class=\"plot\" id=\"plot-{}\"><figcaption><strong>{}</strong> {}</figcaption>"
            "{}</figure>\n",
            f.name, html_text(f.heading), html_text(f.remark), f.svg);
    return html;
}

std::string script() {
    using namespace report_files;
    return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", elements_js, viewer_js, charts_js, claim_js,
                       tables_js, study_js);
}

std::string style() {
    using namespace report_files;
    return fmt::format("{}\n{}\n{}", report_css, figure_css, study_css);
}

void write_figures(const std::vector<StudyFigure>& figures, const std::filesystem::path& folder) {
    for (const StudyFigure& f : figures)
        write_file_atomically(folder / (f.name + ".svg"),
                              svg_file(f.svg, report_files::figure_css));
}

constexpr std::size_t max_picture_bytes = std::size_t{1} << 30;

StudyPage page_of(const StudyResults& results, const CellStore& store, const StudyOrigin& origin) {
    StudyPage page{results,
                   trade_figures(results),
                   budget_figures(results),
                   axis_figures(results),
                   {},
                   origin.command,
                   {}};
    if (!origin.checks.empty()) page.checks = read_checks(origin.checks);
    for (const auto& [id, result] : results.cells)
        if (!result.contains("failed"))
            page.pictures[id] = read_file(store.picture_file(id), max_picture_bytes);
    return page;
}

}  // namespace

std::string study_summary(const StudyResults& results) {
    const StudyPlan& plan = results.plan;
    const CellView view = view_of(results.cells.at(plan.cells[plan.base].id), 0.0);
    const std::string arithmetic =
        view.ideal ? fmt::format("its arithmetic alone makes {:.2f}", *view.ideal) : "";
    if (!view.error)
        return fmt::format("{} cells; of the common cell {}.", plan.cells.size(), arithmetic);
    return fmt::format("{} cells. The common one is off by {:.2f} of 255 steps RMS; {}.",
                       plan.cells.size(), *view.error, arithmetic);
}

std::string study_html(const StudyPage& page) {
    const std::string title =
        fmt::format("{}: {}", page.results.plan.study_title, page.results.plan.scene_title);
    return filled(report_files::study_html, {{"title", html_text(title)},
                                             {"summary", html_text(study_summary(page.results))},
                                             {"style", style()},
                                             {"trades", figures_html(page.trades)},
                                             {"budgets", figures_html(page.budgets)},
                                             {"axes", figures_html(page.axes)},
                                             {"data", script_data(page_json(page))},
                                             {"script", script()}});
}

std::filesystem::path write_study(const StudyResults& results, const CellStore& store,
                                  const std::filesystem::path& folder, const StudyOrigin& origin) {
    const StudyPage page = page_of(results, store, origin);
    const OutputFolder figures_folder(folder / "figures");
    for (const auto* figures : {&page.trades, &page.budgets, &page.axes})
        write_figures(*figures, figures_folder.path());
    write_file_atomically(folder / "cells.csv", study_csv(results));
    const std::filesystem::path report = folder / "report.html";
    write_file_atomically(report, study_html(page));
    return report;
}

}  // namespace twofold
