#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "texunit/texture.hpp"

/// How far two pictures are apart. One step is 1/255, the distance of neighbouring 8-bit values.
namespace twofold {

/// The difference of two 8-bit pictures. A pixel is covered when its alpha is not 0: the background
/// of a scene has alpha 0.
struct PictureDifference {
    std::size_t pixels_compared = 0;
    std::size_t differing_pixels = 0;  ///< of the compared ones
    std::size_t coverage_differs =
        0;  ///< pixels of the whole picture covered in only one of the two
    std::optional<std::pair<int, int>> first_difference;  ///< x, y from the top left, in scan order
    int max_steps = 0;
    double rms_steps = 0.0;  ///< over the compared pixels and channels
    double psnr_db =
        std::numeric_limits<double>::infinity();  ///< peak 255 steps; infinite when equal
    std::array<std::size_t, 256>
        histogram{};                       ///< pixels by their largest channel difference in steps
    std::array<int, 4> max_per_channel{};  ///< steps in r, g, b, a
};

/// The difference of two float pictures. Two NaN are equal; any other pair with a value that is not
/// finite differs, but has no distance and enters neither maximum, RMS nor PSNR.
struct FloatDifference {
    std::size_t samples_compared = 0;
    std::size_t differing_samples = 0;
    std::size_t differing_pixels = 0;
    std::size_t without_distance = 0;  ///< differing samples of which one is not finite
    std::size_t coverage_differs = 0;  ///< counted only where the pictures have four channels
    std::optional<std::pair<int, int>> first_difference;  ///< x, y from the top left, in scan order
    double max_abs = 0.0;
    double rms = 0.0;
    double psnr_db = std::numeric_limits<double>::infinity();  ///< peak 1.0
};

/// All pixels, all channels: what `twofold compare` prints.
/// @throws Error with ExitCode::sizes_differ when width, height or channels differ
PictureDifference difference(const ByteImage& a, const ByteImage& b);
FloatDifference difference(const FloatImage& a, const FloatImage& b);

/// Red, green and blue of the pixels that are covered in both pictures, so that neither the
/// background nor the outline hides or makes a difference of colours.
/// @throws Error as `difference`; for float pictures also when there are not four channels
PictureDifference difference_where_covered(const ByteImage& a, const ByteImage& b);
FloatDifference difference_where_covered(const FloatImage& a, const FloatImage& b);

/// The colours of a heat map: the first stands for no difference, the second for the smallest and
/// the last for the largest, with even steps of brightness between ("inferno" of matplotlib).
extern const std::array<Rgba8, 10> heat_colors;

/// A pixel covered in only one picture; no heat colour comes near it.
inline constexpr Rgba8 coverage_color{0, 200, 255, 255};

/// A picture of the largest of the four channel differences per pixel.
/// Equal background is transparent, different coverage has `coverage_color`.
/// @param full_scale_steps the difference that gets the last heat colour; at least 1
ByteImage heat_map(const ByteImage& a, const ByteImage& b, int full_scale_steps);

}  // namespace twofold
