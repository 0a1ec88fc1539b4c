#include <fmt/format.h>

#include "study/sweep/study_file.hpp"
#include "texunit/error.hpp"

/// The shipped studies, made into string views by study/report/embed.cmake.
namespace twofold::report_files {
extern const std::string_view quick_json, full_json;
}

namespace twofold {

Study shipped_study(std::string_view name) {
    if (name == "quick") return parse_study(report_files::quick_json, "quick.json");
    if (name == "full") return parse_study(report_files::full_json, "full.json");
    throw Error(ExitCode::failure,
                fmt::format("no shipped study is named '{}'; there are: quick full", name));
}

}  // namespace twofold
