#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "study/sweep/shared_work.hpp"

namespace twofold {

/// What was found of a cell: the values of its result file, and its picture.
struct CellFindings {
    nlohmann::ordered_json result;  ///< `times` alone differ from run to run
    ByteImage picture;              ///< empty if the cell failed
};

/// Measures cells.
class Laboratory {
  public:
    /// @param anchor  the study's common cell, drawn in turn with every other
    /// @param samples the most samples that any cell fits
    Laboratory(Cell anchor, int samples, TimingRule rule, int threads, StepListener listen);

    /// Everything about a cell. An Error of the cell's own, as of a chip that does not take a
    /// texture, is a finding: the result then has `failed` in place of figures.
    CellFindings measure(const Cell& cell);

  private:
    CellFindings measured(const Cell& cell, const Drawing& anchor);
    const Drawing& anchor_drawing();

    Cell anchor_;
    TimingRule rule_;
    SharedWork shared_;
    CellInputs anchor_inputs_;
    std::optional<Drawing> anchor_drawing_;
};

}  // namespace twofold
