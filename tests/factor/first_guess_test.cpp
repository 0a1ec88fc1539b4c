#include "factor/first_guess.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/qmr.hpp"
#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

ChannelRows red_rows(const LogRows& left, const LightingSamples& samples,
                     const FactorSettings& settings) {
    std::vector<double> radiance;
    for (const Rgb& rgb : samples.radiance) radiance.push_back(rgb.x);
    return channel_rows(left, radiance, settings, 1.0);
}

/// The pair with normal n and reflected view r.
SurfaceView pair_of(Vec3 n, Vec3 r) { return {n, 2.0 * dot(n, r) * n - r}; }

/// Sum of the weights of the samples that touch each unknown.
Vector touching_weight(const LogRows& left) {
    Vector weight(left.matrix.columns(), 0.0);
    for (std::size_t i = 0; i < left.samples; ++i) {
        for (const MatrixEntry& entry : left.matrix.row(i)) weight[entry.column] += entry.value;
    }
    return weight;
}

/// The inverse-distance fill as its formula says it, in plain loops.
double brute_force_fill(const Vector& x, const Vector& weight, std::size_t first, std::size_t j,
                        const MapShape& shape) {
    const auto direction = [&](std::size_t k) {
        return texel_direction(texel_at(k, shape), shape);
    };
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t k = 0; k < shape.texels(); ++k) {
        if (!(weight[first + k] > 0.0)) continue;
        const double distance = length(direction(j) - direction(k));
        if (distance == 0.0) return x[first + k];
        sum += x[first + k] / (distance * distance);
        total += 1.0 / (distance * distance);
    }
    return sum / total;
}

}  // namespace

TEST_CASE("F05 untouched texels are filled by inverse distance and never own the maximum",
          "[hard][F05]") {
    const FactorSettings settings = cases::unregularised(16, 0.875);
    const LightingSamples samples = cases::samples_of(cases::Phong{}, 3000, 1);
    const LogRows left = log_rows(samples.at, settings);
    const FirstGuess guess = first_guess(left, red_rows(left, samples, settings), 2.0, 1);
    const Vector weight = touching_weight(left);
    const std::size_t texels = left.shape.texels();

    std::size_t untouched = 0;
    for (const std::size_t first : {std::size_t{0}, texels}) {
        double largest_touched = -1e9;
        for (std::size_t j = 0; j < texels; ++j) {
            if (weight[first + j] > 0.0 && guess.x[first + j] > largest_touched) {
                largest_touched = guess.x[first + j];
            }
        }
        for (std::size_t j = 0; j < texels; ++j) {
            if (weight[first + j] > 0.0) continue;
            ++untouched;
            REQUIRE(guess.x[first + j] < largest_touched);
            REQUIRE(guess.x[first + j] ==
                    Approx(brute_force_fill(guess.x, weight, first, j, left.shape)).epsilon(1e-12));
        }
    }
    CHECK(guess.untouched == untouched);
    const double share = static_cast<double>(untouched) / static_cast<double>(2 * texels);
    CHECK(share > 0.15);
    CHECK(share < 0.30);
}

TEST_CASE("another power of the distance goes through the same fill") {
    const FactorSettings settings = cases::unregularised(8, 0.875);
    const LightingSamples samples = cases::samples_of(cases::Phong{}, 500, 1);
    const LogRows left = log_rows(samples.at, settings);
    const ChannelRows right = red_rows(left, samples, settings);
    const Vector two = first_guess(left, right, 2.0, 1).x;
    const Vector almost_two = first_guess(left, right, 2.0 + 1e-12, 1).x;
    CHECK(largest_magnitude(minus(two, almost_two)) < 1e-9);
}

TEST_CASE("in a balanced table of texel centres the first guess is the solution") {
    // Every texel within the rim as normal with every such texel as reflected view: the paper's
    // start vector is then exact, and half the grand mean in each map is what makes it so.
    const MapShape shape{6, 0.875};
    const FactorSettings settings = cases::unregularised(shape.size, shape.guard);
    std::vector<std::size_t> inside;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        if (within_face(texel_at(j, shape), shape)) inside.push_back(j);
    }
    const auto direction = [&](std::size_t j) {
        return texel_direction(texel_at(j, shape), shape);
    };
    LightingSamples samples;
    for (const std::size_t i : inside) {
        for (const std::size_t j : inside) {
            samples.at.push_back(pair_of(direction(i), direction(j)));
            const double log_radiance =
                std::sin(static_cast<double>(i)) + std::cos(1.7 * static_cast<double>(j));
            samples.radiance.push_back(Rgb(std::exp(log_radiance)));
        }
    }
    const LogRows left = log_rows(samples.at, settings);
    const ChannelRows right = red_rows(left, samples, settings);
    const FirstGuess guess = first_guess(left, right, 2.0, 1);
    const Vector error = minus(left.matrix.multiply(guess.x, 1), right.right_side);
    CHECK(largest_magnitude(error) < 1e-11);

    const WeightedSystem system(left, right, settings, 1);
    const Solution solution =
        solve_qmr(normal_equations(system.problem()), system.apply_transpose(system.right_side()),
                  system.scaled_unknowns(guess.x), {.tolerance = 1e-10});
    CHECK(solution.report.status == SolverStatus::converged);
    CHECK(solution.report.iterations == 0);
}

TEST_CASE("the first guess has the same bits at 1, 2 and 7 threads") {
    const FactorSettings settings = cases::unregularised(16, 0.875);
    const LightingSamples samples = cases::samples_of(cases::Phong{}, 3000, 1);
    const LogRows left = log_rows(samples.at, settings);
    const ChannelRows right = red_rows(left, samples, settings);
    const Vector one = first_guess(left, right, 2.0, 1).x;
    CHECK(first_guess(left, right, 2.0, 2).x == one);
    CHECK(first_guess(left, right, 2.0, 7).x == one);
}
