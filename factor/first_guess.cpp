#include "factor/first_guess.hpp"

#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// A touched texel as the fill sees it.
struct Known {
    Vec3 direction;
    double value;
};

/// d^-power from the square of d; the usual power needs no logarithm.
double inverse_distance(double square, double power) {
    return power == 2.0 ? 1.0 / square : exact::pow(square, -0.5 * power);
}

double fill(Vec3 direction, const std::vector<Known>& known, double power) {
    std::vector<double> weight(known.size());
    for (std::size_t k = 0; k < known.size(); ++k) {
        const Vec3 chord = direction - known[k].direction;
        const double square = dot(chord, chord);
        if (square == 0.0) return known[k].value;
        weight[k] = inverse_distance(square, power);
    }
    const double total = ordered_sum(known.size(), [&](std::size_t k) { return weight[k]; });
    return ordered_sum(known.size(), [&](std::size_t k) { return weight[k] * known[k].value; }) /
           total;
}

}  // namespace

std::size_t fill_untouched(Vector& x, const Vector& weight, std::size_t first,
                           const MapShape& shape, double power, int threads) {
    const auto direction = [&](std::size_t j) {
        return texel_direction(texel_at(j, shape), shape);
    };
    std::vector<Known> known;
    std::vector<std::size_t> untouched;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        if (weight[first + j] > 0.0) {
            known.push_back({direction(j), x[first + j]});
        } else {
            untouched.push_back(j);
        }
    }
    parallel_for(untouched.size(), threads, [&](std::size_t k) {
        x[first + untouched[k]] = fill(direction(untouched[k]), known, power);
    });
    return untouched.size();
}

FirstGuess first_guess(const LogRows& left, const ChannelRows& right, double power, int threads) {
    const Vector weight = left.matrix.multiply_transpose(
        [&](std::size_t i) { return i < left.samples && right.weight[i] > 0.0 ? 1.0 : 0.0; },
        threads);
    FirstGuess guess{left.matrix.multiply_transpose(right.right_side, threads)};
    const double half_mean =
        0.5 * ordered_sum(left.samples, [&](std::size_t i) { return right.right_side[i]; }) /
        static_cast<double>(right.treated.used);
    const std::size_t first_knot = 2 * left.shape.texels();
    for (std::size_t j = 0; j < guess.x.size(); ++j) {
        const double share = j < first_knot ? half_mean : 2.0 * half_mean;
        guess.x[j] = weight[j] > 0.0 ? guess.x[j] / weight[j] - share : 0.0;
    }
    for (const std::size_t first : {std::size_t{0}, left.shape.texels()}) {
        guess.untouched += fill_untouched(guess.x, weight, first, left.shape, power, threads);
    }
    return guess;
}

}  // namespace twofold
