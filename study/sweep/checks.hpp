#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace twofold {

/// The outcome of each test, by its title without the name of its program: "passed", "failed" or
/// "skipped".
/// @param junit what `ctest --output-junit` writes
std::map<std::string, std::string> checks_of(std::string_view junit);

/// @throws Error if the file cannot be read or holds no test
std::map<std::string, std::string> read_checks(const std::filesystem::path& path);

}  // namespace twofold
