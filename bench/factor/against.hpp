#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/factor/report.hpp"

namespace twofold::bench {

/// How many times faster than a peer a work is done.
/// @param ours, theirs seconds; without a peer there is no ratio
/// @param units that a second is divided by, named `unit`
FactorFigure against(std::string work, double ours, std::optional<double> theirs, double units,
                     const std::string& unit, std::optional<double> least);

/// Ours and the peer's in turn: their ratio scatters.
class Rounds {
  public:
    void add(double ours, std::optional<double> theirs);

    /// Medians, and the extremes of the ratio.
    FactorFigure against_peer(const std::string& work, double units, const std::string& unit,
                              std::optional<double> least) const;

  private:
    std::vector<double> ours_, theirs_;
};

}  // namespace twofold::bench
