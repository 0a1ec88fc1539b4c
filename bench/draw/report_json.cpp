#include <nlohmann/json.hpp>

#include "bench/draw/report.hpp"

namespace twofold::bench {
namespace {

using Json = nlohmann::ordered_json;

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const Target& target) {
    return {{"floor", optional(target.floor)}, {"aim", optional(target.aim)}};
}

Json json_of(const Row& row) {
    Json json{{"work", row.work},
              {"ours", row.duel.ours},
              {"clock", row.duel.wall ? "wall" : "processor"},
              {"pixels", row.pixels},
              {"ns_per_pixel", row.our_ns_per_pixel()},
              {"typical_cpu_ns_per_pixel", 1e9 * row.our_median / row.pixels},
              {"target", json_of(row.duel.target)},
              {"seconds", row.ours}};
    if (row.peer.empty()) return json;
    const auto ratios = row.ratios();
    json["peer"] = {{"name", row.duel.peer},
                    {"ns_per_pixel", row.peer_ns_per_pixel()},
                    {"head_start", row.duel.head_start},
                    {"seconds", row.peer}};
    json["ratio"] = median(ratios);
    json["ratios"] = ratios;
    return json;
}

Json json_of(const PictureCheck& check) {
    const PictureComparison& d = check.difference;
    return {{"work", check.work},     {"ours", check.ours},      {"peer", check.peer},
            {"pixels", d.pixels},     {"steps", d.steps},        {"worst", d.worst},
            {"coverage", d.coverage}, {"passed", check.passed()}};
}

Json json_of(const Series& series) {
    Json steps = Json::array();
    for (const auto& [units, seconds] : series.steps)
        steps.push_back({{"units", units}, {"seconds", seconds}});
    return {{"work", series.work}, {"unit", series.unit}, {"steps", steps}};
}

Json json_of(const Figure& f) {
    return {{"name", f.name},
            {"value", f.value},
            {"unit", f.unit},
            {"most", json_of(f.most)},
            {"note", f.note}};
}

template <class T>
Json list_of(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(json_of(value));
    return list;
}

}  // namespace

std::string json_of(const DrawReport& report) {
    const Json json{{"machine", report.machine},
                    {"pictures", list_of(report.pictures)},
                    {"rows", list_of(report.rows)},
                    {"growth", list_of(report.growth)},
                    {"figures", list_of(report.figures)}};
    return json.dump(2) + "\n";
}

}  // namespace twofold::bench
