#include "factor/sample_rows.hpp"

#include <algorithm>
#include <cmath>

#include "factor/view_table.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

constexpr std::size_t pairs_per_task = 4096;

/// A place on the grid of 2^-16: the last whole step before it and the rest.
struct GridPlace {
    std::uint32_t step;
    std::uint16_t fraction;
};

GridPlace on_grid(double fraction) {
    const auto rounded = static_cast<std::uint32_t>(std::floor(fraction * 0x1p16 + 0.5));
    return {rounded >> 16, static_cast<std::uint16_t>(rounded & 0xffffU)};
}

/// Along an edge at which the two texels are one, the fraction says nothing.
GridPlace along(const TexelFootprint& f, std::size_t second) {
    return f.index[second] == f.index[0] ? GridPlace{0, 0}
                                         : on_grid(f.weight[second] + f.weight[3]);
}

void put_footprint(SampleRows& rows, std::size_t i, std::size_t map, Vec3 direction,
                   const MapShape& shape) {
    const TexelFootprint footprint = footprint_of(direction, shape);
    const GridPlace x = along(footprint, 1), y = along(footprint, 2);
    rows.texel[map][i] = static_cast<std::uint32_t>(map * shape.texels()) + footprint.index[0] +
                         x.step + y.step * static_cast<std::uint32_t>(shape.size);
    rows.fraction[2 * map][i] = x.fraction;
    rows.fraction[2 * map + 1][i] = y.fraction;
}

void put_view(SampleRows& rows, std::size_t i, double cosine, int knots) {
    const ViewFootprint footprint = view_footprint(cosine, knots);
    const GridPlace place = on_grid(footprint.weight[1]);
    rows.knot[i] = static_cast<std::uint16_t>(footprint.index[0] + place.step);
    rows.knot_fraction[i] = place.fraction;
}

}  // namespace

void SampleRows::reserve(std::size_t rows, int view_knots) {
    for (auto& texels : texel) texels.reserve(rows);
    for (auto& fractions : fraction) fractions.reserve(rows);
    if (view_knots == 0) return;
    knot.reserve(rows);
    knot_fraction.reserve(rows);
}

void SampleRows::append(std::span<const SurfaceView> at, const MapShape& shape, int view_knots,
                        int threads) {
    const std::size_t first = size(), rows = first + at.size();
    for (auto& texels : texel) texels.resize(rows);
    for (auto& fractions : fraction) fractions.resize(rows);
    knot.resize(view_knots > 0 ? rows : 0);
    knot_fraction.resize(knot.size());
    parallel_for((at.size() + pairs_per_task - 1) / pairs_per_task, threads, [&](std::size_t task) {
        const std::size_t end = std::min((task + 1) * pairs_per_task, at.size());
        for (std::size_t i = task * pairs_per_task; i < end; ++i) {
            put_footprint(*this, first + i, 0, pi_1(at[i]), shape);
            put_footprint(*this, first + i, 1, pi_2(at[i]), shape);
            if (view_knots > 0) put_view(*this, first + i, dot(at[i].n, at[i].v), view_knots);
        }
    });
}

SampleRows sample_rows(std::span<const SurfaceView> at, const MapShape& shape, int view_knots,
                       int threads) {
    SampleRows rows;
    rows.append(at, shape, view_knots, threads);
    return rows;
}

}  // namespace twofold
