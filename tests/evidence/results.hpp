#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/evidence/comparison.hpp"
#include "texunit/error.hpp"

/// What came out of a whole pack, for people and for programs.
namespace twofold::evidence {

/// One capture: its comparison, or why there is none.
struct TestResult {
    std::string id;     ///< SUITE/TEST
    std::string error;  ///< empty if the description could be read and drawn
    Comparison comparison;
    std::optional<Expectation> expectation;
};

/// Sums over some tests.
struct Tally {
    int tests = 0;
    int passed = 0;      ///< equal but for pixels that the description lists
    int reproduced = 0;  ///< equal everywhere
    int unreadable = 0;
    long long compared = 0;
    long long wrong = 0;
    long long wrong_beyond = 0;  ///< of these, those that no description lists
};

/// True if every compared pixel is equal, or differs only where the description says so.
bool passed(const TestResult& result);

Tally tally_of(const std::vector<TestResult>& results);

/// The tests by suite, in the order of their first tests.
std::vector<std::pair<std::string, std::vector<TestResult>>> by_suite(
    const std::vector<TestResult>& results);

/// Tables for reading: suites, totals, and every test with a wrong pixel. FAILED marks what the
/// verdict holds against us, ELSEWHERE as many wrong pixels as expected in other places.
std::string text_of(const std::vector<TestResult>& results);

/// The same as JSON, and for each test the figures that its description expects.
nlohmann::ordered_json json_of(const std::vector<TestResult>& results, std::string_view preset);

/// bad_file if a test could not be read or drawn; ok if all others pass or, where the independent
/// renderer failed too, have no more wrong pixels than it had and at most 1 %; failure otherwise.
ExitCode verdict(const std::vector<TestResult>& results);

}  // namespace twofold::evidence
