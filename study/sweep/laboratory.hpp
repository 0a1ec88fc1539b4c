#pragma once
#include <deque>
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

    /// Everything about a cell, its frame timed by one round. An Error of the cell's own, as of a
    /// chip that does not take a texture, is a finding: the result then has `failed` in place of
    /// figures.
    /// @param cell must outlive the next call of time_in_turn()
    CellFindings measure(const Cell& cell);

    /// The frames that wait to be timed in turn: one of each cell measured, but for those that
    /// failed.
    std::size_t waiting() const { return waiting_.size(); }

    /// Whether as many wait as should be kept in memory.
    bool full() const;

    /// Times the waiting frames in turn, as often as the rule says. `times.frame` of each cell's
    /// result, in the order in which they were measured.
    std::vector<nlohmann::ordered_json> time_in_turn();

  private:
    /// A cell's frame, ready to be drawn again.
    struct Waiting {
        CellInputs inputs;
        Drawing drawing;
        std::optional<TimedFrame> time;
    };

    CellFindings measured(const Cell& cell);
    TimedFrame& common_frame();

    Cell anchor_;
    TimingRule rule_;
    SharedWork shared_;
    CellInputs anchor_inputs_;
    std::optional<Drawing> anchor_drawing_;
    std::optional<TimedFrame> common_;  ///< of this turn
    std::deque<Waiting> waiting_;  ///< drawings refer to their inputs, which stay where they are
    std::size_t waiting_pixels_ = 0;
};

}  // namespace twofold
