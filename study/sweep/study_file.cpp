#include "study/sweep/study_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scenes/json_reader.hpp"
#include "scenes/json_text.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

namespace twofold {
namespace {

using scene_io::JsonObject;
using scene_io::JsonValue;

constexpr std::size_t max_axes = 64, max_points = 256;

constexpr std::array plot_names{
    scene_io::Named{"none", AxisPlot::none}, scene_io::Named{"line", AxisPlot::line},
    scene_io::Named{"bars", AxisPlot::bars}, scene_io::Named{"budget", AxisPlot::budget}};

constexpr std::array reference_names{scene_io::Named{"exact", AxisReference::exact},
                                     scene_io::Named{"ideal64", AxisReference::ideal64}};

/// The object's members as changes `path=value`.
std::vector<std::string> read_changes(const std::optional<JsonValue>& object) {
    std::vector<std::string> changes;
    if (!object) return changes;
    if (!object->is_object()) object->fail(object->shown() + " is not an object");
    for (const std::string& path : object->keys())
        changes.push_back(path + "=" + object->member(path)->dump());
    return changes;
}

/// A value of the short form, in which all cells of an axis change one path.
StudyPoint short_point(const std::string& path, const JsonValue& value) {
    StudyPoint point{
        value.is_text() ? value.text() : value.dump(), std::nullopt, {path + "=" + value.dump()}};
    if (value.is_number()) point.value = value.number(scene_io::any_number);
    return point;
}

StudyPoint read_point(const JsonValue& value) {
    const JsonObject fields(value, {"label", "value", "set"});
    StudyPoint point{fields.at("label").text(), std::nullopt, read_changes(fields.find("set"))};
    if (const auto number = fields.find("value"))
        point.value = number->number(scene_io::any_number);
    return point;
}

std::vector<StudyPoint> read_points(const JsonObject& fields) {
    std::vector<StudyPoint> points;
    if (fields.one_of({"values", "points"}) == "values") {
        const std::string path = fields.at("path").text();
        for (const JsonValue& value : fields.at("values").elements(1, max_points))
            points.push_back(short_point(path, value));
    } else {
        for (const JsonValue& value : fields.at("points").elements(1, max_points))
            points.push_back(read_point(value));
    }
    return points;
}

/// Names of files, not paths: they lie beside the study's scene.
std::vector<std::string> read_scenes(const JsonObject& fields) {
    std::vector<std::string> scenes;
    if (const auto list = fields.find("scenes"))
        for (const JsonValue& name : list->elements(1, max_axes)) {
            scenes.push_back(name.text());
            if (std::filesystem::path(name.text()).filename() != name.text())
                name.fail(name.shown() + " is not the name of a file beside the scene");
        }
    return scenes;
}

StudyAxis read_axis(const JsonValue& value) {
    const JsonObject fields(value, {"name", "title", "plot", "against", "linear", "needs_objects",
                                    "scenes", "base", "path", "values", "points"});
    const std::string name = fields.at("name").text();
    return {name,
            fields.text("title", name),
            fields.enumerator("plot", plot_names, AxisPlot::none),
            fields.enumerator("against", reference_names, AxisReference::exact),
            fields.boolean("linear", false),
            fields.boolean("needs_objects", false),
            read_scenes(fields),
            read_changes(fields.find("base")),
            read_points(fields)};
}

TimingRule read_timing(const JsonObject& fields) {
    const auto timing = fields.find("timing");
    TimingRule rule;
    if (!timing) return rule;
    const JsonObject of(*timing, {"seconds", "least_rounds", "most_rounds", "long_frame"});
    const scene_io::Range positive{.low = 0.0, .high = 3600.0};
    rule.seconds = of.number("seconds", positive, rule.seconds);
    rule.least_rounds = of.integer("least_rounds", 1, 10000, rule.least_rounds);
    rule.most_rounds = of.integer("most_rounds", 1, 10000, rule.most_rounds);
    rule.long_frame = of.number("long_frame", positive, rule.long_frame);
    return rule;
}

void require_different_names(const std::vector<StudyAxis>& axes, const JsonValue& place) {
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (axes[i].name == axes[j].name)
                place.fail(fmt::format("two axes are named '{}'", axes[i].name));
}

}  // namespace

Study parse_study(std::string_view text, const std::string& name) {
    const nlohmann::json document = scene_io::parse_json(text, name);
    const JsonObject fields(JsonValue(document, name, ""),
                            {"$schema", "title", "base", "timing", "axes"});
    static_cast<void>(fields.text("$schema", ""));
    Study study{
        fields.text("title", ""), read_changes(fields.find("base")), read_timing(fields), {}};
    const JsonValue axes = fields.at("axes");
    for (const JsonValue& axis : axes.elements(1, max_axes)) study.axes.push_back(read_axis(axis));
    require_different_names(study.axes, axes);
    return study;
}

Study read_study(const std::filesystem::path& path) {
    return parse_study(read_text_file(path, scene_io::max_json_bytes), path.string());
}

}  // namespace twofold
