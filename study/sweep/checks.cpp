#include "study/sweep/checks.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

namespace twofold {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 28;

/// The value of an attribute of an XML element; empty if it has none.
std::string attribute(std::string_view element, std::string_view name) {
    const std::string begin = fmt::format(" {}=\"", name);
    const std::size_t at = element.find(begin);
    if (at == std::string_view::npos) return {};
    const std::size_t from = at + begin.size();
    return std::string(element.substr(from, element.find('"', from) - from));
}

/// The five entities of XML. @source XML 1.0, 4.6
std::string unescaped(std::string text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
    for (const auto& [entity, character] : entities)
        for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
            text.replace(at, entity.size(), 1, character);
    return text;
}

std::string title_of(const std::string& name) {
    const std::size_t colon = name.find(": ");
    return colon == std::string::npos ? name : name.substr(colon + 2);
}

std::string outcome_of(const std::string& status) {
    if (status == "run") return "passed";
    return status == "fail" ? "failed" : "skipped";
}

}  // namespace

std::map<std::string, std::string> checks_of(std::string_view junit) {
    std::map<std::string, std::string> outcomes;
    constexpr std::string_view open = "<testcase ";
    for (std::size_t at = 0; (at = junit.find(open, at)) != std::string_view::npos; ++at) {
        const std::string_view element = junit.substr(at, junit.find('>', at) - at);
        outcomes[title_of(unescaped(attribute(element, "name")))] =
            outcome_of(attribute(element, "status"));
    }
    return outcomes;
}

std::map<std::string, std::string> read_checks(const std::filesystem::path& path) {
    auto outcomes = checks_of(read_text_file(path, max_bytes));
    if (outcomes.empty()) throw Error(ExitCode::bad_file, path.string() + ": holds no test result");
    return outcomes;
}

}  // namespace twofold
