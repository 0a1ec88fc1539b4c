#pragma once
#include <string>
#include <vector>

#include "study/sweep/cell.hpp"
#include "study/sweep/study_file.hpp"

namespace twofold {

/// A cell of the plan and its name.
struct PlannedCell {
    std::string id;  ///< id_of
    Cell cell;
};

/// Where a cell stands: cells of several axes may be the same one.
struct PlannedPoint {
    std::string label;
    std::optional<double> value;
    std::string scene;     ///< file name, where the axis goes over several scenes
    std::size_t cell = 0;  ///< index into StudyPlan::cells
};

struct PlannedAxis {
    std::string name, title;
    AxisPlot plot = AxisPlot::none;
    AxisReference against = AxisReference::exact;
    bool linear = false;
    std::vector<PlannedPoint> points;
};

/// A study of one scene: every cell once, in an order in which neighbours share most work.
struct StudyPlan {
    std::string study_title, scene_title, scene_file;
    std::string scene_hash;  ///< of the scene file and the files that it names
    TimingRule timing;
    std::vector<PlannedCell> cells;
    std::vector<PlannedAxis> axes;
    std::size_t base = 0;  ///< the common cell
    int samples = 0;       ///< the most that a cell fits
};

/// @param overrides the user's changes to the scene: after the study's base, before its axes
/// @throws Error naming file, field and value
StudyPlan make_plan(const Study& study, const std::filesystem::path& scene,
                    const std::vector<std::string>& overrides);

/// A share of the work: cells number part - 1, part - 1 + parts, ... (part counts from 1).
struct Shard {
    int part = 1, parts = 1;
};

/// The shard that a text such as "2/5" names.
/// @throws Error unless 1 <= part <= parts <= 10000
Shard shard_of(const std::string& text);

/// The indices of the shard's cells, in order.
std::vector<std::size_t> cells_of(const StudyPlan& plan, const Shard& shard);

}  // namespace twofold
