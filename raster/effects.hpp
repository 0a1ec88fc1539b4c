#pragma once
#include <string>
#include <vector>

#include "raster/pass.hpp"

namespace twofold {

/// An effect that is on in some pass of a frame, and the frame with the effect left out of them
/// all.
struct Effect {
    std::string name;
    Frame without;
};

/// The effects of a frame in pipeline order. What normalized() drops is not on.
std::vector<Effect> effects_of(const Frame& frame);

}  // namespace twofold
