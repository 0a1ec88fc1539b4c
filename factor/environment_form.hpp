#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "factor/environment.hpp"

namespace twofold {

/// What a point of a square map shows: a unit vector, and solid angle per area of the unit square
/// [-1, 1]^2; 0 where it shows nothing.
struct MapPoint {
    Vec3 direction;
    double density = 0.0;
};

/// A square map in a picture: its place in texels, and what lies at (a, b), a to the right and b
/// down, both -1 to 1.
struct SquareMap {
    int left = 0, top = 0, size = 0;
    std::function<MapPoint(double a, double b)> at;
};

/// The maps of a form other than latlong.
/// @throws Error(bad_file) where width and height are not of the form
std::vector<SquareMap> maps_of(EnvironmentForm form, double guard, int width, int height,
                               std::string_view name);

}  // namespace twofold
