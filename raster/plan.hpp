#pragma once
#include <string>
#include <vector>

#include "raster/pass.hpp"

namespace twofold {

/// One stage of the pipeline for one pass: whether it runs, for what reason, and what it costs.
struct PlannedStage {
    std::string stage;
    bool runs;
    std::string why;
    std::string cost;  ///< work a vertex or a fragment; empty if the stage does not run
};

/// The stages of a pass in pipeline order. A stage that is not called for is not simulated.
std::vector<PlannedStage> plan(const PassState& state);

/// Texels that one fragment of the pass reads at most.
int texel_fetches(const PassState& state);

}  // namespace twofold
