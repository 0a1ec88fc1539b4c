#pragma once
#include <optional>

#include "bench/check.hpp"

namespace twofold::bench {

/// Where a driver is known to leave a check's bound, how far, and why.
struct Deviation {
    std::string reason;
    Bound bound;
};

/// None: the check's own bound holds.
std::optional<Deviation> known_deviation(const Driver& driver, const std::string& check,
                                         Preset preset);

}  // namespace twofold::bench
