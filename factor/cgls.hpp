#pragma once
#include "factor/solver.hpp"

namespace twofold {

/// Minimises |A x - b| by conjugate gradients on the normal equations, without forming them. Its
/// |A x - b| falls in every iteration (its |A^T r| need not). Arguments and result are those of
/// solve_lsmr().
/// @source Hestenes & Stiefel, Methods of Conjugate Gradients, 1952, section 10; named CGLS by
///         Paige & Saunders, 1982
Solution solve_cgls(const RectangularOperator& a, const Vector& b, const Vector& start,
                    const StopRule& rule);

}  // namespace twofold
