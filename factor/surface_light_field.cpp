#include "factor/surface_light_field.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "factor/factorize_check.hpp"
#include "factor/separable.hpp"

namespace twofold {

namespace {

SparseMatrix footprints(const SurfaceSamples& samples, std::size_t rows) {
    RowBuilder builder;
    for (const TexelFootprint& at : samples.rows) {
        std::array<MatrixEntry, 4> row;
        for (std::size_t k = 0; k < 4; ++k) row[k] = {at.index[k], at.weight[k]};
        builder.add(row);
    }
    return builder.build(rows);
}

/// scale (x_j - mean of the neighbours) = 0.
SparseMatrix smoothness_rows(const SurfaceRows& rows, double scale) {
    RowBuilder builder;
    for (std::size_t j = 0; scale > 0.0 && j < rows.count(); ++j) {
        if (rows.neighbours[j].empty()) continue;
        std::vector<MatrixEntry> row{{static_cast<std::uint32_t>(j), scale}};
        const double share = scale / static_cast<double>(rows.neighbours[j].size());
        for (const std::uint32_t next : rows.neighbours[j]) row.push_back({next, -share});
        builder.add(row);
    }
    return builder.build(rows.count());
}

std::vector<PairFootprint> pairs_of(const SurfaceSamples& samples, const MapShape& shape) {
    std::vector<PairFootprint> pairs = footprints_of(samples.lighting.at, shape);
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].first = samples.rows[i];
    return pairs;
}

}  // namespace

SurfaceRows chart_rows(int size) {
    const MapShape shape{size, 1.0, MapForm::chart};
    SurfaceRows rows{{}, size};
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        std::vector<std::uint32_t> next;
        for (const auto& [columns, lines] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
            if (const auto texel = beside(texel_at(j, shape), columns, lines, shape))
                next.push_back(texel_index(*texel, shape));
        rows.neighbours.push_back(std::move(next));
    }
    return rows;
}

FactoredLighting factor_surface(const SurfaceField& field, const FactorSettings& settings,
                                double white, int threads) {
    const auto& [rows, fit, held_out] = field;
    check_arguments(fit.lighting, held_out.lighting, settings, white);
    Sides sides = sides_of(fit.lighting, settings, threads);
    const double scale = settings.smoothness * std::sqrt(static_cast<double>(fit.rows.size()) /
                                                         static_cast<double>(rows.count()));
    sides.first = {footprints(fit, rows.count()), smoothness_rows(rows, scale)};
    const bool by_vertex = rows.chart_size == 0;
    sides.shapes = {{by_vertex ? 1 : rows.chart_size, 1.0, MapForm::chart},
                    sides.shapes.second,
                    by_vertex ? rows.count() : 0};
    const SurfaceSamples& judged = held_out.rows.empty() ? fit : held_out;
    return fitted_separably(sides, fit.lighting.radiance,
                            {pairs_of(judged, sides.shapes.second), judged.lighting.radiance},
                            settings, white, threads);
}

}  // namespace twofold
