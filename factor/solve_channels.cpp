#include "factor/solve_channels.hpp"

#include "factor/channel_passes.hpp"
#include "factor/lsmr.hpp"
#include "factor/qmr.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

std::vector<Solution> qmr_together(const RowPasses& make,
                                   const std::vector<const WeightedSystem*>& systems,
                                   const std::vector<Vector>& start, const StopRule& rule,
                                   int threads) {
    Vector magnitude;
    for (const WeightedSystem* system : systems) magnitude.push_back(system->magnitude());
    return solve_qmr_together(make, start, magnitude, rule, threads);
}

std::vector<Solution> lsmr_together(const RowPasses& make, const std::vector<Vector>& start,
                                    const StopRule& rule, int threads) {
    std::vector<LsmrRun> runs;
    for (const Vector& x : start) runs.emplace_back(x, rule);
    return in_lockstep(std::move(runs), make, threads);
}

}  // namespace

StopRule stop_rule_of(const FactorSettings& settings) {
    return {.tolerance = settings.tolerance,
            .iteration_limit = settings.iteration_limit,
            .window = settings.stagnation_window,
            .keep_best = settings.keep_best};
}

std::vector<Solution> solve_channels(Solver solver,
                                     const std::vector<const WeightedSystem*>& systems,
                                     const std::vector<Vector>& start, const StopRule& rule,
                                     int threads) {
    if (systems.empty()) return {};
    ChannelPasses passes(systems, threads);
    const RowPasses make = [&](const auto& asked) { return passes(asked); };
    if (solver == Solver::qmr) return qmr_together(make, systems, start, rule, threads);
    if (solver == Solver::lsmr) return lsmr_together(make, start, rule, threads);
    std::vector<Solution> solutions(systems.size());
    parallel_for(systems.size(), threads, [&](std::size_t k) {
        solutions[k] = solve(solver, systems[k]->problem(), start[k], rule);
    });
    return solutions;
}

}  // namespace twofold
