#pragma once
#include "raster/pass.hpp"

namespace twofold {

/// Largest edge of a picture and of a texture, and largest number of pixels or texels.
inline constexpr int largest_edge = 16384;
inline constexpr std::size_t largest_area = std::size_t{1} << 28;

/// @throws Error naming what is wrong: a size out of range, an index that names nothing, an array
/// of the
///         wrong length, an rgb_scale other than 1, 2, 4.
void check_frame(const Frame& frame);

}  // namespace twofold
