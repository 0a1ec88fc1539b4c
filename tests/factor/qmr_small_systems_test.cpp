#include <catch2/catch.hpp>
#include <map>

#include "dense_matrix.hpp"
#include "factor/qmr.hpp"

using namespace twofold;
using cases::Dense;

namespace {

using Status = SolverStatus;

constexpr StopRule strict{.tolerance = 1e-12, .iteration_limit = 30};

/// The vector of -1, 0 and 1 whose base-3 digits, lowest first, make up `code`.
Vector trits(int code, std::size_t n) {
    Vector values(n);
    for (double& value : values) {
        value = code % 3 - 1;
        code /= 3;
    }
    return values;
}

int power_of_three(std::size_t n) {
    int power = 1;
    for (std::size_t i = 0; i < n; ++i) power *= 3;
    return power;
}

Dense trit_matrix(int code, std::size_t n) {
    const Vector entries = trits(code, n * n);
    Dense a(n, Vector(n));
    for (std::size_t i = 0; i < n * n; ++i) a[i / n][i % n] = entries[i];
    return a;
}

/// Calls visit(A, operator of A, b) for all 512,406 systems of F15.
template <class Visit>
void for_all_small_systems(const Visit& visit) {
    for (const std::size_t n : {2U, 3U}) {
        for (int a_code = 0; a_code < power_of_three(n * n); ++a_code) {
            const Dense a = trit_matrix(a_code, n);
            const SquareOperator a_operator = cases::square_operator(a);
            for (int b_code = 1; b_code < power_of_three(n); ++b_code) {
                visit(a, a_operator, trits(b_code, n));
            }
        }
    }
}

}  // namespace

TEST_CASE("F15 all 512,406 systems of entries -1, 0 and 1 end under the pinned names",
          "[hard][F15][long]") {
    std::map<std::string, int> count;
    int unsound = 0;
    for_all_small_systems([&](const Dense& a, const SquareOperator& a_operator, const Vector& b) {
        const Solution s = solve_qmr(a_operator, b, Vector(b.size(), 0.0), strict);
        const bool zero = largest_magnitude(b) == 0.0;
        ++count[zero ? "b = 0" : name_of(s.report.status)];
        const double residual = norm(minus(b, cases::product(a, s.x)));
        const bool sound =
            all_finite(s.x) && residual <= norm(b) &&
            (s.report.status != Status::converged || residual <= 1.001e-12 * norm(b));
        unsound += sound ? 0 : 1;
    });
    CHECK(unsound == 0);
    CHECK(count == std::map<std::string, int>{{"b = 0", 19764},
                                              {"converged", 213528},
                                              {"breakdown_delta", 25056},
                                              {"breakdown_epsilon", 198894},
                                              {"breakdown_rho", 2760},
                                              {"breakdown_xi", 52404}});
}

TEST_CASE("F15 with exact-zero tests the 3 x 3 systems run into the limit and lose the residual",
          "[hard][F15][long]") {
    // The mutant that the relative tests are there to beat; even it never claims convergence
    // falsely, because the residual is recomputed.
    const StopRule exact_zero{.tolerance = 1e-12, .iteration_limit = 30, .breakdown = 0.0};
    int at_limit = 0;
    int false_claims = 0;
    for_all_small_systems([&](const Dense& a, const SquareOperator& a_operator, const Vector& b) {
        const Solution s = solve_qmr(a_operator, b, Vector(b.size(), 0.0), exact_zero);
        at_limit += s.report.status == Status::limit ? 1 : 0;
        const bool claims = s.report.status == Status::converged;
        const double residual = norm(minus(b, cases::product(a, s.x)));
        false_claims += claims && residual > 1.001e-12 * norm(b) ? 1 : 0;
    });
    CHECK(at_limit > 10000);
    CHECK(false_claims == 0);
}
