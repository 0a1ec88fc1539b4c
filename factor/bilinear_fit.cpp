#include "factor/bilinear_fit.hpp"

#include <cmath>
#include <utility>

#include "factor/lsmr.hpp"
#include "texunit/random.hpp"

namespace twofold {

namespace {

/// Rounds in which a new term is fitted alone to the residual.
constexpr int rounds_alone = 2;

/// Of the linear systems: each starts from the result of the round before.
constexpr StopRule half_round{.tolerance = 1e-4, .iteration_limit = 6};

/// Of the last round, in which unknowns that only the regulariser knows, such as texels beyond the
/// rim, find their values.
constexpr StopRule last_round{.tolerance = 1e-5, .iteration_limit = 100};

/// A round that lowers the objective by less than this share of itself is the last. So small
/// because the fit may crawl along for tens of rounds before a term finds its place.
constexpr double least_progress = 1e-5;

TermVectors read_at_samples(const BilinearSide& side, const TermVectors& terms, int threads) {
    TermVectors values;
    for (const Vector& term : terms) values.push_back(side.footprint.multiply(term, threads));
    return values;
}

/// The linear problem of one side, the other's values at the samples given: rows of the samples,
/// then those of the regulariser for each term, in units of the other side's rms; columns scaled to
/// length 1.
class SideSystem {
  public:
    SideSystem(const BilinearSide& side, TermVectors slope, std::span<const double> weight,
               int threads)
        : side_(side), slope_(std::move(slope)), threads_(threads) {
        const double samples = static_cast<double>(weight.size());
        const Vector ones(side.regulariser.rows(), 1.0);
        const Vector smooth = side.regulariser.column_norms(ones, threads);
        for (Vector& s : slope_) {
            pull_.push_back(norm(s) / std::sqrt(samples));
            for (std::size_t i = 0; i < s.size(); ++i) s[i] *= weight[i];
            Vector scale = side.footprint.column_norms(s, threads);
            for (std::size_t k = 0; k < scale.size(); ++k) {
                const double rest = pull_.back() * smooth[k];
                const double length = std::sqrt(scale[k] * scale[k] + rest * rest);
                scale[k] = length > 0.0 ? length : 1.0;
            }
            scale_.push_back(std::move(scale));
        }
    }

    /// @param start unknowns to begin with, and then their shape @param b weighted values
    TermVectors solved(const TermVectors& start, Vector b, const StopRule& rule) const {
        b.resize(b.size() + slope_.size() * side_.regulariser.rows(), 0.0);
        const RectangularOperator a{[this](const Vector& y) { return apply(y); },
                                    [this](const Vector& r) { return apply_transpose(r); }};
        return unscaled(solve_lsmr(a, b, in_columns(start), rule).x);
    }

  private:
    std::size_t unknowns() const { return side_.footprint.columns(); }

    Vector in_columns(const TermVectors& x) const {
        Vector y;
        for (std::size_t j = 0; j < x.size(); ++j)
            for (std::size_t k = 0; k < unknowns(); ++k) y.push_back(x[j][k] * scale_[j][k]);
        return y;
    }

    TermVectors unscaled(const Vector& y) const {
        TermVectors x(slope_.size(), Vector(unknowns()));
        for (std::size_t j = 0; j < x.size(); ++j)
            for (std::size_t k = 0; k < unknowns(); ++k)
                x[j][k] = y[j * unknowns() + k] / scale_[j][k];
        return x;
    }

    Vector apply(const Vector& y) const {
        const TermVectors x = unscaled(y);
        const std::size_t samples = side_.footprint.rows();
        Vector result(samples, 0.0);
        for (std::size_t j = 0; j < x.size(); ++j) {
            const Vector by = side_.footprint.multiply(x[j], threads_);
            for (std::size_t i = 0; i < samples; ++i) result[i] += slope_[j][i] * by[i];
        }
        for (std::size_t j = 0; j < x.size(); ++j)
            for (const double pull : side_.regulariser.multiply(x[j], threads_))
                result.push_back(pull_[j] * pull);
        return result;
    }

    Vector apply_transpose(const Vector& r) const {
        const std::size_t samples = side_.footprint.rows(), rest = side_.regulariser.rows();
        Vector y, weighted(samples), pull(rest);
        for (std::size_t j = 0; j < slope_.size(); ++j) {
            for (std::size_t i = 0; i < samples; ++i) weighted[i] = slope_[j][i] * r[i];
            for (std::size_t i = 0; i < rest; ++i) pull[i] = pull_[j] * r[samples + j * rest + i];
            const Vector by = side_.footprint.multiply_transpose(weighted, threads_);
            const Vector smooth = side_.regulariser.multiply_transpose(pull, threads_);
            for (std::size_t k = 0; k < by.size(); ++k)
                y.push_back((by[k] + smooth[k]) / scale_[j][k]);
        }
        return y;
    }

    const BilinearSide& side_;
    TermVectors slope_;  ///< weight x the other side's value, by term
    Vector pull_;        ///< by term: rms of the other side, the regulariser's unit
    TermVectors scale_;  ///< lengths of the columns
    int threads_;
};

/// Makes `basis` orthonormal and puts what that takes off into `other`, so that the sum of products
/// stays what it is. A vector that the earlier ones hold becomes 0.
void orthonormalise(TermVectors& basis, TermVectors& other) {
    for (std::size_t j = 0; j < basis.size(); ++j) {
        const double before = norm(basis[j]);
        for (std::size_t k = 0; k < j; ++k) {
            const double along = dot(basis[k], basis[j]);
            basis[j] = plus_scaled(basis[j], -along, basis[k]);
            other[k] = plus_scaled(other[k], along, other[j]);
        }
        const double length = norm(basis[j]);
        const double inverse = length > 1e-12 * before ? 1.0 / length : 0.0;
        basis[j] = scaled(inverse, basis[j]);
        other[j] = scaled(length, other[j]);
    }
}

/// Values less the sum of products.
Vector residual_of(const BilinearProblem& problem, const TermVectors& first,
                   const TermVectors& second, int threads) {
    const TermVectors a = read_at_samples(problem.first, first, threads);
    const TermVectors b = read_at_samples(problem.second, second, threads);
    Vector residual(problem.values.begin(), problem.values.end());
    for (std::size_t j = 0; j < a.size(); ++j)
        for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= a[j][i] * b[j][i];
    return residual;
}

double weighted_rms(Vector residual, std::span<const double> weight) {
    for (std::size_t i = 0; i < residual.size(); ++i) residual[i] *= weight[i];
    return norm(residual) / std::sqrt(static_cast<double>(residual.size()));
}

/// One side's best terms for the other's.
TermVectors side_round(const BilinearSide& side, const BilinearSide& other,
                       const TermVectors& start, const TermVectors& others,
                       const BilinearProblem& p, const StopRule& rule, int threads) {
    Vector b(p.values.begin(), p.values.end());
    for (std::size_t i = 0; i < b.size(); ++i) b[i] *= p.weight[i];
    return SideSystem(side, read_at_samples(other, others, threads), p.weight, threads)
        .solved(start, std::move(b), rule);
}

/// Both sides once.
void full_round(const BilinearProblem& p, TermVectors& first, TermVectors& second,
                const StopRule& rule, int threads) {
    orthonormalise(second, first);
    first = side_round(p.first, p.second, first, second, p, rule, threads);
    orthonormalise(first, second);
    second = side_round(p.second, p.first, second, first, p, rule, threads);
}

/// A first v for a new term: the mean over the samples of the residual times random signs of x,
/// which holds something of every product that is left.
Vector start_of(const BilinearProblem& p, const Vector& residual, std::size_t term, int threads) {
    Vector pattern(p.first.footprint.columns());
    for (std::size_t k = 0; k < pattern.size(); ++k)
        pattern[k] = 2.0 * random_unit(term, k) - (term == 0 ? 0.0 : 1.0);
    Vector weighted = p.first.footprint.multiply(pattern, threads);
    Vector used(weighted.size());
    for (std::size_t i = 0; i < weighted.size(); ++i) {
        weighted[i] *= residual[i] * p.weight[i];
        used[i] = p.weight[i];
    }
    Vector start = p.second.footprint.multiply_transpose(weighted, threads);
    const Vector total = p.second.footprint.multiply_transpose(used, threads);
    for (std::size_t k = 0; k < start.size(); ++k)
        start[k] = total[k] > 0.0 ? start[k] / total[k] : 0.0;
    return start;
}

/// Rotates columns until those of `first` are orthogonal, the longest first.
/// @source Hestenes, Inversion of matrices by biorthogonalization and related results, 1958
void rotate_columns(TermVectors& first, TermVectors& second) {
    const auto rotate = [](Vector& a, Vector& b, double c, double s) {
        for (std::size_t k = 0; k < a.size(); ++k) {
            const double x = a[k], y = b[k];
            a[k] = c * x + s * y;
            b[k] = c * y - s * x;
        }
    };
    for (int sweep = 0; sweep < 30; ++sweep)
        for (std::size_t j = 0; j < first.size(); ++j)
            for (std::size_t k = j + 1; k < first.size(); ++k) {
                const double a = dot(first[j], first[j]), b = dot(first[k], first[k]);
                const double across = dot(first[j], first[k]);
                const double half = 0.5 * (a - b);
                const double root = std::sqrt(half * half + across * across);
                if (!(root > 0.0)) continue;
                // The angle of the eigenvectors of (a, across; across, b), the larger value first.
                const double large = std::sqrt(0.5 * (1.0 + std::fabs(half) / root));
                const double small = across / (2.0 * root * large);
                const double c = half < 0.0 ? small : large, s = half < 0.0 ? large : small;
                rotate(first[j], first[k], c, s);
                rotate(second[j], second[k], c, s);
            }
}

double sum_of(const Vector& x) { return dot(x, Vector(x.size(), 1.0)); }

/// Appends a product, fitted alone to what the others leave.
void add_term(const BilinearProblem& problem, SignedSum& sum, std::size_t term, int threads) {
    const Vector rest = residual_of(problem, sum.first, sum.second, threads);
    const BilinearProblem alone{problem.first, problem.second, rest, problem.weight};
    TermVectors u{Vector(problem.first.footprint.columns(), 0.0)};
    TermVectors v{start_of(problem, rest, term, threads)};
    for (int n = 0; n < rounds_alone; ++n) full_round(alone, u, v, half_round, threads);
    sum.first.push_back(std::move(u[0]));
    sum.second.push_back(std::move(v[0]));
}

}  // namespace

void make_orthogonal(TermVectors& first, TermVectors& second) {
    orthonormalise(second, first);
    rotate_columns(first, second);
    for (std::size_t j = 0; j < second.size(); ++j) {
        if (!(sum_of(second[j]) < 0.0)) continue;
        first[j] = scaled(-1.0, first[j]);
        second[j] = scaled(-1.0, second[j]);
    }
}

SignedSum fit_signed_sum(const BilinearProblem& problem, std::size_t terms, int rounds,
                         int threads) {
    SignedSum sum;
    const auto record = [&] {
        const Vector rest = residual_of(problem, sum.first, sum.second, threads);
        sum.objective.push_back(weighted_rms(rest, problem.weight));
    };
    record();
    for (std::size_t j = 0; j < terms; ++j) {
        add_term(problem, sum, j, threads);
        record();
    }
    for (int n = 0; n < rounds && !sum.stationary; ++n) {
        full_round(problem, sum.first, sum.second, half_round, threads);
        const double before = sum.objective.back();
        record();
        sum.stationary = !(sum.objective.back() < (1.0 - least_progress) * before);
    }
    full_round(problem, sum.first, sum.second, last_round, threads);
    record();
    make_orthogonal(sum.first, sum.second);
    return sum;
}

}  // namespace twofold
