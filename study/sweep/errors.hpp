#pragma once
#include <vector>

#include "raster/framebuffer.hpp"
#include "study/metrics.hpp"

namespace twofold {

/// How far a cell's picture is from a reference, where both show the same surface.
struct CellErrors {
    PictureDifference steps;      ///< of the displayed bytes
    double real_rms_steps = 0.0;  ///< of the values that the framebuffers hold, in steps of 1/255
    double relative_rms = 0.0;    ///< of these values over the reference's rms; 0 if that is black
    double clipped_share = 0.0;   ///< pixels with a channel at 255 that the reference has below
    double vanished_share = 0.0;  ///< pixels with a channel at 0 that the reference has above
};

/// @param outline pixels that see another surface on the picture's snap grid; empty = none
/// @throws Error if the sizes differ
CellErrors errors_between(const Framebuffer& picture, const Framebuffer& reference,
                          const std::vector<bool>& outline);

}  // namespace twofold
