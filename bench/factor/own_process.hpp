#pragma once
#include <array>
#include <functional>

namespace twofold::bench {

/// Two figures that `work` finds in a copy of this process: its memory holds nothing of what was
/// measured before, and its largest resident set is its own. No thread may run yet.
/// @throws Error if the process fails
std::array<double, 2> in_own_process(const std::function<std::array<double, 2>()>& work);

}  // namespace twofold::bench
