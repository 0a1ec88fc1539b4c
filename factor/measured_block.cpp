#include "factor/light_block.hpp"
#include "factor/light_lanes.hpp"
#include "factor/simd_clones.hpp"

// First the coordinates of all lights of a run, which become vectors, then the look-ups, each of
// which is a vector of the channels.

namespace twofold {
namespace {

/// n.l, raised to 0, and |l + v|^2 of each light.
struct PairLanes {
    Lanes cosine;
    Lanes square;
};

[[gnu::always_inline]] inline void fill_pairs(PairLanes& out, const LightBlock& block, LightRun run,
                                              const SurfaceView& at) {
    const double* x = block.lights.x.data() + block.first + run.first;
    const double* y = block.lights.y.data() + block.first + run.first;
    const double* z = block.lights.z.data() + block.first + run.first;
    for (std::size_t i = 0; i < run.count; ++i) {
        const double lit = at.n.x * x[i] + at.n.y * y[i] + at.n.z * z[i];
        const double sx = x[i] + at.v.x, sy = y[i] + at.v.y, sz = z[i] + at.v.z;
        out.cosine.at[i] = lit > 0.0 ? lit : 0.0;
        out.square.at[i] = sx * sx + sy * sy + sz * sz;
    }
}

/// Puts the terms of a run in place; value(i) is f of light i. Lights below the horizon keep +0.0.
template <class Value>
[[gnu::always_inline]] inline void put_terms(Terms& terms, const LightBlock& block, LightRun run,
                                             const Lanes& cosine, const Value& value) {
    const std::array<const double*, 3> weight{weights(block, run, 0), weights(block, run, 1),
                                              weights(block, run, 2)};
    for (std::size_t i = 0; i < run.count; ++i) {
        if (cosine.at[i] == 0.0) continue;
        const Rgb f = value(i);
        for (std::size_t c = 0; c < 3; ++c)
            terms[c].at[run.first + i] = f[static_cast<int>(c)] * cosine.at[i] * weight[c][i];
    }
}

[[gnu::always_inline]] inline void fill_run(Terms& terms, const HalfAngleTable& table,
                                            const LightBlock& block, LightRun run,
                                            const SurfaceView& at) {
    PairLanes pairs;
    fill_pairs(pairs, block, run, at);
    const double n_v = dot(at.n, at.v);
    struct {
        Lanes half, difference, azimuth;
    } place;
    for (std::size_t i = 0; i < run.count; ++i) {
        const HalfAngle angles = half_angle(pairs.cosine.at[i], n_v, pairs.square.at[i]);
        place.half.at[i] = angles.half;
        place.difference.at[i] = angles.difference;
        place.azimuth.at[i] = angles.azimuth;
    }
    put_terms(
        terms, block, run, pairs.cosine, [&](std::size_t i) __attribute__((always_inline)) {
            return trilinear(table,
                             {place.half.at[i], place.difference.at[i], place.azimuth.at[i]});
        });
}

[[gnu::always_inline]] inline void fill_run(Terms& terms, const ProductBrdf& brdf,
                                            const LightBlock& block, LightRun run,
                                            const SurfaceView& at) {
    PairLanes pairs;
    fill_pairs(pairs, block, run, at);
    const double n_v = dot(at.n, at.v);
    const Rgba32f view = view_part(brdf, n_v);
    struct {
        Lanes radius, half;
    } place;
    for (std::size_t i = 0; i < run.count; ++i) {
        place.radius.at[i] = paraboloid_radius(pairs.cosine.at[i]);
        place.half.at[i] = half_coordinate(pairs.cosine.at[i], n_v, pairs.square.at[i]);
    }
    put_terms(
        terms, block, run, pairs.cosine, [&](std::size_t i) __attribute__((always_inline)) {
            return product(brdf, view, place.radius.at[i], place.half.at[i]);
        });
}

}  // namespace

Rgb measured_value(const MeasuredModel& model, double n_l, double n_v, double square) {
    if (model.fill == Fill::interpolate)
        return trilinear(model.table, half_angle(n_l, n_v, square));
    return product(model.product, view_part(model.product, n_v), paraboloid_radius(n_l),
                   half_coordinate(n_l, n_v, square));
}

TWOFOLD_SIMD_CLONES
Rgb block_sum(const MeasuredTable& table, LightBlock block, const SurfaceView& at) {
    return sum_of_runs(
        block, [&](Terms & terms, LightRun run) __attribute__((always_inline)) {
            if (table.model.fill == Fill::interpolate)
                fill_run(terms, table.model.table, block, run, at);
            else
                fill_run(terms, table.model.product, block, run, at);
        });
}

}  // namespace twofold
