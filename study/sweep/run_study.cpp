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

void measure_missing(const StudyPlan& plan, const std::vector<std::size_t>& missing,
                     const CellStore& store, int threads, const ProgressListener& listen,
                     StudyEffort& effort) {
    StudyProgress now{0, missing.size(), "", -1.0};
    const auto tell = [&](const std::string& step) {
        now.step = step;
        listen(now);
    };
    Laboratory laboratory(plan.cells[plan.base].cell, plan.samples, plan.timing, threads, tell);
    TimeLeft left;
    for (const std::size_t i : missing) {
        now.seconds_left = left.guess(missing.size() - effort.measured);
        ++now.number;
        tell(place_of(plan, i));
        CellFindings findings;
        const double taken =
            seconds_of([&] { findings = laboratory.measure(plan.cells[i].cell); }).wall;
        store.keep(plan.cells[i].id, findings);
        left.add(taken);
        effort.cell_seconds += taken;
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
