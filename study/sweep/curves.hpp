#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace twofold {

/// A pair of what something costs and how far it is from the truth, or of a setting and an error.
struct CurvePoint {
    double x = 0.0, y = 0.0;
};

/// The points that no other beats: none is smaller in one coordinate and not larger in the other.
/// Points equal in both are kept once.
/// @return their indices by ascending x
std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points);

/// The least-squares slope of log y over log x: y grows as x to the power of it.
/// @return none for fewer than two different x, or where a coordinate is not above 0
std::optional<double> fitted_slope(std::span<const CurvePoint> points);

}  // namespace twofold
