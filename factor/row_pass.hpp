#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "factor/solver.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

/// What a solver asks of min |A x - b| at a time: one pass over the rows, which never leave it. The
/// system keeps a vector of rows, u.
enum class PassKind {
    right_side,  ///< A^T b
    normal,      ///< A^T A x
    gradient,    ///< A^T (b - A x)
    start,       ///< u = b - A x, the first u of a system
    step,        ///< u = A x - keep u
};

struct RowPass {
    PassKind kind = PassKind::right_side;
    const Vector* x = nullptr;  ///< until the result is taken
    double keep = 0.0;
};

struct PassResult {
    Vector columns{};     ///< what the kind says, or A^T u
    double length = 0.0;  ///< |u|, where the pass sets it
};

/// Makes the passes of several systems over the same rows together; one that has nothing to ask
/// waits, and its result is empty.
using RowPasses =
    std::function<std::vector<PassResult>(const std::vector<std::optional<RowPass>>&)>;

/// Solves in lockstep: each has its own recurrence, on a thread, and what they ask for is done in
/// one pass.
/// @tparam Run request() gives the next pass or nothing at the end, take() its result, solution()
///         what came of it
template <class Run>
std::vector<Solution> in_lockstep(std::vector<Run> runs, const RowPasses& make, int threads) {
    std::vector<std::optional<RowPass>> asked(runs.size());
    std::vector<PassResult> results;
    const auto advance = [&](std::size_t k) {
        if (asked[k]) runs[k].take(std::move(results[k]));
        asked[k] = runs[k].request();
    };
    for (;;) {
        parallel_for(runs.size(), threads, advance);
        if (std::none_of(asked.begin(), asked.end(), [](const auto& a) { return a.has_value(); }))
            break;
        results = make(asked);
    }
    std::vector<Solution> solutions;
    for (Run& run : runs) solutions.push_back(run.solution());
    return solutions;
}

}  // namespace twofold
