#include "factor/first_guess.hpp"

#include <algorithm>
#include <utility>

#include "factor/simd_clones.hpp"
#include "factor/vector_arithmetic.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// Touched texels as the fill sees them: their directions and values.
struct Known {
    Vector x, y, z, value;

    void add(Vec3 direction, double of) {
        x.push_back(direction.x);
        y.push_back(direction.y);
        z.push_back(direction.z);
        value.push_back(of);
    }
};

/// Squares of the chords from a direction.
TWOFOLD_SIMD_CLONES
Vector squares(Vec3 direction, const Known& known) {
    Vector square(known.value.size());
    const double* const x = known.x.data();
    const double* const y = known.y.data();
    const double* const z = known.z.data();
    for (std::size_t k = 0; k < square.size(); ++k) {
        const double dx = direction.x - x[k], dy = direction.y - y[k], dz = direction.z - z[k];
        square[k] = dx * dx + dy * dy + dz * dz;
    }
    return square;
}

/// d^-power from the squares of d; the usual power needs no logarithm.
TWOFOLD_SIMD_CLONES
Vector inverse_distances(Vector square, double power) {
    if (power == 2.0)
        for (double& value : square) value = 1.0 / value;
    else
        for (double& value : square) value = exact::pow(value, -0.5 * power);
    return square;
}

double fill(Vec3 direction, const Known& known, double power) {
    Vector square = squares(direction, known);
    const auto same = std::find(square.begin(), square.end(), 0.0);
    if (same != square.end()) return known.value[static_cast<std::size_t>(same - square.begin())];
    const Vector weight = inverse_distances(std::move(square), power);
    return dot(weight, known.value) / total(weight);
}

}  // namespace

std::size_t fill_untouched(Vector& x, const Vector& weight, std::size_t first,
                           const MapShape& shape, double power, int threads) {
    const auto direction = [&](std::size_t j) {
        return texel_direction(texel_at(j, shape), shape);
    };
    Known known;
    std::vector<std::size_t> untouched;
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        if (weight[first + j] > 0.0) {
            known.add(direction(j), x[first + j]);
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
