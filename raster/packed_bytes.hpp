#pragma once
#include <cstdint>

#include "texunit/numeric_model.hpp"

namespace twofold {

/// Four channels of 0..255 in one word, red lowest.
inline std::uint32_t packed_bytes(const Color<int>& c) {
    return static_cast<std::uint32_t>(c[0]) | static_cast<std::uint32_t>(c[1]) << 8 |
           static_cast<std::uint32_t>(c[2]) << 16 | static_cast<std::uint32_t>(c[3]) << 24;
}

inline Color<int> unpacked_bytes(std::uint32_t p) {
    return {static_cast<int>(p & 255), static_cast<int>(p >> 8 & 255),
            static_cast<int>(p >> 16 & 255), static_cast<int>(p >> 24)};
}

}  // namespace twofold
