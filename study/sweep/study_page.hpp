#pragma once
#include <map>
#include <string>
#include <vector>

#include "study/sweep/run_study.hpp"
#include "study/sweep/study_figures.hpp"

namespace twofold {

/// What the page shows of a study.
struct StudyPage {
    const StudyResults& results;
    std::vector<StudyFigure> trades, budgets, axes;
    std::map<std::string, std::vector<unsigned char>> pictures;  ///< PNG files by cell id
    std::string command;
    std::map<std::string, std::string> checks;  ///< outcomes of tests; see checks.hpp
};

/// Where a study's report came from.
struct StudyOrigin {
    std::string command;           ///< how the program was called
    std::filesystem::path checks;  ///< a result file of the project's tests; empty = none
};

/// One HTML file that needs no network. Its figures are there before its script runs.
std::string study_html(const StudyPage& page);

/// The finding in a sentence: what the common cell's picture is off by, and what of that the card's
/// arithmetic makes.
std::string study_summary(const StudyResults& results);

/// One line a place of a cell on an axis: settings, errors, times, work.
std::string study_csv(const StudyResults& results);

/// Writes study.json, cells.csv, figures/*.svg and report.html.
/// @return the path of the report
std::filesystem::path write_study(const StudyResults& results, const CellStore& store,
                                  const std::filesystem::path& folder, const StudyOrigin& origin);

}  // namespace twofold
