#include <fmt/format.h>

#include "study/sweep/cell_view.hpp"
#include "study/sweep/study_page.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

/// Quoted where it must be. @source RFC 4180
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted(1, '"');
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    quoted.push_back('"');
    return quoted;
}

std::string number(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

/// A value at a path of the result, as JSON pointers name it; empty where there is none.
std::string at(const Json& result, const char* pointer) {
    const Json::json_pointer path(pointer);
    if (!result.contains(path) || result.at(path).is_null()) return "";
    const Json& value = result.at(path);
    return field(value.is_string() ? value.get<std::string>() : value.dump());
}

constexpr std::array<std::pair<const char*, const char*>, 26> columns{{
    {"preset", "/preset"},
    {"technique", "/technique"},
    {"way", "/way"},
    {"filter", "/filter"},
    {"rms_steps", "/errors/exact/rms_steps"},
    {"real_rms_steps", "/errors/exact/real_rms_steps"},
    {"max_steps", "/errors/exact/max_steps"},
    {"psnr_db", "/errors/exact/psnr_db"},
    {"relative_rms", "/errors/exact/relative_rms"},
    {"clipped_share", "/errors/exact/clipped_share"},
    {"vanished_share", "/errors/exact/vanished_share"},
    {"ideal64_rms_steps", "/errors/ideal64/rms_steps"},
    {"ideal64_real_rms_steps", "/errors/ideal64/real_rms_steps"},
    {"ideal64_max_steps", "/errors/ideal64/max_steps"},
    {"ideal64_psnr_db", "/errors/ideal64/psnr_db"},
    {"passes", "/counts/passes"},
    {"texture_bytes", "/counts/texture_bytes"},
    {"texel_fetches", "/counts/texel_fetches"},
    {"frame_processor_least_s", "/times/frame/processor/least"},
    {"frame_processor_s", "/times/frame/processor/median"},
    {"frame_wall_s", "/times/frame/wall/median"},
    {"frame_rounds", "/times/frame/rounds"},
    {"factoring_processor_s", "/times/factoring/processor"},
    {"predicted_card_s", "/card/seconds"},
    {"picture_hash", "/picture/hash"},
    {"failed", "/failed"},
}};

std::string row(const PlannedAxis& axis, const PlannedPoint& point, const Json& result,
                double anchor) {
    const CellView view = view_of(result, anchor);
    std::string line =
        fmt::format("{},{},{},{},{},{},{}", axis.name, field(point.label), number(point.value),
                    field(point.scene), at(result, "/id"), number(view.frame), number(view.before));
    for (const auto& [name, pointer] : columns) line += fmt::format(",{}", at(result, pointer));
    return line + "\n";
}

}  // namespace

std::string study_csv(const StudyResults& results) {
    std::string csv = "axis,label,value,scene,cell,frame_s,before_s";
    for (const auto& [name, pointer] : columns) csv += fmt::format(",{}", name);
    csv += "\n";
    const double anchor = anchor_seconds(results);
    for (const PlannedAxis& axis : results.plan.axes)
        for (const PlannedPoint& point : axis.points)
            csv += row(axis, point, results.cells.at(results.plan.cells[point.cell].id), anchor);
    return csv;
}

}  // namespace twofold
