#include "tests/evidence/results.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace twofold::evidence {
namespace {

/// Longer lists of pixels are cut: they say no more than a picture does.
constexpr std::size_t most_listed_pixels = 200;

/// Largest share of wrong pixels in a test that was never reproduced.
constexpr double tolerated_share = 0.01;

std::string suite_of(const std::string& id) { return id.substr(0, id.find('/')); }

std::string row(const std::string& name, const Tally& t) {
    return fmt::format("{:<32} {:>6} {:>7} {:>11} {:>10} {:>9} {:>9}\n", name, t.tests, t.passed,
                       t.reproduced, t.compared, t.wrong, t.wrong_beyond);
}

/// What nobody reproduced may deviate elsewhere, in no more pixels than the independent renderer
/// did.
bool is_near_miss(const TestResult& result) {
    if (!result.expectation || result.expectation->reproduced) return false;
    const auto wrong = static_cast<double>(result.comparison.wrong.size());
    return wrong <= result.expectation->pixels_wrong &&
           wrong <= tolerated_share * result.comparison.compared;
}

/// What the eye should catch at the start of a line.
std::string_view mark_of(const TestResult& result) {
    if (passed(result)) return "";
    return is_near_miss(result) ? "ELSEWHERE " : "FAILED ";
}

std::string expected_text(const TestResult& result) {
    if (!result.expectation) return "";
    return fmt::format(", {} expected", result.expectation->pixels_wrong);
}

std::string line_of(const TestResult& result) {
    const Comparison& c = result.comparison;
    if (!result.error.empty()) return fmt::format("  {}: NOT DRAWN: {}\n", result.id, result.error);
    const auto [x, y] = c.wrong.front();
    return fmt::format(
        "  {}{}: {} of {} pixels wrong{}, {} of them not listed, max {}, first at "
        "({}, {})\n",
        mark_of(result), result.id, c.wrong.size(), c.compared, expected_text(result),
        c.wrong_beyond.size(), c.max_difference, x, y);
}

nlohmann::ordered_json json_of(const Tally& t) {
    return {{"tests", t.tests},
            {"passed", t.passed},
            {"reproduced", t.reproduced},
            {"not_drawn", t.unreadable},
            {"pixels_compared", t.compared},
            {"pixels_wrong", t.wrong},
            {"pixels_wrong_not_listed", t.wrong_beyond}};
}

nlohmann::ordered_json json_of(const Expectation& e) {
    return {{"reproduced", e.reproduced},
            {"pixels_compared", e.pixels_compared},
            {"pixels_drawn_by_model", e.pixels_drawn},
            {"pixels_wrong", e.pixels_wrong},
            {"max_difference", e.max_difference}};
}

nlohmann::ordered_json json_of(const TestResult& result) {
    nlohmann::ordered_json json{{"id", result.id}, {"passed", passed(result)}};
    if (!result.error.empty()) json["error"] = result.error;
    const Comparison& c = result.comparison;
    json["pixels_compared"] = c.compared;
    json["pixels_wrong"] = c.wrong.size();
    json["pixels_wrong_not_listed"] = c.wrong_beyond.size();
    json["max_difference"] = c.max_difference;
    nlohmann::ordered_json pixels = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < std::min(c.wrong.size(), most_listed_pixels); ++i)
        pixels.push_back({c.wrong[i].first, c.wrong[i].second});
    json["wrong_pixels_xy"] = std::move(pixels);
    if (result.expectation) json["expected"] = json_of(*result.expectation);
    return json;
}

}  // namespace

bool passed(const TestResult& result) {
    return result.error.empty() && result.comparison.wrong_beyond.empty();
}

Tally tally_of(const std::vector<TestResult>& results) {
    Tally t;
    for (const TestResult& result : results) {
        const Comparison& c = result.comparison;
        const bool drawn = result.error.empty();
        ++t.tests;
        t.passed += passed(result) ? 1 : 0;
        t.reproduced += drawn && c.wrong.empty() ? 1 : 0;
        t.unreadable += drawn ? 0 : 1;
        t.compared += c.compared;
        t.wrong += static_cast<long long>(c.wrong.size());
        t.wrong_beyond += static_cast<long long>(c.wrong_beyond.size());
    }
    return t;
}

std::vector<std::pair<std::string, std::vector<TestResult>>> by_suite(
    const std::vector<TestResult>& results) {
    std::vector<std::pair<std::string, std::vector<TestResult>>> suites;
    for (const TestResult& result : results) {
        const std::string name = suite_of(result.id);
        if (suites.empty() || suites.back().first != name) suites.push_back({name, {}});
        suites.back().second.push_back(result);
    }
    return suites;
}

std::string text_of(const std::vector<TestResult>& results) {
    std::string text = fmt::format("{:<32} {:>6} {:>7} {:>11} {:>10} {:>9} {:>9}\n", "suite",
                                   "tests", "passed", "reproduced", "pixels", "wrong", "unlisted");
    for (const auto& [name, members] : by_suite(results)) text += row(name, tally_of(members));
    text += row("all", tally_of(results));
    for (const TestResult& result : results)
        if (!result.error.empty() || !result.comparison.wrong.empty()) text += line_of(result);
    return text;
}

nlohmann::ordered_json json_of(const std::vector<TestResult>& results, std::string_view preset) {
    nlohmann::ordered_json json{{"preset", preset}, {"total", json_of(tally_of(results))}};
    for (const auto& [name, members] : by_suite(results))
        json["suites"][name] = json_of(tally_of(members));
    json["tests"] = nlohmann::ordered_json::array();
    for (const TestResult& result : results) json["tests"].push_back(json_of(result));
    return json;
}

ExitCode verdict(const std::vector<TestResult>& results) {
    const auto missed = [](const TestResult& r) { return !passed(r) && !is_near_miss(r); };
    for (const TestResult& result : results)
        if (!result.error.empty()) return ExitCode::bad_file;
    return std::any_of(results.begin(), results.end(), missed) ? ExitCode::failure : ExitCode::ok;
}

}  // namespace twofold::evidence
