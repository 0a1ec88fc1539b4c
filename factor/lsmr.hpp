#pragma once
#include "factor/solver.hpp"

namespace twofold {

/// Minimises |A x - b| by LSMR, whose |A^T r| falls in every iteration, so that stopping early is
/// safe. On the same problem it gives the iterates of QMR on the normal equations A^T A x = A^T b,
/// for one product with A and one with A^T an iteration. The residual of report and rule is |A^T (b
/// - A x)| / |A^T b|; x is the best iterate, or the start where none is better. A right side with
/// A^T b = 0 gives x = 0 in 0 iterations.
/// @param b as long as A has rows
/// @param start first x, as long as A has columns
/// @source Fong & Saunders, LSMR: An Iterative Algorithm for Sparse Least-Squares Problems, 2011
Solution solve_lsmr(const RectangularOperator& a, const Vector& b, const Vector& start,
                    const StopRule& rule);

}  // namespace twofold
