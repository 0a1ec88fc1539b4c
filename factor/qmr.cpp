#include "factor/qmr.hpp"

#include <cmath>
#include <utility>

#include "factor/vector_arithmetic.hpp"

namespace twofold {

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

QmrRun::QmrRun(double magnitude, bool symmetric, const Vector& b, const Vector& start,
               const StopRule& rule)
    : matrix_exponent_(binary_exponent(magnitude)),
      solution_exponent_(binary_exponent(largest_magnitude(b)) - matrix_exponent_),
      symmetric_(symmetric),
      start_(start),
      b_(times_power_of_two(b, -binary_exponent(largest_magnitude(b)))),
      b_norm_(norm(b_)),
      rule_(rule) {
    if (!all_finite(b) || !all_finite(start) || !std::isfinite(magnitude)) {
        solution_ = {all_finite(start) ? start : Vector(start.size(), 0.0),
                     {.status = SolverStatus::non_finite}};
        stage_ = Stage::done;
    } else if (largest_magnitude(b) == 0.0) {
        solution_ = {Vector(b.size(), 0.0), {.history = {0.0}}};
        stage_ = Stage::done;
    }
    x_ = times_power_of_two(start, -solution_exponent_);
}

const Vector& QmrRun::argument() {
    const Vector& x = stage_ == Stage::product     ? p_
                      : stage_ == Stage::transpose ? q_
                      : stage_ == Stage::end       ? best_
                                                   : x_;
    if (matrix_exponent_ == 0) return x;
    argument_ = times_power_of_two(x, -(matrix_exponent_ / 2));
    return argument_;
}

Vector QmrRun::scaled_back(Vector product) const {
    if (matrix_exponent_ == 0) return product;
    return times_power_of_two(product, matrix_exponent_ / 2 - matrix_exponent_);
}

void QmrRun::take(Vector product) {
    product = scaled_back(std::move(product));
    switch (stage_) {
        case Stage::start:
            return begin(minus(b_, product));
        case Stage::product:
            return take_product(std::move(product));
        case Stage::transpose:
            return advance_lanczos(product);
        case Stage::end:
            return finish(norm(minus(b_, product)) / b_norm_);
        case Stage::done:
            return;
    }
}

void QmrRun::begin(Vector residual) {
    r_ = std::move(residual);
    lanczos_v_ = lanczos_w_ = r_;
    d_.assign(r_.size(), 0.0);
    s_ = d_;
    scalars_.rho = scalars_.xi = scalars_.rho_start = norm(r_);
    start_residual_ = scalars_.rho / b_norm_;
    progress_.emplace(rule_, start_residual_);
    best_ = x_;
    if (progress_->start_meets_tolerance()) return end_with(SolverStatus::converged);
    begin_iteration();
}

void QmrRun::begin_iteration() {
    iteration_ = progress_->iterations() + 1;
    QmrScalars& s = scalars_;
    // What is computed later in the iteration has passed the test of the one before.
    s.delta = s.epsilon = s.epsilon_scale = 1.0;
    if (const auto end = breakdown_of(s, rule_.breakdown)) return end_with(*end);

    v_ = divided(std::move(lanczos_v_), s.rho);
    if (!symmetric_) w_ = divided(std::move(lanczos_w_), s.xi);
    s.delta = dot(w(), v_);
    if (const auto end = breakdown_of(s, rule_.breakdown)) return end_with(*end);

    const auto next = [&](const Vector& unit, double length, Vector before) {
        return first_
                   ? unit
                   : combined(1.0, unit, -(length * s.delta / epsilon_before_), std::move(before));
    };
    p_ = next(v_, s.xi, std::move(p_));
    if (!symmetric_) q_ = next(w_, s.rho, std::move(q_));
    stage_ = Stage::product;
}

void QmrRun::take_product(Vector ap) {
    QmrScalars& s = scalars_;
    ap_ = std::move(ap);
    s.epsilon = dot(q(), ap_);
    s.epsilon_scale = norm(q()) * norm(ap_);
    s.beta = s.epsilon / s.delta;
    if (const auto end = breakdown_of(s, rule_.breakdown)) return end_with(*end);
    stage_ = Stage::transpose;
    // For a symmetric A the two Lanczos bases coincide bit for bit.
    if (symmetric_) advance_lanczos(ap_);
}

/// V = A p - beta v, W = A^T q - beta w.
void QmrRun::advance_lanczos(const Vector& transposed_product) {
    QmrScalars& s = scalars_;
    rho_before_ = s.rho;
    lanczos_v_ = combined(1.0, ap_, -s.beta, std::move(v_));
    if (!symmetric_) lanczos_w_ = combined(1.0, transposed_product, -s.beta, std::move(w_));
    s.rho = norm(lanczos_v_);
    s.xi = symmetric_ ? s.rho : norm(lanczos_w_);
    epsilon_before_ = s.epsilon;
    first_ = false;
    if (const auto end = advance_solution()) return end_with(*end);
    const auto end = progress_->record(norm(r_) / b_norm_);
    if (progress_->is_best()) best_ = x_;
    if (end) return end_with(*end);
    begin_iteration();
}

std::optional<SolverStatus> QmrRun::advance_solution() {
    QmrScalars& s = scalars_;
    const double gamma_before = s.gamma;
    const double theta_before = theta_;
    theta_ = s.rho / (gamma_before * std::fabs(s.beta));
    s.gamma = 1.0 / std::sqrt(1.0 + theta_ * theta_);
    if (!(s.gamma > 0.0)) return SolverStatus::breakdown_gamma;

    eta_ = -eta_ * rho_before_ * s.gamma * s.gamma / (s.beta * gamma_before * gamma_before);
    const double memory = theta_before * s.gamma * (theta_before * s.gamma);
    d_ = combined(eta_, p_, memory, std::move(d_));
    s_ = combined(eta_, ap_, memory, std::move(s_));
    x_ = plus_scaled(std::move(x_), 1.0, d_);
    r_ = plus_scaled(std::move(r_), -1.0, s_);
    return std::nullopt;
}

void QmrRun::end_with(SolverStatus status) {
    status_ = status;
    stage_ = Stage::end;
}

/// The best iterate, or the start where the recomputed residual says that the start was better.
void QmrRun::finish(double true_residual) {
    stage_ = Stage::done;
    Vector x = times_power_of_two(best_, solution_exponent_);
    if (!all_finite(x)) {
        solution_ = {start_,
                     progress_->report(SolverStatus::non_finite, iteration_, start_residual_)};
    } else if (!progress_->prefers(true_residual, start_residual_)) {
        solution_ = {start_, progress_->report(status_, iteration_, start_residual_)};
        solution_.report.best_iteration = 0;
    } else {
        solution_ = {std::move(x), progress_->report(status_, iteration_, true_residual)};
    }
}

Solution QmrRun::solution() { return std::move(solution_); }

Solution solve_qmr(const SquareOperator& a, const Vector& b, const Vector& start,
                   const StopRule& rule) {
    QmrRun run(a.magnitude, a.symmetric, b, start, rule);
    while (!run.ended()) run.take((run.transposed() ? a.apply_transpose : a.apply)(run.argument()));
    return run.solution();
}

namespace {

/// QMR on A^T A x = A^T b, in passes over the rows of A.
class NormalRun {
  public:
    NormalRun(const Vector& start, double magnitude, const StopRule& rule)
        : start_(start), magnitude_(magnitude), rule_(rule) {}

    std::optional<RowPass> request() {
        if (!run_) return RowPass{PassKind::right_side};
        if (run_->ended()) return std::nullopt;
        return RowPass{PassKind::normal, &run_->argument()};
    }
    void take(PassResult result) {
        if (run_)
            run_->take(std::move(result.columns));
        else
            run_.emplace(magnitude_, true, result.columns, start_, rule_);
    }
    Solution solution() { return run_->solution(); }

  private:
    Vector start_;
    double magnitude_;
    StopRule rule_;
    std::optional<QmrRun> run_;
};

}  // namespace

std::vector<Solution> solve_qmr_together(const RowPasses& make, const std::vector<Vector>& start,
                                         const Vector& magnitude, const StopRule& rule,
                                         int threads) {
    std::vector<NormalRun> runs;
    for (std::size_t k = 0; k < start.size(); ++k) runs.emplace_back(start[k], magnitude[k], rule);
    return in_lockstep(std::move(runs), make, threads);
}

}  // namespace twofold
