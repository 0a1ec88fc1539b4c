#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "texunit/linear.hpp"

/// Measured isotropic BRDFs as their files hold them. Directions are unit vectors in the frame of
/// the surface, normal +z, both pointing away from it: wi to the light, wo to the viewer.
namespace twofold {

/// What the values of a channel are, as stored. A value is counted once, under the first that
/// applies.
struct ValueCounts {
    std::size_t values = 0;
    std::size_t not_finite = 0;  ///< left out
    std::size_t negative = 0;    ///< MERL: marks of "not measured", left out; else read as 0
    std::size_t zero = 0;

    void add(double value);
    bool operator==(const ValueCounts&) const = default;
};

/// One measurement. A channel that was not measured is NaN.
struct BrdfSample {
    Vec3 wi, wo;
    Rgb f;  ///< per steradian, linear, sRGB primaries
};

/// A measured BRDF: a function with gaps, or scattered samples.
struct MeasuredData {
    /// f(wi, wo) where the file says so or interpolates by a stated rule; a channel without a value
    /// is NaN. Defined for both directions above the horizon.
    std::function<Rgb(Vec3 wi, Vec3 wo)> value;
    std::vector<BrdfSample> scattered;  ///< the file's own, if it is not a grid
    std::array<ValueCounts, 3> counts;
};

/// MERL: three int32 90, 90, 180, then three planes of 1,458,000 doubles over (theta_h, theta_d,
/// phi_d), to be scaled by 1/1500, 1.15/1500 and 1.66/1500. A negative value marks a bin that was
/// not measured and is left out, channel by channel. `value` is that of the bin that holds (wi,
/// wo).
/// @throws Error(bad_file) on any other size or dimensions; a Git LFS pointer is called one
/// @source Matusik et al., A Data-Driven Reflectance Model, 2003, and its BRDFRead.cpp
MeasuredData parse_merl(std::span<const unsigned char> bytes, std::string_view name);

/// Cornell text: number of wavelengths, wavelengths in nm, then rows theta_i phi_i theta_o phi_o in
/// radians and f at each wavelength; `#` starts a comment. Spectra become linear sRGB by the CIE
/// 1931 observer under D65 (factor/spectrum.hpp). `value` is scattered_value().
/// @throws Error(bad_file) that names the number which cannot be
/// @source Cornell University Program of Computer Graphics; Pharr & Humphreys, PBRT, 8.5
MeasuredData parse_cornell(std::string_view text, std::string_view name);

/// EPFL-RGL isotropic tensor file, linear RGB. Its value f cos(theta_o) is divided by the cosine.
/// Colours outside the gamut, stored negative, are 0, as its authors' loader has it.
/// @throws Error(bad_file) naming the field that is missing, misshapen or beyond the file
/// @source Dupuy & Jakob, An Adaptive Parameterization for Efficient Material Acquisition, 2018
MeasuredData parse_rgl(std::span<const unsigned char> bytes, std::string_view name);

/// Scattered samples interpolated: the mean of the 8 nearest, ties by index, weighted by
/// ((R - d) / (R d))^2, R the distance of the 9th. Distances are taken between (sin ti sin to,
/// |dphi| / pi, cos ti cos to), in which a pair and its reciprocal are one point.
/// @source PBRT, 8.5.2 (the space); Franke & Nielson, Smooth Interpolation, 1980 (the weights)
std::function<Rgb(Vec3 wi, Vec3 wo)> scattered_value(std::vector<BrdfSample> samples);

}  // namespace twofold
