#pragma once
#include <optional>
#include <string>

#include "raster/framebuffer.hpp"

namespace twofold::test {

/// Where two pictures of one frame part, to the bit: bytes and values.
struct PictureMismatch {
    std::size_t pixels = 0;  ///< how many differ
    int x = 0, y = 0;        ///< the first, row by row
    std::string text;        ///< both pictures' bytes and values there, or their sizes
};

/// None if every byte and every bit of every value is the same; NaN equals itself and -0 is not 0.
/// Counters are not compared: only the reference counts.
std::optional<PictureMismatch> mismatch_of(const Framebuffer& expected, const Framebuffer& found);

}  // namespace twofold::test
