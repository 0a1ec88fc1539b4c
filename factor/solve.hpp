#pragma once
#include "factor/settings.hpp"
#include "factor/solver.hpp"

namespace twofold {

/// min |A x - b| as its operator, its right side and the size of what QMR sees of it.
struct LeastSquaresProblem {
    RectangularOperator a;
    Vector b;
    double magnitude = 1.0;  ///< about the largest entry of A^T A
};

/// A^T A as an operator of its own.
SquareOperator normal_equations(const LeastSquaresProblem& problem);

/// Solves it by the named solver. Whatever the solver, residuals of rule, history and report are
/// |A^T (b - A x)| / |A^T b|:
/// `qmr` runs on the normal equations A^T A x = A^T b, where it is MINRES and its iterates are
/// those of `lsmr`; `qmr_augmented` on [I A; A^T 0] (r; x) = (b; 0), which is indefinite and takes
/// about twice the iterations (its residual counts that of the first row as well).
/// @param start first x, as long as A has columns
Solution solve(Solver solver, const LeastSquaresProblem& problem, const Vector& start,
               const StopRule& rule);

}  // namespace twofold
