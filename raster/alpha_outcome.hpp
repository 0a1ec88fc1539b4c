#pragma once
#include <cstdint>

namespace twofold {

/// What the alpha test of a pass does with a triangle.
enum class AlphaOutcome : std::uint8_t { open, fails, passes };

}  // namespace twofold
