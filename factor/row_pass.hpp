#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "factor/solver.hpp"

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
    Vector x{};
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

/// Solves in lockstep: each has its own recurrence, and what they ask for is done in one pass.
/// @tparam Run request() gives the next pass or nothing at the end, take() its result, solution()
///         what came of it
template <class Run>
std::vector<Solution> in_lockstep(std::vector<Run> runs, const RowPasses& make) {
    for (;;) {
        std::vector<std::optional<RowPass>> asked;
        bool any = false;
        for (const Run& run : runs) {
            asked.push_back(run.request());
            any = any || asked.back();
        }
        if (!any) break;
        std::vector<PassResult> results = make(asked);
        for (std::size_t k = 0; k < runs.size(); ++k)
            if (asked[k]) runs[k].take(std::move(results[k]));
    }
    std::vector<Solution> solutions;
    for (Run& run : runs) solutions.push_back(run.solution());
    return solutions;
}

}  // namespace twofold
