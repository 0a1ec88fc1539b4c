#pragma once
#include <string>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/custom.hpp"
#include "texunit/preset.hpp"

namespace twofold {

/// What an effect adds to a frame, in percent of the frame's processor time; negative if the frame
/// takes longer without it, as where a test keeps fragments from being finished.
struct EffectCost {
    std::string effect;
    double percent;      ///< median of the rounds
    double least, most;  ///< their extremes
};

struct FrameCost {
    double seconds;  ///< processor time of the whole frame, median of the rounds
    std::vector<EffectCost> effects;
};

/// Draws the frame by the fast pipeline on one thread, with everything and without each effect in
/// turn, `rounds` times over.
FrameCost measure_cost(const Frame& frame, Preset preset, const CustomSettings& custom, int rounds);

}  // namespace twofold
