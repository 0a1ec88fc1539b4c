#include "factor/lsmr.hpp"

#include <cmath>

#include "factor/minimise.hpp"
#include "factor/vector_arithmetic.hpp"

namespace twofold {

namespace {

/// f = |a| and a / f, or zeros where f is 0: the bidiagonalisation ends there by itself.
struct Direction {
    double length;
    Vector unit;
};

Direction direction_of(const Vector& a) {
    const double length = norm(a);
    return {length, length > 0.0 ? divided(a, length) : Vector(a.size(), 0.0)};
}

/// Golub-Kahan bidiagonalisation and the two plane rotations of LSMR; the comments give the names
/// of the paper where they differ.
class Recurrence {
  public:
    Recurrence(const RectangularOperator& a, const Vector& residual) : a_(a) {
        const Direction u = direction_of(residual);
        const Direction v = direction_of(a_.apply_transpose(u.unit));
        u_ = u.unit;
        v_ = v.unit;
        alpha_ = alpha_bar_ = v.length;
        zeta_bar_ = v.length * u.length;
        h_ = v_;
        h_bar_.assign(v_.size(), 0.0);
        correction_ = h_bar_;
    }

    /// What has been added to the start.
    const Vector& correction() const { return correction_; }

    /// |A^T r|, by recurrence.
    double residual() const { return std::fabs(zeta_bar_); }

    void step() {
        const Direction u = direction_of(plus_scaled(a_.apply(v_), -alpha_, u_));
        const Direction v = direction_of(plus_scaled(a_.apply_transpose(u.unit), -u.length, v_));
        u_ = u.unit;
        v_ = v.unit;
        alpha_ = v.length;

        const double rho_before = rho_;
        rho_ = std::sqrt(alpha_bar_ * alpha_bar_ + u.length * u.length);
        const double theta_next = u.length / rho_ * alpha_;
        alpha_bar_ = alpha_bar_ / rho_ * alpha_;

        const double rho_bar_before = rho_bar_;
        const double theta_bar = s_bar_ * rho_;
        const double turned = c_bar_ * rho_;
        rho_bar_ = std::sqrt(turned * turned + theta_next * theta_next);
        c_bar_ = turned / rho_bar_;
        s_bar_ = theta_next / rho_bar_;
        const double zeta = c_bar_ * zeta_bar_;
        zeta_bar_ = -s_bar_ * zeta_bar_;

        h_bar_ = plus_scaled(h_, -(theta_bar * rho_ / (rho_before * rho_bar_before)), h_bar_);
        correction_ = plus_scaled(correction_, zeta / (rho_ * rho_bar_), h_bar_);
        h_ = plus_scaled(v_, -(theta_next / rho_), h_);
    }

  private:
    const RectangularOperator& a_;
    Vector u_, v_, h_, h_bar_, correction_;
    double alpha_ = 0.0, alpha_bar_ = 0.0, zeta_bar_ = 0.0;
    double rho_ = 1.0, rho_bar_ = 1.0, c_bar_ = 1.0, s_bar_ = 0.0;
};

}  // namespace

Solution solve_lsmr(const RectangularOperator& a, const Vector& b, const Vector& start,
                    const StopRule& rule) {
    return minimise<Recurrence>(a, b, start, rule);
}

}  // namespace twofold
