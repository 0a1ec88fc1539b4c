#include "factor/cgls.hpp"

#include <cmath>

#include "factor/minimise.hpp"

namespace twofold {

namespace {

/// r = b - A x, s = A^T r, p the direction, g = s.s.
class Recurrence {
  public:
    Recurrence(const RectangularOperator& a, Vector residual)
        : a_(a),
          r_(std::move(residual)),
          p_(a.apply_transpose(r_)),
          correction_(p_.size(), 0.0),
          g_(dot(p_, p_)) {}

    const Vector& correction() const { return correction_; }
    double residual() const { return std::sqrt(g_); }

    /// Stays where it is once p or A p has vanished: constant data ends like that.
    void step() {
        const Vector q = a_.apply(p_);
        const double square = dot(q, q);
        if (!(g_ > 0.0) || !(square > 0.0)) return;
        const double length = g_ / square;
        correction_ = plus_scaled(correction_, length, p_);
        r_ = plus_scaled(r_, -length, q);
        const Vector s = a_.apply_transpose(r_);
        const double g = dot(s, s);
        p_ = plus_scaled(s, g / g_, p_);
        g_ = g;
    }

  private:
    const RectangularOperator& a_;
    Vector r_, p_, correction_;
    double g_;
};

}  // namespace

Solution solve_cgls(const RectangularOperator& a, const Vector& b, const Vector& start,
                    const StopRule& rule) {
    return minimise<Recurrence>(a, b, start, rule);
}

}  // namespace twofold
