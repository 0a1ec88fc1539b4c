#include "factor/lobe_variation.hpp"

#include <array>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/evaluate.hpp"
#include "factor/parametrization.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

constexpr std::size_t view_steps = LobeVariation::view_rows - 1;
constexpr int turns = 8;         ///< directions about r
constexpr double step = 0.01;    ///< of the differences, radians
constexpr double margin = 1.25;  ///< for what lies between the directions looked at

using Bounds = LobeVariation::Bounds;

/// f (n.l)+ of a light, largest channel.
double value(const Brdf& brdf, const SurfaceView& at, Vec3 l) {
    return max_component(evaluate(brdf, at.n, at.v, l)) * max(0.0, dot(at.n, l));
}

Vec3 moved(Vec3 l, Vec3 across) { return normalized(l + step * across); }

Bounds differences(const Brdf& brdf, const SurfaceView& at, Vec3 l) {
    const Vec3 u = about(l, 1.0, 0.0, 0.0), w = about(l, 0.0, 1.0, 0.0);
    const double half = std::sqrt(0.5);
    const double here = value(brdf, at, l);
    Bounds found;
    for (const Vec3 across : {u, w, half * (u + w), half * (u - w)}) {
        const double more = value(brdf, at, moved(l, across));
        const double less = value(brdf, at, moved(l, -across));
        found.first = max(found.first, std::fabs(more - less) / (2.0 * step));
        found.second = max(found.second, std::fabs(more - 2.0 * here + less) / (step * step));
    }
    return found;
}

/// A light at a distance from r, `turn` of a full turn about it.
Vec3 light_at(Vec3 r, double distance, double turn) {
    const double along = 1.0 - 0.5 * distance * distance;
    const double across = std::sqrt(max(0.0, 1.0 - along * along));
    const double angle = 2.0 * exact::pi * turn;
    return normalized(about(r, across * exact::cos(angle), across * exact::sin(angle), along));
}

void widen(Bounds& bounds, const Bounds& by) {
    bounds.first = max(bounds.first, by.first);
    bounds.second = max(bounds.second, by.second);
}

/// The largest differences at n.v and each distance, and half a step farther.
std::array<Bounds, LobeVariation::distance_steps> differences_at(const Brdf& brdf, double n_v) {
    const SurfaceView at{{0.0, 0.0, 1.0}, {std::sqrt(max(0.0, 1.0 - n_v * n_v)), 0.0, n_v}};
    std::array<Bounds, LobeVariation::distance_steps> row{};
    for (std::size_t k = 0; k < row.size(); ++k)
        for (int turn = 0; turn < turns; ++turn) {
            const double off = 0.5 * (turn % 2);
            const Vec3 l =
                light_at(pi_2(at), LobeVariation::distance_of(static_cast<double>(k) + off),
                         static_cast<double>(turn) / turns);
            widen(row[k], differences(brdf, at, l));
        }
    return row;
}

}  // namespace

double LobeVariation::distance_of(double position) {
    const double share = position / static_cast<double>(distance_steps);
    return 2.0 * share * share;
}

std::size_t LobeVariation::row_of(double n_v) {
    return to_fixed(std::floor(n_v * static_cast<double>(view_steps) + 0.5), std::size_t{0},
                    view_steps);
}

LobeVariation::LobeVariation(const Brdf& brdf, int threads) : table_(view_rows * distance_steps) {
    std::vector<std::array<Bounds, distance_steps>> rows(2 * view_steps + 1);
    parallel_for(rows.size(), threads, [&](std::size_t i) {
        const double n_v = static_cast<double>(i) / static_cast<double>(rows.size() - 1);
        rows[i] = differences_at(brdf, max(n_v, 1e-3));
    });
    // A row of the table serves views up to half a step away, and looks at one.
    for (std::size_t i = 0; i < view_rows; ++i) {
        Bounds farther;
        for (std::size_t k = distance_steps; k-- > 0;) {
            for (std::size_t j = i == 0 ? 0 : 2 * i - 1; j <= 2 * i + 1 && j < rows.size(); ++j)
                widen(farther, rows[j][k]);
            table_[i * distance_steps + k] = {margin * farther.first, margin * farther.second};
        }
    }
}

}  // namespace twofold
