#pragma once
#include <string>
#include <utility>
#include <vector>

namespace twofold::bench {

/// A program that ran to its end.
struct ChildResult {
    std::string output;  ///< what it wrote to its standard output
    double wall = 0.0;   ///< seconds from before it was started to its end
};

/// Runs a program and waits for it.
/// @param command      the program's path and its arguments
/// @param environment  variables that it gets beside ours
/// @throws Error(bad_file) naming the program if it cannot be started or does not end with code 0
ChildResult run_child(const std::vector<std::string>& command,
                      const std::vector<std::pair<std::string, std::string>>& environment = {});

}  // namespace twofold::bench
