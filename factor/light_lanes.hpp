#pragma once
#include <array>
#include <cstddef>

#include "factor/light_block.hpp"
#include "texunit/ordered_sum.hpp"

/// What the block kernels of all materials share.
namespace twofold {

/// One value a light.
struct alignas(64) Lanes {
    double at[light_block];
};

/// The terms of a block, a channel each; those of patches left out stay +0.0.
using Terms = std::array<Lanes, 3>;

/// Lights [first, first + count) of a block: patches without a gap between them.
struct LightRun {
    std::size_t first;
    std::size_t count;
};

/// The first run of lit patches that begins at light `from` of the block or later; empty at the
/// end.
inline LightRun next_run(const LightBlock& block, std::size_t from) {
    const auto lit = [&](std::size_t light) {
        return (block.lit >> (light / light_patch) & 1U) != 0;
    };
    std::size_t first = from;
    while (first < block.count && !lit(first)) {
        first += light_patch;
    }
    std::size_t end = first;
    while (end < block.count && lit(end)) {
        end += light_patch;
    }
    first = first < block.count ? first : block.count;
    return {first, (end < block.count ? end : block.count) - first};
}

inline Rgb sum_of(const Terms& terms, std::size_t count) {
    return {ordered_block_sum(terms[0].at, count), ordered_block_sum(terms[1].at, count),
            ordered_block_sum(terms[2].at, count)};
}

/// One row of weights of the lights of a run.
[[gnu::always_inline]] inline const double* weights(const LightBlock& block, LightRun run,
                                                    std::size_t channel) {
    const DistantLights& lights = block.lights;
    const std::array<const double*, 3> rows = {lights.r.data(), lights.g.data(), lights.b.data()};
    return rows[channel] + block.first + run.first;
}

/// Sum of the block's terms, which fill(terms, run) puts in place for each run.
template <class Fill>
[[gnu::always_inline]] inline Rgb sum_of_runs(const LightBlock& block, const Fill& fill) {
    Terms terms{};
    for (LightRun run = next_run(block, 0); run.count != 0;
         run = next_run(block, run.first + run.count)) {
        fill(terms, run);
    }
    return sum_of(terms, block.count);
}

}  // namespace twofold
