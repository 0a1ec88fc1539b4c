#pragma once
#include <utility>
#include <vector>

#include "tests/evidence/description.hpp"

/// Exact comparison of a drawing with a capture, without any tolerance.
namespace twofold::evidence {

struct Comparison {
    int compared = 0;                        ///< pixels in the region
    int max_difference = 0;                  ///< largest of all channels, in steps of a byte
    std::vector<std::pair<int, int>> wrong;  ///< x, y of every pixel that differs, row by row
    std::vector<std::pair<int, int>> wrong_beyond;  ///< of these, those that nobody expected
};

/// @param expected pixels that may differ
/// @throws Error if the pictures differ in size or the region reaches out of them
Comparison compare(const ByteImage& ours, const ByteImage& capture, const CompareRegion& region,
                   const std::vector<std::pair<int, int>>& expected);

/// The capture in dark grey, lighter within the region; each wrong pixel red, the more yellow the
/// larger its difference.
ByteImage difference_picture(const ByteImage& ours, const ByteImage& capture,
                             const CompareRegion& region);

}  // namespace twofold::evidence
