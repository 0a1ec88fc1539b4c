#include "bench/draw/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "texunit/error.hpp"

namespace twofold::bench {
namespace {

std::string wanted(const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", *value) : "-";
}

/// What of the target is met.
std::string_view verdict(const Target& target, double value, bool more_is_better) {
    const auto met = [&](const std::optional<double>& want) {
        return want && (more_is_better ? value >= *want : value <= *want);
    };
    if (met(target.aim)) return "aim";
    if (met(target.floor)) return "floor";
    return target.floor ? "MISSED" : target.aim ? "aim missed" : "";
}

/// The cells of a row: work, ours, ns/px, peer, ns/px, ratio, spread, floor, aim, what is met.
std::array<std::string, 10> cells_of(const Row& row) {
    const Target& t = row.duel.target;
    std::array<std::string, 10> cells;
    cells.fill(std::string(1, '-'));
    cells[0] = row.work;
    cells[1] = row.duel.ours;
    cells[2] = fmt::format("{:.3f}", row.our_ns_per_pixel());
    if (row.peer.empty()) return cells;
    const auto ratios = row.ratios();
    const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
    const double ratio = median(ratios);
    cells[3] = row.duel.peer;
    cells[4] = fmt::format("{:.3f}", row.peer_ns_per_pixel());
    cells[5] = fmt::format("{:.2f}", ratio);
    cells[6] = fmt::format("{:.2f}-{:.2f}", *low, *high);
    cells[7] = wanted(t.floor);
    cells[8] = wanted(t.aim);
    cells[9] = verdict(t, ratio, true);
    return cells;
}

std::string markdown_row(const Row& row) {
    return fmt::format("| {} |\n", fmt::join(cells_of(row), " | "));
}

std::string markdown_series(const Series& s) {
    std::string text;
    for (std::size_t i = 0; i < s.steps.size(); ++i) {
        const auto [units, seconds] = s.steps[i];
        text += fmt::format("| {} | {:.0f} {}s | {:.3f} | {:.3f} | {} |\n", s.work, units, s.unit,
                            1e3 * seconds, 1e9 * seconds / units,
                            i == 0 ? "-" : fmt::format("{:.3f}", 1e9 * s.slope(i)));
    }
    return text;
}

std::string markdown_figure(const Figure& f) {
    return fmt::format("| {} | {:.2f} {} | {} | {} | {} | {} |\n", f.name, f.value, f.unit,
                       wanted(f.most.floor), wanted(f.most.aim), verdict(f.most, f.value, false),
                       f.note);
}

std::string markdown_picture(const PictureCheck& check) {
    const PictureComparison& d = check.difference;
    return fmt::format("| {} | {} | {} | {:.3f} % | {} | {} | {} |\n", check.work, check.ours,
                       check.peer, 100.0 * d.equal_share(), d.worst, d.steps[5], d.coverage);
}

/// Nothing without values.
template <class T>
std::string table(const std::string& heading, const std::vector<T>& values,
                  std::string (*lines)(const T&)) {
    if (values.empty()) return {};
    std::string text = "\n" + heading + "\n|";
    for (auto bars = std::count(heading.begin(), heading.end(), '|'); bars > 1; --bars)
        text += "---|";
    text += "\n";
    for (const T& value : values) text += lines(value);
    return text;
}

}  // namespace

std::string row_heading() {
    return fmt::format("{:<54} {:<18} {:>8}  {:<25} {:>8} {:>6} {:>13} {:>5} {:>5}  {}", "work",
                       "ours", "ns/px", "peer", "ns/px", "ratio", "spread", "floor", "aim", "met");
}

std::string line_of(const Row& row) {
    const auto c = cells_of(row);
    return fmt::format("{:<54} {:<18} {:>8}  {:<25} {:>8} {:>6} {:>13} {:>5} {:>5}  {}", c[0], c[1],
                       c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9]);
}

std::string line_of(const PictureCheck& check) {
    const PictureComparison& d = check.difference;
    return fmt::format(
        "picture of {}, {}: {:.3f}% equal to {}, pixels by step 0 1 2 3 4 more {}, worst {}, "
        "{} pixels drawn by one only: {}",
        check.work, check.ours, 100.0 * d.equal_share(), check.peer, fmt::join(d.steps, " "),
        d.worst, d.coverage, check.passed() ? "ok" : "ANOTHER PICTURE");
}

std::string line_of(const Figure& f) {
    return fmt::format("{}: {:.2f} {} (floor {}, aim {}) {} {}", f.name, f.value, f.unit,
                       wanted(f.most.floor), wanted(f.most.aim), verdict(f.most, f.value, false),
                       f.note);
}

std::string lines_of(const Series& s) {
    std::string text;
    for (std::size_t i = 0; i < s.steps.size(); ++i) {
        const auto [units, seconds] = s.steps[i];
        text += fmt::format("{:<36} {:>8.0f} {}s: {:>9.3f} ms, {:>10.3f} ns each", s.work, units,
                            s.unit, 1e3 * seconds, 1e9 * seconds / units);
        if (i > 0) text += fmt::format(", {:.3f} ns for each more", 1e9 * s.slope(i));
        text += "\n";
    }
    return text;
}

std::string markdown_of(const DrawReport& report) {
    return report.machine + "\n" +
           table("| work | ours | ns/px | peer | its ns/px | ratio | spread | floor | aim | met |",
                 report.rows, markdown_row) +
           table("| figure | value | at most | better at most | met | note |", report.figures,
                 markdown_figure) +
           table("| cost of (nv17) | amount | ms | ns each | ns for each more |", report.growth,
                 markdown_series) +
           table(
               "| picture | ours | peer | equal | worst step | over 4 steps | drawn by one only |",
               report.pictures, markdown_picture);
}

std::string with_table(const std::string& document, const std::string& table,
                       const std::string& file, const std::string& program) {
    const std::string begin_marker = fmt::format("<!-- {}: begin -->\n", program);
    const std::string end_marker = fmt::format("<!-- {}: end -->", program);
    const std::size_t begin = document.find(begin_marker), end = document.find(end_marker);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw Error(ExitCode::bad_file,
                    fmt::format("{}: no line {} before a line {}", file,
                                begin_marker.substr(0, begin_marker.size() - 1), end_marker));
    return document.substr(0, begin + begin_marker.size()) + table + document.substr(end);
}

}  // namespace twofold::bench
