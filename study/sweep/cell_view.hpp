#pragma once
#include <optional>
#include <string>

#include "study/sweep/run_study.hpp"

namespace twofold {

/// The figures of a cell that tables and figures show; what was not found is none.
struct CellView {
    std::string failed;              ///< why the cell could not be drawn; empty = it was
    std::optional<double> error;     ///< RMS against the exact picture, steps of 1/255
    std::optional<double> ideal;     ///< RMS of the values against the picture under ideal64, steps
    std::optional<double> relative;  ///< relative RMS against the exact picture
    std::optional<double> held_out;  ///< largest relative RMS of a channel at held-out samples
    std::optional<double> held_out_bytes;  ///< the same with the maps as bytes
    std::optional<double> frame;   ///< seconds a frame: its ratio to the common frame, times that
    std::optional<double> before;  ///< seconds of sampling and factoring, wall
    std::optional<double> card;    ///< predicted seconds a frame
};

/// The common frame's processor time: the median of what every cell has measured of it.
double anchor_seconds(const StudyResults& results);

CellView view_of(const nlohmann::ordered_json& result, double anchor);

/// The error by which cells are judged: against exact, or against ideal64 where nothing is exact.
std::optional<double> judged_error(const CellView& view);

/// "Map size: 32": the first place where each cell stands, by index.
std::vector<std::string> cell_names(const StudyPlan& plan);

}  // namespace twofold
