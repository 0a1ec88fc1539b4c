#pragma once
#include <span>
#include <vector>

#include "texunit/linear.hpp"

/// Reflectance spectra to linear RGB of the sRGB primaries.
namespace twofold {

/// Weights w_k of the wavelengths, R = sum_k w_k.x f_k and so on: the CIE 1931 2-degree observer
/// under D65, both tabulated every 10 nm from 400 to 700 nm and linear between (0 outside), by the
/// trapezoid rule; then scaled so that the spectrum 1 is (1, 1, 1).
/// @param wavelengths in nm, ascending, at least 2, some within 400 to 700
/// @source CIE 015:2018, tables 1 and 6; IEC 61966-2-1 for the primaries
std::vector<Rgb> spectrum_weights(std::span<const double> wavelengths);

/// Chromaticity (x, y) of the tables' white, D65 seen by the observer.
Vec2 tabulated_white();

}  // namespace twofold
