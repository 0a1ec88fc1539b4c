#include "factor/lsmr.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "factor/simd_clones.hpp"
#include "factor/vector_arithmetic.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// f = |a| and a / f, or zeros where f is 0: the bidiagonalisation ends there by itself.
struct Direction {
    double length;
    Vector unit;
};

Direction direction_of(Vector a) {
    const double length = norm(a);
    return {length, length > 0.0 ? divided(std::move(a), length) : Vector(a.size(), 0.0)};
}

/// A^T u of the unit vector u.
Vector per_length(PassResult result) {
    return result.length > 0.0 ? divided(std::move(result.columns), result.length)
                               : Vector(result.columns.size(), 0.0);
}

/// alpha v of the next iteration, A^T u - beta v of a unit u, in the place of `sums`, which are
/// beta times A^T u. @param u_length  beta @return alpha
[[gnu::flatten]] TWOFOLD_SIMD_CLONES double next_v(Vector& sums, double u_length, const Vector& v) {
    const double divisor = u_length > 0.0 ? u_length : 1.0;
    if (!(u_length > 0.0)) std::fill(sums.begin(), sums.end(), 0.0);
    return std::sqrt(ordered_sum(sums.size(), [&](std::size_t i) {
        sums[i] = sums[i] / divisor + -u_length * v[i];
        return sums[i] * sums[i];
    }));
}

/// The vectors of an iteration, in one go. @param v  alpha v, which becomes v
TWOFOLD_SIMD_CLONES
void advance(Vector& v, double alpha, const LsmrSteps& steps, Vector& h, Vector& h_bar, Vector& x) {
    const double divisor = alpha > 0.0 ? alpha : 1.0;
    if (!(alpha > 0.0)) std::fill(v.begin(), v.end(), 0.0);
    double* __restrict const vs = v.data(), * __restrict const hs = h.data();
    double* __restrict const bars = h_bar.data(), * __restrict const xs = x.data();
    for (std::size_t i = 0; i < v.size(); ++i) {
        bars[i] = hs[i] + steps.h_bar * bars[i];
        xs[i] += steps.x * bars[i];
        vs[i] /= divisor;
        hs[i] = vs[i] + steps.h * hs[i];
    }
}

/// The passes that LSMR asks for, from a system's products.
class OperatorPasses {
  public:
    OperatorPasses(const RectangularOperator& a, const Vector& b) : a_(a), b_(b) {}

    PassResult make(const RowPass& pass) {
        if (pass.kind == PassKind::right_side) return {a_.apply_transpose(b_)};
        const Vector product = a_.apply(*pass.x);
        if (pass.kind == PassKind::gradient) return {a_.apply_transpose(minus(b_, product))};
        u_ = pass.kind == PassKind::start ? minus(b_, product)
                                          : combined(1.0, product, -pass.keep, std::move(u_));
        return {a_.apply_transpose(u_), norm(u_)};
    }

  private:
    const RectangularOperator& a_;
    const Vector& b_;
    Vector u_;
};

}  // namespace

LsmrRun::LsmrRun(Vector start, const StopRule& rule) : start_(std::move(start)), rule_(rule) {}

std::optional<RowPass> LsmrRun::request() const {
    switch (stage_) {
        case Stage::right_side:
            return RowPass{PassKind::right_side};
        case Stage::start:
            return RowPass{PassKind::start, &start_};
        case Stage::steps:
            return RowPass{PassKind::step, &v_, u_length_ > 0.0 ? alpha_ / u_length_ : 0.0};
        case Stage::end:
            return RowPass{PassKind::gradient, &best_};
        case Stage::done:
            break;
    }
    return std::nullopt;
}

void LsmrRun::take(PassResult result) {
    if (stage_ == Stage::right_side) {
        scale_ = norm(result.columns);
        stage_ = scale_ == 0.0 ? Stage::done : Stage::start;
        if (stage_ == Stage::done) solution_ = {Vector(start_.size(), 0.0), {.history = {0.0}}};
    } else if (stage_ == Stage::start) {
        begin(std::move(result));
    } else if (stage_ == Stage::steps) {
        step(std::move(result));
    } else {
        finish(norm(result.columns) / scale_);
    }
}

void LsmrRun::begin(PassResult residual) {
    start_residual_ = norm(residual.columns) / scale_;
    progress_.emplace(rule_, start_residual_);
    const bool finite = std::isfinite(start_residual_);
    if (!finite || progress_->start_meets_tolerance()) {
        const auto status = finite ? SolverStatus::converged : SolverStatus::non_finite;
        solution_ = {start_, progress_->report(status, 0, start_residual_)};
        stage_ = Stage::done;
        return;
    }
    u_length_ = residual.length;
    Direction v = direction_of(per_length(std::move(residual)));
    v_ = std::move(v.unit);
    h_ = v_;
    alpha_ = alpha_bar_ = v.length;
    zeta_bar_ = v.length * u_length_;
    h_bar_.assign(v_.size(), 0.0);
    correction_ = h_bar_;
    stage_ = Stage::steps;
}

void LsmrRun::step(PassResult result) {
    u_length_ = result.length;
    alpha_ = next_v(result.columns, u_length_, v_);
    const LsmrSteps steps = rotate();
    end_ = progress_->record(std::fabs(zeta_bar_) / scale_);
    if (!progress_->is_best() && best_is_correction_) best_ = correction_;
    best_is_correction_ = progress_->is_best();
    v_ = std::move(result.columns);
    advance(v_, alpha_, steps, h_, h_bar_, correction_);
    if (!end_) return;
    best_ = plus_scaled(start_, 1.0, best_is_correction_ ? correction_ : best_);
    stage_ = Stage::end;
}

LsmrSteps LsmrRun::rotate() {
    const double rho_before = rho_;
    rho_ = std::sqrt(alpha_bar_ * alpha_bar_ + u_length_ * u_length_);
    const double theta_next = u_length_ / rho_ * alpha_;
    alpha_bar_ = alpha_bar_ / rho_ * alpha_;

    const double rho_bar_before = rho_bar_;
    const double theta_bar = s_bar_ * rho_;
    const double turned = c_bar_ * rho_;
    rho_bar_ = std::sqrt(turned * turned + theta_next * theta_next);
    c_bar_ = turned / rho_bar_;
    s_bar_ = theta_next / rho_bar_;
    const double zeta = c_bar_ * zeta_bar_;
    zeta_bar_ = -s_bar_ * zeta_bar_;
    return {-(theta_bar * rho_ / (rho_before * rho_bar_before)), zeta / (rho_ * rho_bar_),
            -(theta_next / rho_)};
}

void LsmrRun::finish(double true_residual) {
    stage_ = Stage::done;
    if (progress_->prefers(true_residual, start_residual_)) {
        solution_ = {std::move(best_),
                     progress_->report(*end_, progress_->iterations(), true_residual)};
        return;
    }
    solution_ = {start_, progress_->report(*end_, progress_->iterations(), start_residual_)};
    solution_.report.best_iteration = 0;
}

Solution LsmrRun::solution() { return std::move(solution_); }

Solution solve_lsmr(const RectangularOperator& a, const Vector& b, const Vector& start,
                    const StopRule& rule) {
    if (!all_finite(b) || !all_finite(start)) {
        return {all_finite(start) ? start : Vector(start.size(), 0.0),
                {.status = SolverStatus::non_finite}};
    }
    // Units in which b is of order 1 keep the squares of the norms in range.
    const int exponent = binary_exponent(largest_magnitude(b));
    const Vector scaled_b = times_power_of_two(b, -exponent);
    OperatorPasses passes(a, scaled_b);
    LsmrRun run(times_power_of_two(start, -exponent), rule);
    while (const auto pass = run.request()) run.take(passes.make(*pass));
    Solution solution = run.solution();
    solution.x = times_power_of_two(solution.x, exponent);
    return solution;
}

}  // namespace twofold
