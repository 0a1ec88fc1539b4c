#pragma once
#include <optional>
#include <string>
#include <vector>

namespace twofold::bench {

/// One measurement of the factorisation.
struct FactorFigure {
    std::string work;
    std::string ours;             ///< with its unit
    std::string theirs;           ///< the peer's, or empty
    double value = 0.0;           ///< what the requirement is about
    std::string unit;             ///< of the value; "x" for a ratio to the peer
    std::optional<double> least;  ///< required at least, or ...
    std::optional<double> most;   ///< ... at most
};

std::string line_of(const FactorFigure& figure);
std::string markdown_of(const std::vector<FactorFigure>& figures);
std::string json_of(const std::vector<FactorFigure>& figures, const std::string& machine);

}  // namespace twofold::bench
