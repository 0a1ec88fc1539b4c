#include "bench/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace twofold::bench {

std::string heading() {
    return fmt::format("{:<42} {:<8} {:>9} {:>6} {:>6} {:>9}  {:<34} {}", "check", "preset",
                       "pixels", "cover", "seam", "equal", "pixels by step 0 1 2 3 4 more",
                       "worst/bound");
}

namespace {

std::string text_of(Rgba8 c) { return fmt::format("({}, {}, {}, {})", c.r, c.g, c.b, c.a); }

/// Only of a row that exceeds its bound in colour.
std::string worst_pixel(const Row& row) {
    if (row.result.worst <= row.bound.steps) return "";
    const PixelPair& p = row.result.worst_pixel;
    return fmt::format("\n    worst at ({}, {}): ours {}, theirs {}", p.x, p.y, text_of(p.ours),
                       text_of(p.theirs));
}

}  // namespace

std::string text_of(const Row& row) {
    const PictureComparison& r = row.result;
    return fmt::format("{:<42} {:<8} {:>9} {:>6} {:>6} {:>8.4f}%  {:<34} {}/{} {}{}{}", row.name,
                       name_of(row.preset), r.pixels, r.coverage, r.left_out,
                       100.0 * r.equal_share(), fmt::format("{}", fmt::join(r.steps, " ")), r.worst,
                       row.bound.steps, row.passed() ? "ok" : "FAIL", worst_pixel(row),
                       row.reason.empty() ? "" : "\n    " + row.reason);
}

std::string json_of(const Driver& driver, const std::string& version,
                    const std::vector<Row>& rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Row& row : rows)
        list.push_back({{"name", row.name},
                        {"preset", name_of(row.preset)},
                        {"pixels", row.result.pixels},
                        {"coverage", row.result.coverage},
                        {"left_out", row.result.left_out},
                        {"steps", row.result.steps},
                        {"worst", row.result.worst},
                        {"bound", {{"steps", row.bound.steps}, {"coverage", row.bound.coverage}}},
                        {"reason", row.reason},
                        {"passed", row.passed()}});
    const nlohmann::ordered_json report{{"driver", driver.name},
                                        {"version", version},
                                        {"filters_in_float", driver.filters_in_float},
                                        {"rows", list}};
    return report.dump(2) + "\n";
}

}  // namespace twofold::bench
