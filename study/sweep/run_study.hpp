#pragma once
#include <functional>
#include <map>

#include "study/sweep/cell_store.hpp"
#include "study/sweep/plan.hpp"

namespace twofold {

/// How far a study is.
struct StudyProgress {
    std::size_t number, count;  ///< the cell that begins, from 1, of those to be measured
    std::string step;           ///< what is being done
    double seconds_left;        ///< guessed from the cells so far; negative: unknown
};
using ProgressListener = std::function<void(const StudyProgress& progress)>;

/// What measuring took.
struct StudyEffort {
    std::size_t measured = 0;   ///< cells
    std::size_t kept = 0;       ///< cells that were there already
    double cell_seconds = 0.0;  ///< wall time of the cells' own work
    double seconds = 0.0;       ///< wall time of everything
};

/// Measures the shard's cells that the store lacks, one after another; each is kept as soon as it
/// is done.
/// @throws Error if the common cell cannot be drawn or a file not be written
StudyEffort measure_cells(const StudyPlan& plan, const Shard& shard, const CellStore& store,
                          int threads, const ProgressListener& listen);

/// A plan and the result of each of its cells, by id.
struct StudyResults {
    StudyPlan plan;
    std::map<std::string, nlohmann::ordered_json> cells;
};

/// @throws Error saying how many cells are not there, if any
StudyResults collect(const StudyPlan& plan, const CellStore& store);

}  // namespace twofold
