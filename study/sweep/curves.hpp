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

/// The slope of the least-squares line; none for fewer than two different x.
std::optional<double> fitted_slope(std::span<const CurvePoint> points);

/// That of log y over log x: y grows as x to the power of it; none where a coordinate is not above
/// 0.
std::optional<double> fitted_power(std::span<const CurvePoint> points);

/// That of log2 y over x: y doubles so many times a unit; none where a y is not above 0.
std::optional<double> fitted_doublings(std::span<const CurvePoint> points);

}  // namespace twofold
