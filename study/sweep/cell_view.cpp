#include "study/sweep/cell_view.hpp"

#include <algorithm>
#include <map>

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

/// The number at a path of keys; none where something on the way, or itself, is missing or null.
std::optional<double> number_at(const Json& json, std::initializer_list<const char*> path) {
    const Json* at = &json;
    for (const char* key : path) {
        if (!at->is_object() || !at->contains(key)) return std::nullopt;
        at = &at->at(key);
    }
    return at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
}

/// The largest over materials and channels.
std::optional<double> largest_of_fit(const Json& result, const char* field) {
    std::optional<double> largest;
    if (!result.contains("fit") || result.at("fit").is_null()) return largest;
    for (const auto& [name, material] : result.at("fit").items())
        for (const Json& channel : material.at("channels"))
            if (const auto value = number_at(channel, {field}))
                largest = std::max(largest.value_or(0.0), *value);
    return largest;
}

}  // namespace

double anchor_seconds(const StudyResults& results) {
    std::vector<double> seconds;
    for (const auto& [id, result] : results.cells)
        if (const auto s = number_at(result, {"times", "frame", "anchor_processor", "least"}))
            seconds.push_back(*s);
    return seconds.empty() ? 0.0 : spread_of(std::move(seconds)).median;
}

CellView view_of(const Json& result, double anchor) {
    CellView view;
    view.failed = result.value("failed", "");
    view.error = number_at(result, {"errors", "exact", "rms_steps"});
    view.ideal = number_at(result, {"errors", "ideal64", "real_rms_steps"});
    view.relative = number_at(result, {"errors", "exact", "relative_rms"});
    view.held_out = largest_of_fit(result, "relative_rms");
    view.held_out_bytes = largest_of_fit(result, "relative_rms_8bit");
    view.card = number_at(result, {"card", "seconds"});
    if (const auto ratio = number_at(result, {"times", "frame", "ratio_to_anchor"}))
        view.frame = *ratio * anchor;
    const auto sampling = number_at(result, {"times", "sampling", "wall"});
    const auto factoring = number_at(result, {"times", "factoring", "wall"});
    if (sampling && factoring && *factoring > 0.0) view.before = *sampling + *factoring;
    return view;
}

std::optional<double> judged_error(const CellView& view) {
    return view.error ? view.error : view.ideal;
}

std::vector<std::string> cell_names(const StudyPlan& plan) {
    std::vector<std::string> names(plan.cells.size());
    names[plan.base] = "Common cell";
    for (const PlannedAxis& axis : plan.axes)
        for (const PlannedPoint& point : axis.points)
            if (names[point.cell].empty()) names[point.cell] = axis.title + ": " + point.label;
    return names;
}

}  // namespace twofold
