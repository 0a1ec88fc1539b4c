#pragma once
#include <functional>
#include <string_view>

#include "factor/environment.hpp"

/// What all forms of environment pictures have in common: their values.
namespace twofold {

/// @throws Error(bad_file) where width, height, channels and number of values make no picture
void check_size(const FloatImage& image, std::string_view name);

/// @throws Error(failure) unless cells >= 1
void check_cells(int cells);

std::size_t texel_count(const FloatImage& image);

/// The value to use: 0 for what is negative (ringing of a filter, D01), NaN or infinite.
double radiance_value(const FloatImage& image, std::size_t texel, int channel);

/// @throws Error(bad_file) that names the first value that is not finite
void refuse_non_finite(const FloatImage& image, std::string_view name);

/// The part of the report that is about the picture: size, counts of values, the brightest texel.
/// @param solid_angle of texel i; 0 where it shows no direction
EnvironmentReport describe_values(const FloatImage& image,
                                  const std::function<double(std::size_t)>& solid_angle);

}  // namespace twofold
