#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/sweep/timing.hpp"

/// Study files: which cells a study has. Their form is described by study/study.schema.json.
namespace twofold {

/// A cell of an axis: what it changes, and where it stands on the axis.
struct StudyPoint {
    std::string label;
    std::optional<double> value;       ///< of a numeric axis
    std::vector<std::string> changes;  ///< `path=value`
};

/// How the report shows an axis beside the table and the scatter of error over time.
enum class AxisPlot {
    none,
    line,   ///< error over a number, with the slope of its logarithm
    bars,   ///< error of each cell
    budget  ///< bars of two axes side by side, against ideal64: cells of the same label belong
            ///< together
};

/// The picture that an axis's errors are shown against.
enum class AxisReference { exact, ideal64 };

/// Cells that differ in one respect.
struct StudyAxis {
    std::string name;   ///< an identifier
    std::string title;  ///< for readers
    AxisPlot plot = AxisPlot::none;
    AxisReference against = AxisReference::exact;
    bool linear = false;              ///< of a line: the number is not shown by its logarithm
    bool needs_objects = false;       ///< left out for scenes without any
    std::vector<std::string> scenes;  ///< files beside the study's scene; empty = that scene
    std::vector<std::string> base;    ///< changes for all of its cells
    std::vector<StudyPoint> points;   ///< at least one
};

struct Study {
    std::string title;
    std::vector<std::string> base;  ///< changes for all cells; the common cell has these alone
    TimingRule timing;
    std::vector<StudyAxis> axes;
};

/// @param name stands for the file in error texts
/// @throws Error naming file, field and value
Study parse_study(std::string_view text, const std::string& name);

Study read_study(const std::filesystem::path& path);

/// The studies that `--quick` and `--full` name, shipped as study/quick.json and study/full.json.
/// @throws Error with the names that there are
Study shipped_study(std::string_view name);

}  // namespace twofold
