#pragma once
#include <cmath>
#include <optional>

#include "factor/progress.hpp"
#include "factor/vector_arithmetic.hpp"

namespace twofold {

/// What LSMR and CGLS share: units, start, stop rule, best iterate and the recomputed residual.
/// @tparam Recurrence made of A and the start's residual; has step(), correction() (what has been
///         added to the start) and residual(), |A^T r| by recurrence
/// @return as solve_lsmr() says
template <class Recurrence>
Solution minimise(const RectangularOperator& a, const Vector& b, const Vector& start,
                  const StopRule& rule) {
    if (!all_finite(b) || !all_finite(start)) {
        return {all_finite(start) ? start : Vector(start.size(), 0.0),
                {.status = SolverStatus::non_finite}};
    }
    // Units in which b is of order 1 keep the squares of the norms in range.
    const int exponent = binary_exponent(largest_magnitude(b));
    const Vector scaled_b = times_power_of_two(b, -exponent);
    const Vector scaled_start = times_power_of_two(start, -exponent);
    const double scale = norm(a.apply_transpose(scaled_b));
    if (scale == 0.0) return {Vector(start.size(), 0.0), {.history = {0.0}}};

    const auto gradient = [&](const Vector& x) {
        return norm(a.apply_transpose(minus(scaled_b, a.apply(x)))) / scale;
    };
    const double start_residual = gradient(scaled_start);
    Progress progress(rule, start_residual);
    if (!std::isfinite(start_residual)) {
        return {start, progress.report(SolverStatus::non_finite, 0, start_residual)};
    }
    if (progress.start_meets_tolerance()) {
        return {start, progress.report(SolverStatus::converged, 0, start_residual)};
    }

    Recurrence recurrence(a, minus(scaled_b, a.apply(scaled_start)));
    Vector best(start.size(), 0.0);
    std::optional<SolverStatus> end;
    while (!end) {
        recurrence.step();
        end = progress.record(recurrence.residual() / scale);
        if (progress.is_best()) best = recurrence.correction();
    }
    const Vector x = plus_scaled(scaled_start, 1.0, best);
    const double true_residual = gradient(x);
    if (!progress.prefers(true_residual, start_residual)) {
        Solution kept{start, progress.report(*end, progress.iterations(), start_residual)};
        kept.report.best_iteration = 0;
        return kept;
    }
    return {times_power_of_two(x, exponent),
            progress.report(*end, progress.iterations(), true_residual)};
}

}  // namespace twofold
