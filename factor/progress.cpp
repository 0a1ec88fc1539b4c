#include "factor/progress.hpp"

#include <cmath>

#include "texunit/fixed.hpp"

namespace twofold {

namespace {

/// A residual below this is rounding alone, and iterating on makes x diverge.
constexpr double rounding_floor = 0x1p-50;

}  // namespace

const char* name_of(SolverStatus status) {
    switch (status) {
        case SolverStatus::converged:
            return "converged";
        case SolverStatus::limit:
            return "limit";
        case SolverStatus::stagnation:
            return "stagnation";
        case SolverStatus::breakdown_rho:
            return "breakdown_rho";
        case SolverStatus::breakdown_xi:
            return "breakdown_xi";
        case SolverStatus::breakdown_delta:
            return "breakdown_delta";
        case SolverStatus::breakdown_epsilon:
            return "breakdown_epsilon";
        case SolverStatus::breakdown_beta:
            return "breakdown_beta";
        case SolverStatus::breakdown_gamma:
            return "breakdown_gamma";
        case SolverStatus::non_finite:
            return "non_finite";
    }
    return "unknown";
}

Progress::Progress(const StopRule& rule, double start_residual)
    : rule_(rule), history_{start_residual}, best_(start_residual), reference_(start_residual) {}

double Progress::tolerance() const {
    return rule_.keep_best ? max(rule_.tolerance, rounding_floor) : rule_.tolerance;
}

std::optional<SolverStatus> Progress::record(double residual) {
    if (!std::isfinite(residual)) return SolverStatus::non_finite;
    history_.push_back(residual);
    if (residual < best_ || !rule_.keep_best) {
        best_ = residual;
        best_iteration_ = iterations();
    }
    if (residual <= (1.0 - rule_.progress) * reference_) {
        reference_ = residual;
        last_progress_ = iterations();
    }
    if (residual <= tolerance()) return SolverStatus::converged;
    if (rule_.window > 0 && iterations() - last_progress_ >= rule_.window)
        return SolverStatus::stagnation;
    if (iterations() >= rule_.iteration_limit) return SolverStatus::limit;
    return std::nullopt;
}

SolverReport Progress::report(SolverStatus status, int iteration, double true_residual) const {
    const bool claims_too_much =
        status == SolverStatus::converged && !(true_residual <= tolerance());
    return {.status = claims_too_much ? SolverStatus::stagnation : status,
            .iterations = iteration,
            .best_iteration = best_iteration_,
            .relative_residual = true_residual,
            .history = history_};
}

}  // namespace twofold
