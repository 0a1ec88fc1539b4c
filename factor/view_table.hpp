#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "texunit/linear.hpp"

/// The third factor g(n.v), a project extension: a table over the cosine of the viewing angle that
/// is looked up at each vertex and multiplied into the vertex colour, so that it costs no texture.
/// Knot k of K stands at n.v = (k / (K - 1))^2: grazing angles, where Fresnel's and the masking
/// term bend, get the closer ones.
namespace twofold {

/// The two knots that a cosine lies between, and their weights, which sum to 1.
struct ViewFootprint {
    std::array<std::uint32_t, 2> index{};
    std::array<double, 2> weight{};
};

/// @param cosine n.v; below 0 it counts as 0 @param knots >= 2
ViewFootprint view_footprint(double cosine, int knots);

/// The table's value at a cosine, linear between knots; 1 for an empty table.
double view_value(std::span<const double> table, double cosine);
Rgb view_value(std::span<const Rgb> table, double cosine);

}  // namespace twofold
