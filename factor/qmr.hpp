#pragma once
#include <optional>

#include "factor/progress.hpp"
#include "factor/row_pass.hpp"
#include "factor/solver.hpp"

namespace twofold {

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

/// The status of the first scalar, in the order of the algorithm, that is not finite or vanishes
/// against its scale by the relative test with threshold t; nothing while all are sound.
std::optional<SolverStatus> breakdown_of(const QmrScalars& scalars, double t);

/// The same as a run that asks for its products, one at a time.
class QmrRun {
  public:
    /// @param magnitude, symmetric those of SquareOperator
    QmrRun(double magnitude, bool symmetric, const Vector& b, const Vector& start,
           const StopRule& rule);

    bool ended() const { return stage_ == Stage::done; }
    const Vector& argument();  ///< of the product that is wanted, until it is taken ...
    bool transposed() const { return stage_ == Stage::transpose; }  ///< ... with A^T or with A
    void take(Vector product);
    Solution solution();

  private:
    enum class Stage { start, product, transpose, end, done };

    void begin(Vector residual);
    void begin_iteration();
    void take_product(Vector ap);
    void advance_lanczos(const Vector& transposed_product);
    std::optional<SolverStatus> advance_solution();
    void end_with(SolverStatus status);
    void finish(double true_residual);
    Vector scaled_back(Vector product) const;

    // For a symmetric A the two Lanczos bases coincide bit for bit.
    const Vector& w() const { return symmetric_ ? v_ : w_; }
    const Vector& q() const { return symmetric_ ? p_ : q_; }

    // The system in units in which the largest entries of A and b are of order 1. Halves of A's
    // exponent are taken off before and after a product, so that no entry near the limits overflows
    // on the way.
    int matrix_exponent_, solution_exponent_;
    bool symmetric_;
    Vector start_, b_;
    double b_norm_ = 0.0;
    StopRule rule_;

    Stage stage_ = Stage::start;
    std::optional<Progress> progress_;
    double start_residual_ = 0.0;  ///< relative
    SolverStatus status_ = SolverStatus::converged;
    int iteration_ = 0;
    Vector best_, argument_;
    Solution solution_;

    // The coupled two-term recurrences; names as in Templates, figure 2.8, with V and W the
    // unscaled Lanczos vectors.
    Vector x_, r_;
    Vector lanczos_v_, lanczos_w_;
    Vector v_, w_;  ///< of unit length, until the next of the unscaled ones take their memory
    Vector p_, q_, ap_;
    Vector d_, s_;  ///< steps of x and of the residual
    QmrScalars scalars_;
    double rho_before_ = 1.0;
    double epsilon_before_ = 1.0;
    double theta_ = 0.0;
    double eta_ = -1.0;
    bool first_ = true;
};

/// QMR on the normal equations of several systems over the same rows, in lockstep.
/// @param magnitude about the largest entry of A^T A of each
std::vector<Solution> solve_qmr_together(const RowPasses& make, const std::vector<Vector>& start,
                                         const Vector& magnitude, const StopRule& rule,
                                         int threads);

}  // namespace twofold
