#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace twofold {

/// How a solve ended. The breakdowns are those of QMR without look-ahead, named after the scalar
/// that vanished.
enum class SolverStatus {
    converged,          ///< the recomputed residual meets the tolerance
    limit,              ///< the iteration limit was reached
    stagnation,         ///< no relative progress over the window, or none left in binary64
    breakdown_rho,      ///< |V| vanished
    breakdown_xi,       ///< |W| vanished
    breakdown_delta,    ///< w.v vanished
    breakdown_epsilon,  ///< q.A p vanished
    breakdown_beta,     ///< epsilon / delta is zero
    breakdown_gamma,    ///< 1 / sqrt(1 + theta^2) is zero
    non_finite          ///< an input, a scalar of the recurrence or the result is not finite
};

/// The name of a status as reports print it, such as "breakdown_rho".
const char* name_of(SolverStatus status);

/// When an iteration stops.
struct StopRule {
    double tolerance = 1e-12;   ///< on the relative residual; below 2^-50 it is taken as 2^-50
    int iteration_limit = 200;  ///< iterations at most
    double breakdown = 1e-12;   ///< t of the relative breakdown tests
    int window = 60;         ///< iterations over which the best residual has to (0 = no test) ...
    double progress = 1e-2;  ///< ... fall by this share of itself, else `stagnation`
    bool keep_best = true;   ///< else the last iterate is returned, whatever became of it, and
                             ///< the tolerance is taken as it stands
};

/// What happened in a solve. Residuals are relative to the right side's norm: |b - A x| / |b| for
/// QMR, |A^T (b - A x)| / |A^T b| for LSMR.
struct SolverReport {
    SolverStatus status = SolverStatus::converged;
    int iterations = 0;              ///< the iteration that the solve ended in
    int best_iteration = 0;          ///< the iteration whose x is returned; 0 is the start vector
    double relative_residual = 0.0;  ///< of the returned x, recomputed from its definition
    std::vector<double> history{};   ///< by recurrence: [0] of the start, [i] after iteration i
};

using Vector = std::vector<double>;

struct Solution {
    Vector x;
    SolverReport report;
};

/// A square matrix as its two products.
struct SquareOperator {
    std::function<Vector(const Vector&)> apply;            ///< A x
    std::function<Vector(const Vector&)> apply_transpose;  ///< A^T x
    double magnitude = 1.0;  ///< about the largest |entry|; decides the power of two of the scaling
    bool symmetric =
        false;  ///< apply_transpose gives the bits of apply, so one product may serve both
};

/// A matrix of `rows` x `columns` as its two products.
struct RectangularOperator {
    std::function<Vector(const Vector&)> apply;            ///< A x, `columns` to `rows` values
    std::function<Vector(const Vector&)> apply_transpose;  ///< A^T y, `rows` to `columns` values
};

}  // namespace twofold
