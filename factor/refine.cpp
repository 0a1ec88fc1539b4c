#include "factor/refine.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "factor/lsmr.hpp"
#include "factor/vector_arithmetic.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// How sharply divided_terms() parts the directions: weights fall by e^-sharpness at a right angle.
constexpr double sharpness = 6.0;

std::span<const double> part(const Vector& x, std::size_t first, std::size_t count) {
    return std::span(x).subspan(first, count);
}

Vector exponentials(const Vector& x) {
    Vector t(x.size());
    for (std::size_t j = 0; j < x.size(); ++j) t[j] = exact::exp(x[j]);
    return t;
}

/// The products at the samples and their derivatives by the logarithms of the texels, at one x.
class Linearised {
  public:
    Linearised(const ProductRows& rows, const ProductTarget& target, const Vector& x, int threads)
        : rows_(rows), target_(target), texels_(exponentials(x)), threads_(threads) {
        sum_.assign(target.radiance.size(), 0.0);
        for (std::size_t k = 0; k < terms(); ++k) add_term(k);
        error_ = minus(target.radiance, sum_);
        for (std::size_t i = 0; i < error_.size(); ++i) error_[i] *= target.weight[i];
        for (std::size_t k = 0; k < terms(); ++k) {
            const Vector pull = rows.regulariser.multiply(term(x, k), threads);
            for (const double value : pull) error_.push_back(-value);
        }
        scale_columns();
    }

    std::size_t terms() const { return texels_.size() / rows_.unknowns(); }

    /// Weighted errors of the samples, then the negative residuals of the regulariser's rows.
    const Vector& error() const { return error_; }

    double objective() const { return norm(error_); }

    /// The step of the logarithms that the linearised rows ask for.
    Vector step() const {
        const RectangularOperator jacobian{[this](const Vector& y) { return apply(y); },
                                           [this](const Vector& r) { return apply_transpose(r); }};
        const StopRule rule{.tolerance = 1e-3, .iteration_limit = 40};
        return divided_by_scale(solve_lsmr(jacobian, error_, Vector(texels_.size(), 0.0), rule).x);
    }

  private:
    std::span<const double> term(const Vector& x, std::size_t k) const {
        return part(x, k * rows_.unknowns(), rows_.unknowns());
    }

    /// Calls visit(factor, its first unknown) for the factors of a term.
    template <class Visit>
    void for_factors(std::size_t k, const Visit& visit) const {
        std::size_t first = k * rows_.unknowns();
        for (std::size_t f = 0; f < rows_.factors.size(); ++f) {
            visit(f, first);
            first += rows_.factors[f].columns();
        }
    }

    /// slope_[k F + f] = weight x P_k / T_f: what a row's entries of that factor are multiplied by.
    void add_term(std::size_t k) {
        std::vector<Vector> factor;
        for_factors(k, [&](std::size_t f, std::size_t first) {
            factor.push_back(rows_.factors[f].multiply(
                part(texels_, first, rows_.factors[f].columns()), threads_));
        });
        for (std::size_t f = 0; f < factor.size(); ++f) {
            Vector slope = target_.weight;
            for (std::size_t g = 0; g < factor.size(); ++g)
                for (std::size_t i = 0; g != f && i < slope.size(); ++i) slope[i] *= factor[g][i];
            slope_.push_back(std::move(slope));
        }
        for (std::size_t i = 0; i < sum_.size(); ++i) {
            double product = factor[0][i];
            for (std::size_t f = 1; f < factor.size(); ++f) product *= factor[f][i];
            sum_[i] += product;
        }
    }

    void scale_columns() {
        const Vector ones(rows_.regulariser.rows(), 1.0);
        const Vector smooth = rows_.regulariser.column_norms(ones, threads_);
        scale_.resize(texels_.size());
        for (std::size_t k = 0; k < terms(); ++k)
            for_factors(k, [&](std::size_t f, std::size_t first) {
                const Vector norms = rows_.factors[f].column_norms(slope(k, f), threads_);
                for (std::size_t j = 0; j < norms.size(); ++j) {
                    const double sample = norms[j] * texels_[first + j];
                    const double rest = smooth[first + j - k * rows_.unknowns()];
                    const double length = std::sqrt(sample * sample + rest * rest);
                    scale_[first + j] = length > 0.0 ? length : 1.0;
                }
            });
    }

    const Vector& slope(std::size_t k, std::size_t f) const {
        return slope_[k * rows_.factors.size() + f];
    }

    Vector divided_by_scale(Vector y) const {
        for (std::size_t j = 0; j < y.size(); ++j) y[j] /= scale_[j];
        return y;
    }

    Vector apply(const Vector& y) const {
        const Vector x = divided_by_scale(y);
        Vector result(target_.radiance.size(), 0.0);
        for (std::size_t k = 0; k < terms(); ++k)
            for_factors(k, [&](std::size_t f, std::size_t first) {
                const std::size_t count = rows_.factors[f].columns();
                Vector moved(count);
                for (std::size_t j = 0; j < count; ++j)
                    moved[j] = texels_[first + j] * x[first + j];
                const Vector by = rows_.factors[f].multiply(moved, threads_);
                const Vector& s = slope(k, f);
                for (std::size_t i = 0; i < result.size(); ++i) result[i] += s[i] * by[i];
            });
        for (std::size_t k = 0; k < terms(); ++k) {
            const Vector smooth = rows_.regulariser.multiply(term(x, k), threads_);
            result.insert(result.end(), smooth.begin(), smooth.end());
        }
        return result;
    }

    Vector apply_transpose(const Vector& r) const {
        const std::size_t samples = target_.radiance.size();
        Vector result(texels_.size());
        Vector weighted(samples);
        for (std::size_t k = 0; k < terms(); ++k) {
            const std::size_t rest = rows_.regulariser.rows();
            const Vector smooth =
                rows_.regulariser.multiply_transpose(part(r, samples + k * rest, rest), threads_);
            for_factors(k, [&](std::size_t f, std::size_t first) {
                const Vector& s = slope(k, f);
                for (std::size_t i = 0; i < samples; ++i) weighted[i] = s[i] * r[i];
                const Vector by = rows_.factors[f].multiply_transpose(weighted, threads_);
                for (std::size_t j = 0; j < by.size(); ++j)
                    result[first + j] =
                        texels_[first + j] * by[j] + smooth[first + j - k * rows_.unknowns()];
            });
        }
        return divided_by_scale(std::move(result));
    }

    const ProductRows& rows_;
    const ProductTarget& target_;
    Vector texels_;
    int threads_;
    Vector sum_;  ///< P
    Vector error_;
    std::vector<Vector> slope_;
    Vector scale_;  ///< norms of the columns
};

/// The brightest directions of t2, each found as far from the earlier ones as its light allows.
std::vector<Vec3> bright_directions(std::span<const double> logs, std::size_t count,
                                    const MapShape& shape) {
    std::vector<Vec3> found;
    while (found.size() < count) {
        double best = -1.0;
        Vec3 direction{0.0, 0.0, 1.0};
        for (std::size_t j = 0; j < logs.size(); ++j) {
            const MapTexel texel = texel_at(j, shape);
            if (!within_face(texel, shape)) continue;
            const Vec3 d = texel_direction(texel, shape);
            double away = 2.0;
            for (const Vec3 other : found) away = min(away, 1.0 - dot(d, other));
            const double value = exact::exp(logs[j]) * away * away;
            if (value > best) {
                best = value;
                direction = d;
            }
        }
        found.push_back(direction);
    }
    return found;
}

}  // namespace

ProductRows product_rows(const LogRows& rows) {
    const FactorStarts starts = rows.starts();
    std::vector<RowBuilder> builders(starts.size() - 1);
    for (std::size_t i = 0; i < rows.samples; ++i) {
        const auto row = rows.matrix.row(i);
        std::size_t from = 0;
        for (std::size_t f = 0; f < builders.size(); ++f) {
            std::vector<MatrixEntry> entries;
            for (; from < row.size() && row[from].column < starts[f + 1]; ++from)
                entries.push_back(
                    {row[from].column - static_cast<std::uint32_t>(starts[f]), row[from].value});
            builders[f].add(entries);
        }
    }
    RowBuilder rest;
    for (std::size_t i = rows.samples; i < rows.matrix.rows(); ++i) {
        const RowEntries row = rows.matrix.row(i);
        rest.add({row.begin(), row.end()});
    }
    ProductRows result{{}, rest.build(rows.matrix.columns()), rows.shape};
    for (std::size_t f = 0; f < builders.size(); ++f)
        result.factors.push_back(builders[f].build(starts[f + 1] - starts[f]));
    return result;
}

ProductTarget product_target(const ChannelRows& rows, std::size_t samples, double exponent) {
    ProductTarget target{Vector(samples), Vector(samples, 0.0)};
    for (std::size_t i = 0; i < samples; ++i) {
        if (!(rows.weight[i] > 0.0)) continue;
        const double radiance = exact::exp(rows.right_side[i]);
        target.radiance[i] = radiance;
        target.weight[i] = exact::pow(radiance / rows.mean, exponent) / radiance;
    }
    return target;
}

Vector divided_terms(const Vector& x, std::size_t terms, const MapShape& shape) {
    const std::size_t first = shape.texels();
    const auto centres = bright_directions(part(x, first, shape.texels()), terms, shape);
    Vector all;
    for (std::size_t k = 0; k < terms; ++k) all.insert(all.end(), x.begin(), x.end());
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const Vec3 d = texel_direction(texel_at(j, shape), shape);
        double total = 0.0;
        for (const Vec3 c : centres) total += exact::exp(sharpness * dot(d, c));
        for (std::size_t k = 0; k < terms; ++k)
            all[k * x.size() + first + j] += sharpness * dot(d, centres[k]) - exact::log(total);
    }
    return all;
}

Refined refine(const ProductRows& rows, const ProductTarget& target, Vector x, int steps,
               int threads) {
    std::optional<Linearised> now(std::in_place, rows, target, x, threads);
    const double per_row = 1.0 / std::sqrt(static_cast<double>(target.radiance.size()));
    Refined result{std::move(x), {now->objective() * per_row}};
    for (int n = 0; n < steps; ++n) {
        const Vector step = now->step();
        double length = 1.0;
        for (int halvings = 0; halvings < 5; ++halvings, length *= 0.5) {
            Vector moved = plus_scaled(result.x, length, step);
            Linearised there(rows, target, moved, threads);
            if (!(there.objective() < now->objective())) continue;
            result.x = std::move(moved);
            result.objective.push_back(there.objective() * per_row);
            now.emplace(std::move(there));
            break;
        }
        if (result.objective.size() != static_cast<std::size_t>(n) + 2) break;
    }
    return result;
}

}  // namespace twofold
