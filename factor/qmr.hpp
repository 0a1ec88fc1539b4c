#pragma once
#include <optional>

#include "factor/solver.hpp"

namespace twofold {

/// Solves A x = b for a square A by the quasi-minimal residual method without look-ahead.
/// A and b are scaled by powers of two first, which changes no bit of a solution in range. Every
/// breakdown test is relative; the best iterate is kept and its residual recomputed, and where that
/// is above the start's, the start is returned. b = 0 gives x = 0 in 0 iterations.
/// @param start first x, as long as b
/// @return x with report.status `non_finite` and x = start (0 where that is not finite either) if
/// an
///         input or the result is not finite
/// @source Barrett et al., Templates for the Solution of Linear Systems, 1994, figure 2.8; after
///         Freund & Nachtigal, QMR: a Quasi-Minimal Residual Method, 1991
Solution solve_qmr(const SquareOperator& a, const Vector& b, const Vector& start,
                   const StopRule& rule);

/// The scalars of one iteration that may vanish.
struct QmrScalars {
    double rho = 1.0, xi = 1.0;  ///< |V|, |W|
    double rho_start = 1.0;      ///< |V| = |W| of the start
    double delta = 1.0;          ///< w.v of the two unit vectors
    double epsilon = 1.0;        ///< q.A p
    double epsilon_scale = 1.0;  ///< |q| |A p|
    double beta = 1.0;           ///< epsilon / delta
    double gamma = 1.0;          ///< 1 / sqrt(1 + theta^2)
};

/// The status of the first scalar, in the order of the algorithm, that is not finite or vanishes
/// against its scale by the relative test with threshold t; nothing while all are sound.
std::optional<SolverStatus> breakdown_of(const QmrScalars& scalars, double t);

}  // namespace twofold
