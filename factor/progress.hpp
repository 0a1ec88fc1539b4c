#pragma once
#include <optional>

#include "factor/solver.hpp"

namespace twofold {

/// Follows the relative residuals of an iteration: keeps the history and the best of them and says
/// when the stop rule ends the solve.
class Progress {
  public:
    Progress(const StopRule& rule, double start_residual);

    /// Takes the residual after one more iteration.
    /// @return the status the solve ends with, or nothing while it goes on
    std::optional<SolverStatus> record(double residual);

    /// Whether the residual recorded last is the smallest yet, or the rule keeps the last one.
    bool is_best() const { return best_iteration_ == iterations(); }

    /// Whether a result with this recomputed residual is to be returned rather than the start.
    bool prefers(double true_residual, double start_residual) const {
        return !rule_.keep_best || true_residual <= start_residual;
    }

    bool start_meets_tolerance() const { return history_.front() <= tolerance(); }

    int iterations() const { return static_cast<int>(history_.size()) - 1; }

    /// The report of a solve that ended with `status` in iteration `iteration`, whose x is the best
    /// one, with its recomputed relative residual. `converged` stands only if that meets the
    /// tolerance: a recurrence that has lost the true residual has nothing left to gain.
    SolverReport report(SolverStatus status, int iteration, double true_residual) const;

  private:
    double tolerance() const;

    StopRule rule_;
    std::vector<double> history_;
    double best_;
    int best_iteration_ = 0;
    double reference_;       ///< the residual that progress is measured against
    int last_progress_ = 0;  ///< iteration that set the reference
};

}  // namespace twofold
