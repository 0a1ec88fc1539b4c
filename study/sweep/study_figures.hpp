#pragma once
#include <string>
#include <vector>

#include "study/sweep/run_study.hpp"

namespace twofold {

/// A figure of a study, ready for the page and for a file.
struct StudyFigure {
    std::string name;  ///< of the file, without its ending
    std::string heading;
    std::string remark;  ///< what it shows, in a sentence or two
    std::string svg;
};

/// Error over the time of a frame, over the time before the first frame, and over the card's
/// predicted time: all cells, with the front of those that no other beats.
std::vector<StudyFigure> trade_figures(const StudyResults& results);

/// What each stage alone costs, and what it gives back: axes with the plot `budget`.
std::vector<StudyFigure> budget_figures(const StudyResults& results);

/// The axes with the plots `line` and `bars`, and the convergence of the solvers where an axis
/// named `solver` is there.
std::vector<StudyFigure> axis_figures(const StudyResults& results);

}  // namespace twofold
