#pragma once
#include "factor/progress.hpp"
#include "factor/row_pass.hpp"
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

/// How far an iteration goes along its directions.
struct LsmrSteps {
    double h_bar, x, h;
};

/// The same as a run that asks for its passes over the rows, one at a time.
class LsmrRun {
  public:
    LsmrRun(Vector start, const StopRule& rule);

    std::optional<RowPass> request() const;
    void take(PassResult result);
    Solution solution();

  private:
    enum class Stage { right_side, start, steps, end, done };

    void begin(PassResult residual);
    void step(PassResult result);
    void finish(double true_residual);
    LsmrSteps rotate();

    Stage stage_ = Stage::right_side;
    Vector start_;
    StopRule rule_;
    std::optional<Progress> progress_;
    std::optional<SolverStatus> end_;
    double scale_ = 0.0;              ///< |A^T b|
    double start_residual_ = 0.0;     ///< relative
    Vector best_;                     ///< what is added to the start, and at the end that sum ...
    bool best_is_correction_ = true;  ///< ... unless it is the last correction
    Solution solution_;

    // Golub-Kahan bidiagonalisation and the two plane rotations of LSMR, names as in the paper. The
    // system's u is not normalised; u_length_ is its length.
    Vector v_, h_, h_bar_, correction_;
    double u_length_ = 0.0;
    double alpha_ = 0.0, alpha_bar_ = 0.0, zeta_bar_ = 0.0;
    double rho_ = 1.0, rho_bar_ = 1.0, c_bar_ = 1.0, s_bar_ = 0.0;
};

}  // namespace twofold
