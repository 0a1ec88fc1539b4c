#include "factor/solve.hpp"

#include <utility>

#include "factor/cgls.hpp"
#include "factor/lsmr.hpp"
#include "factor/qmr.hpp"
#include "factor/vector_arithmetic.hpp"

namespace twofold {

namespace {

Vector joined(Vector first, const Vector& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The first `count` values of a vector, and the rest.
std::pair<Vector, Vector> parted(const Vector& x, std::size_t count) {
    const auto middle = x.begin() + static_cast<std::ptrdiff_t>(count);
    return {{x.begin(), middle}, {middle, x.end()}};
}

/// Turns residuals relative to |b| into residuals relative to |A^T b|.
SolverReport in_units_of_gradient(SolverReport report, double ratio) {
    report.relative_residual *= ratio;
    for (double& residual : report.history) residual *= ratio;
    return report;
}

Solution on_augmented_system(const LeastSquaresProblem& problem, const Vector& start,
                             const StopRule& rule) {
    const RectangularOperator& a = problem.a;
    const std::size_t rows = problem.b.size();
    const auto product = [&](const Vector& y) {
        const auto [r, x] = parted(y, rows);
        return joined(plus_scaled(r, 1.0, a.apply(x)), a.apply_transpose(r));
    };
    const double gradient = norm(a.apply_transpose(problem.b));
    if (gradient == 0.0) return {Vector(start.size(), 0.0), {.history = {0.0}}};
    const double ratio = norm(problem.b) / gradient;
    // From r = 0: with r = b - A x the first step would find q.A p = 0.
    StopRule in_units_of_b = rule;
    in_units_of_b.tolerance = rule.tolerance / ratio;
    Solution solution =
        solve_qmr({product, product, 1.0, true}, joined(problem.b, Vector(start.size(), 0.0)),
                  joined(Vector(rows, 0.0), start), in_units_of_b);
    return {parted(solution.x, rows).second,
            in_units_of_gradient(std::move(solution.report), ratio)};
}

}  // namespace

SquareOperator normal_equations(const LeastSquaresProblem& problem) {
    const auto product = [a = problem.a](const Vector& y) { return a.apply_transpose(a.apply(y)); };
    return {product, product, problem.magnitude, true};
}

Solution solve(Solver solver, const LeastSquaresProblem& problem, const Vector& start,
               const StopRule& rule) {
    switch (solver) {
        case Solver::qmr:
            return solve_qmr(normal_equations(problem), problem.a.apply_transpose(problem.b), start,
                             rule);
        case Solver::qmr_augmented:
            return on_augmented_system(problem, start, rule);
        case Solver::lsmr:
            return solve_lsmr(problem.a, problem.b, start, rule);
        case Solver::cgls:
            return solve_cgls(problem.a, problem.b, start, rule);
    }
    return {start, {.status = SolverStatus::non_finite}};
}

}  // namespace twofold
