#pragma once
#include <vector>

#include "factor/system.hpp"

namespace twofold {

/// The start vector of a solve.
struct FirstGuess {
    Vector x;                   ///< logarithms of map 1, then of map 2
    std::size_t untouched = 0;  ///< texels of both maps that no used sample touches
};

/// Texels that samples touch start at the weighted mean of the samples' logarithms, less half the
/// mean of all, which each map carries once; the others at the inverse-distance mean of the touched
/// texels of their own map, with chord distance d of the texels' directions and weights d^-power
/// (where directions coincide, the value of the first such texel). Knots of g(n.v) start at their
/// mean less that of all, or at 0. A mean of values is never the
/// largest, so no filled texel owns the maximum of a map.
/// @source seed paper, section 3.1, which states neither power nor metric
FirstGuess first_guess(const LogRows& left, const ChannelRows& right, double power, int threads);

/// Fills the texels of one map that have no weight as first_guess() does, `first` being the map's
/// first unknown. @return how many those are
std::size_t fill_untouched(Vector& x, const Vector& weight, std::size_t first,
                           const MapShape& shape, double power, int threads);

}  // namespace twofold
