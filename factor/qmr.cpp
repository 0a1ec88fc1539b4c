#include "factor/qmr.hpp"

#include <cmath>

#include "factor/progress.hpp"
#include "factor/vector_arithmetic.hpp"

namespace twofold {

namespace {

/// A x = b in units in which the largest entries of A and b are of order 1. Halves of A's exponent
/// are taken off before and after the product, so that no entry near the limits overflows on the
/// way.
class ScaledSystem {
  public:
    ScaledSystem(const SquareOperator& a, const Vector& b)
        : a_(a),
          matrix_exponent_(binary_exponent(a.magnitude)),
          solution_exponent_(binary_exponent(largest_magnitude(b)) - matrix_exponent_),
          b_(times_power_of_two(b, -binary_exponent(largest_magnitude(b)))) {}

    const Vector& b() const { return b_; }
    bool symmetric() const { return a_.symmetric; }
    Vector apply(const Vector& x) const { return scaled_product(a_.apply, x); }
    Vector apply_transpose(const Vector& x) const { return scaled_product(a_.apply_transpose, x); }
    Vector residual(const Vector& x) const { return minus(b_, apply(x)); }
    Vector to_scaled(const Vector& x) const { return times_power_of_two(x, -solution_exponent_); }
    Vector from_scaled(const Vector& x) const { return times_power_of_two(x, solution_exponent_); }

  private:
    Vector scaled_product(const std::function<Vector(const Vector&)>& product,
                          const Vector& x) const {
        if (matrix_exponent_ == 0) return product(x);
        const int before = matrix_exponent_ / 2;
        return times_power_of_two(product(times_power_of_two(x, -before)),
                                  before - matrix_exponent_);
    }

    const SquareOperator& a_;
    int matrix_exponent_;
    int solution_exponent_;
    Vector b_;
};

/// The coupled two-term recurrences; names as in Templates, figure 2.8, with V and W the unscaled
/// Lanczos vectors.
class Recurrence {
  public:
    Recurrence(const ScaledSystem& system, Vector start, Vector residual, double threshold)
        : system_(system),
          threshold_(threshold),
          x_(std::move(start)),
          r_(std::move(residual)),
          lanczos_v_(r_),
          lanczos_w_(r_),
          d_(r_.size(), 0.0),
          s_(r_.size(), 0.0) {
        scalars_.rho = scalars_.xi = scalars_.rho_start = norm(r_);
    }

    const Vector& x() const { return x_; }
    const Vector& residual() const { return r_; }

    /// One iteration: moves x and the residual, unless a scalar vanishes on the way.
    std::optional<SolverStatus> step() {
        QmrScalars& s = scalars_;
        // What is computed later in the iteration has passed the test of the one before.
        s.delta = s.epsilon = s.epsilon_scale = 1.0;
        if (const auto end = breakdown_of(s, threshold_)) return end;

        const Vector v = divided(lanczos_v_, s.rho);
        const Vector w = divided(lanczos_w_, s.xi);
        s.delta = dot(w, v);
        if (const auto end = breakdown_of(s, threshold_)) return end;

        p_ = first_ ? v : plus_scaled(v, -(s.xi * s.delta / epsilon_before_), p_);
        q_ = first_ ? w : plus_scaled(w, -(s.rho * s.delta / epsilon_before_), q_);
        const Vector ap = system_.apply(p_);
        s.epsilon = dot(q_, ap);
        s.epsilon_scale = norm(q_) * norm(ap);
        s.beta = s.epsilon / s.delta;
        if (const auto end = breakdown_of(s, threshold_)) return end;

        const double rho_before = s.rho;
        advance_lanczos(v, w, ap);
        return advance_solution(ap, rho_before);
    }

  private:
    /// V = A p - beta v, W = A^T q - beta w. For a symmetric A the two bases coincide bit for bit.
    void advance_lanczos(const Vector& v, const Vector& w, const Vector& ap) {
        lanczos_v_ = plus_scaled(ap, -scalars_.beta, v);
        lanczos_w_ = system_.symmetric()
                         ? lanczos_v_
                         : plus_scaled(system_.apply_transpose(q_), -scalars_.beta, w);
        scalars_.rho = norm(lanczos_v_);
        scalars_.xi = norm(lanczos_w_);
        epsilon_before_ = scalars_.epsilon;
        first_ = false;
    }

    std::optional<SolverStatus> advance_solution(const Vector& ap, double rho_before) {
        QmrScalars& s = scalars_;
        const double gamma_before = s.gamma;
        const double theta_before = theta_;
        theta_ = s.rho / (gamma_before * std::fabs(s.beta));
        s.gamma = 1.0 / std::sqrt(1.0 + theta_ * theta_);
        if (!(s.gamma > 0.0)) return SolverStatus::breakdown_gamma;

        eta_ = -eta_ * rho_before * s.gamma * s.gamma / (s.beta * gamma_before * gamma_before);
        const double memory = theta_before * s.gamma * (theta_before * s.gamma);
        d_ = plus_scaled(scaled(eta_, p_), memory, d_);
        s_ = plus_scaled(scaled(eta_, ap), memory, s_);
        x_ = plus_scaled(x_, 1.0, d_);
        r_ = plus_scaled(r_, -1.0, s_);
        return std::nullopt;
    }

    const ScaledSystem& system_;
    double threshold_;
    Vector x_, r_;
    Vector lanczos_v_, lanczos_w_;
    Vector p_, q_;
    Vector d_, s_;  ///< steps of x and of the residual
    QmrScalars scalars_;
    double epsilon_before_ = 1.0;
    double theta_ = 0.0;
    double eta_ = -1.0;
    bool first_ = true;
};

Solution refused(const Vector& start) {
    Vector x = all_finite(start) ? start : Vector(start.size(), 0.0);
    return {std::move(x), {.status = SolverStatus::non_finite}};
}

/// The report and x of an iteration that ended: the best iterate, or the start where the recomputed
/// residual says that the start was better.
Solution finish(const ScaledSystem& system, const Vector& start, const Vector& best,
                const Progress& progress, SolverStatus status, int iteration) {
    const double b_norm = norm(system.b());
    const double start_residual = norm(system.residual(system.to_scaled(start))) / b_norm;
    const double true_residual = norm(system.residual(best)) / b_norm;
    Vector x = system.from_scaled(best);
    if (!all_finite(x)) {
        return {start, progress.report(SolverStatus::non_finite, iteration, start_residual)};
    }
    if (!progress.prefers(true_residual, start_residual)) {
        Solution kept{start, progress.report(status, iteration, start_residual)};
        kept.report.best_iteration = 0;
        return kept;
    }
    return {std::move(x), progress.report(status, iteration, true_residual)};
}

}  // namespace

std::optional<SolverStatus> breakdown_of(const QmrScalars& s, double t) {
    if (!std::isfinite(s.rho) || !std::isfinite(s.xi)) return SolverStatus::non_finite;
    if (s.rho <= t * s.rho_start) return SolverStatus::breakdown_rho;
    if (s.xi <= t * s.rho_start) return SolverStatus::breakdown_xi;
    if (!std::isfinite(s.delta)) return SolverStatus::non_finite;
    if (std::fabs(s.delta) <= t) return SolverStatus::breakdown_delta;
    if (!std::isfinite(s.epsilon)) return SolverStatus::non_finite;
    if (std::fabs(s.epsilon) <= t * s.epsilon_scale) return SolverStatus::breakdown_epsilon;
    if (!(std::fabs(s.beta) > 0.0)) return SolverStatus::breakdown_beta;
    if (!(s.gamma > 0.0)) return SolverStatus::breakdown_gamma;
    return std::nullopt;
}

Solution solve_qmr(const SquareOperator& a, const Vector& b, const Vector& start,
                   const StopRule& rule) {
    if (!all_finite(b) || !all_finite(start) || !std::isfinite(a.magnitude)) return refused(start);
    if (largest_magnitude(b) == 0.0) return {Vector(b.size(), 0.0), {.history = {0.0}}};

    const ScaledSystem system(a, b);
    const Vector scaled_start = system.to_scaled(start);
    const double b_norm = norm(system.b());
    Recurrence recurrence(system, scaled_start, system.residual(scaled_start), rule.breakdown);
    Progress progress(rule, norm(recurrence.residual()) / b_norm);
    if (progress.start_meets_tolerance()) {
        return finish(system, start, scaled_start, progress, SolverStatus::converged, 0);
    }
    Vector best = scaled_start;
    for (;;) {
        const int iteration = progress.iterations() + 1;
        if (const auto end = recurrence.step()) {
            return finish(system, start, best, progress, *end, iteration);
        }
        const auto end = progress.record(norm(recurrence.residual()) / b_norm);
        if (progress.is_best()) best = recurrence.x();
        if (end) return finish(system, start, best, progress, *end, iteration);
    }
}

}  // namespace twofold
