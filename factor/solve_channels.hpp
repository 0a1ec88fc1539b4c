#pragma once
#include <vector>

#include "factor/system.hpp"

namespace twofold {

/// When a fit with these settings stops.
StopRule stop_rule_of(const FactorSettings& settings);

/// Solves the systems of up to three channels, all of one left side, each from its own start. `qmr`
/// and `lsmr` run in lockstep and read the rows once for all channels; each channel has its own
/// recurrence and waits once it has ended. The results are those of the channels solved alone.
/// @param start unknowns D x of each
std::vector<Solution> solve_channels(Solver solver,
                                     const std::vector<const WeightedSystem*>& systems,
                                     const std::vector<Vector>& start, const StopRule& rule,
                                     int threads);

}  // namespace twofold
