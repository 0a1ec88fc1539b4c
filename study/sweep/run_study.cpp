#include "study/sweep/run_study.hpp"

#include <fmt/format.h>

#include "texunit/error.hpp"

namespace twofold {
namespace {

std::vector<std::size_t> missing_cells(const StudyPlan& plan, const Shard& shard,
                                       const CellStore& store) {
    std::vector<std::size_t> missing;
    for (const std::size_t i : cells_of(plan, shard))
        if (!store.result(plan.cells[i].id)) missing.push_back(i);
    return missing;
}

/// The first place where a cell stands: "Map size: 32".
std::string place_of(const StudyPlan& plan, std::size_t cell) {
    for (const PlannedAxis& axis : plan.axes)
        for (const PlannedPoint& point : axis.points)
            if (point.cell == cell) return axis.title + ": " + point.label;
    return "the common cell";
}

/// The first cell also does what all share: it says nothing about the others.
class TimeLeft {
  public:
    void add(double seconds) {
        if (cells_++ > 0) spent_ += seconds;
    }
    double guess(std::size_t cells_left) const {
        if (cells_ < 2) return -1.0;
        return spent_ / static_cast<double>(cells_ - 1) * static_cast<double>(cells_left);
    }

  private:
    std::size_t cells_ = 0;
    double spent_ = 0.0;
};

/// Measures cells and keeps what was found, each at once with the times of one round; then their
/// frames are timed in turn, some cells at a time, and the results get those times.
class Measuring {
  public:
    Measuring(const StudyPlan& plan, const CellStore& store, int threads, StepListener tell)
        : store_(store),
          tell_(tell),
          laboratory_(plan.cells[plan.base].cell, plan.samples, plan.timing, threads, tell) {}

    void measure(const PlannedCell& cell) {
        CellFindings found;
        own_seconds_ += seconds_of([&] { found = laboratory_.measure(cell.cell); }).wall;
        store_.keep(cell.id, found);
        if (laboratory_.waiting() > untimed_.size())
            untimed_.emplace_back(cell.id, std::move(found.result));
        if (laboratory_.full()) time_in_turn();
    }

    void time_in_turn() {
        if (untimed_.empty()) return;
        tell_(fmt::format("frames of {} cells in turn", untimed_.size()));
        std::vector<nlohmann::ordered_json> times;
        own_seconds_ += seconds_of([&] { times = laboratory_.time_in_turn(); }).wall;
        for (std::size_t i = 0; i < times.size(); ++i) {
            untimed_[i].second["times"]["frame"] = times[i];
            store_.keep(untimed_[i].first, {std::move(untimed_[i].second), {}});
        }
        untimed_.clear();
    }

    /// Wall time of the cells' own work so far.
    double own_seconds() const { return own_seconds_; }

  private:
    const CellStore& store_;
    StepListener tell_;
    Laboratory laboratory_;
    std::vector<std::pair<std::string, nlohmann::ordered_json>> untimed_;  ///< id and result
    double own_seconds_ = 0.0;
};

void measure_missing(const StudyPlan& plan, const std::vector<std::size_t>& missing,
                     const CellStore& store, int threads, const ProgressListener& listen,
                     StudyEffort& effort) {
    StudyProgress now{0, missing.size(), "", -1.0};
    const auto tell = [&](const std::string& step) {
        now.step = step;
        listen(now);
    };
    Measuring measuring(plan, store, threads, tell);
    TimeLeft left;
    for (const std::size_t i : missing) {
        now.seconds_left = left.guess(missing.size() - effort.measured);
        ++now.number;
        tell(place_of(plan, i));
        measuring.measure(plan.cells[i]);
        if (i == missing.back()) measuring.time_in_turn();
        left.add(measuring.own_seconds() - effort.cell_seconds);
        effort.cell_seconds = measuring.own_seconds();
        ++effort.measured;
    }
}

}  // namespace

StudyEffort measure_cells(const StudyPlan& plan, const Shard& shard, const CellStore& store,
                          int threads, const ProgressListener& listen) {
    StudyEffort effort;
    effort.seconds = seconds_of([&] {
                         const auto missing = missing_cells(plan, shard, store);
                         effort.kept = cells_of(plan, shard).size() - missing.size();
                         if (!missing.empty())
                             measure_missing(plan, missing, store, threads, listen, effort);
                     }).wall;
    return effort;
}

StudyResults collect(const StudyPlan& plan, const CellStore& store) {
    StudyResults results{plan, {}};
    std::size_t missing = 0;
    std::string first;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const std::string& id = plan.cells[i].id;
        if (auto result = store.result(id)) {
            results.cells.emplace(id, *std::move(result));
        } else if (missing++ == 0) {
            first = fmt::format("{} ({})", id, place_of(plan, i));
        }
    }
    if (missing > 0)
        throw Error(ExitCode::failure, fmt::format("{} of {} cells were not measured, the first {}",
                                                   missing, plan.cells.size(), first));
    return results;
}

}  // namespace twofold
