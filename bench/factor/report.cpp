#include "bench/factor/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace twofold::bench {
namespace {

std::string wanted(const FactorFigure& f) {
    if (f.least) return fmt::format(">= {:g} {}", *f.least, f.unit);
    return f.most ? fmt::format("<= {:g} {}", *f.most, f.unit) : "-";
}

std::string verdict(const FactorFigure& f) {
    if (!f.least && !f.most) return "";
    const bool met = f.least ? f.value >= *f.least : f.value <= *f.most;
    return met ? "met" : "MISSED";
}

}  // namespace

std::string line_of(const FactorFigure& f) {
    return fmt::format("{:<44} {:>24} {:>24} {:>10.2f} {:<4} {:<12} {}", f.work, f.ours, f.theirs,
                       f.value, f.unit, wanted(f), verdict(f));
}

std::string markdown_of(const std::vector<FactorFigure>& figures) {
    std::string text =
        "| work | twofold | peer | figure | required | |\n|---|---|---|---|---|---|\n";
    for (const FactorFigure& f : figures)
        text +=
            fmt::format("| {} | {} | {} | {:.2f} {} | {} | {} |\n", f.work, f.ours,
                        f.theirs.empty() ? "-" : f.theirs, f.value, f.unit, wanted(f), verdict(f));
    return text;
}

std::string json_of(const std::vector<FactorFigure>& figures, const std::string& machine) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const FactorFigure& f : figures)
        list.push_back({{"work", f.work},
                        {"ours", f.ours},
                        {"peer", f.theirs},
                        {"value", f.value},
                        {"unit", f.unit},
                        {"required", wanted(f)},
                        {"verdict", verdict(f)}});
    return nlohmann::ordered_json{{"machine", machine}, {"figures", list}}.dump(2) + "\n";
}

}  // namespace twofold::bench
