#include "bench/factor/against.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/draw/timing.hpp"

namespace twofold::bench {

FactorFigure against(std::string work, double ours, std::optional<double> theirs, double units,
                     const std::string& unit, std::optional<double> least) {
    const auto each = [&](double seconds) {
        return fmt::format("{:.3g} {}", seconds / units, unit);
    };
    FactorFigure figure{std::move(work), each(ours), "", 0.0, "x", std::nullopt, std::nullopt};
    if (!theirs) return figure;
    figure.theirs = each(*theirs);
    figure.value = *theirs / ours;
    figure.least = least;
    return figure;
}

void Rounds::add(double ours, std::optional<double> theirs) {
    ours_.push_back(ours);
    if (theirs) theirs_.push_back(*theirs);
}

FactorFigure Rounds::against_peer(const std::string& work, double units, const std::string& unit,
                                  std::optional<double> least) const {
    if (theirs_.size() != ours_.size())
        return against(work, median(ours_), std::nullopt, units, unit, least);
    FactorFigure figure = against(work, median(ours_), median(theirs_), units, unit, least);
    std::vector<double> ratios;
    for (std::size_t k = 0; k < ours_.size(); ++k) ratios.push_back(theirs_[k] / ours_[k]);
    const auto [lowest, highest] = std::minmax_element(ratios.begin(), ratios.end());
    figure.theirs += fmt::format(" ({:.2f} to {:.2f} x)", *lowest, *highest);
    figure.value = median(ratios);
    return figure;
}

}  // namespace twofold::bench
