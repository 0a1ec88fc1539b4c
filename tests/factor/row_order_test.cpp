#include "factor/row_order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "factor/directions.hpp"
#include "factor/fit_samples.hpp"

using namespace twofold;

namespace {

/// Samples whose radiance is their number.
LightingSamples numbered(int first, int count) {
    LightingSamples samples{surface_views(count, 1, first), {}};
    for (int i = first; i < first + count; ++i) samples.radiance.push_back(Rgb(i, 2 * i, 3 * i));
    return samples;
}

FactorSettings map_of(int size) {
    FactorSettings settings;
    settings.map_size = size;
    settings.view_knots = 5;
    return settings;
}

/// The run of 256 texels of map 2, then that of 128 of map 1.
std::pair<std::uint32_t, std::uint32_t> runs_of(const SampleRows& rows, std::size_t i,
                                                const MapShape& shape) {
    const auto start = static_cast<std::uint32_t>(shape.texels());
    return {(rows.texel[1][i] - start) / 256, rows.texel[0][i] / 128};
}

}  // namespace

TEST_CASE("rows are ordered as a stable sort by their texels' runs orders them") {
    const int size = GENERATE(4, 19, 64);
    for (const MapForm form : {MapForm::dual_paraboloid, MapForm::cube, MapForm::sphere}) {
        const MapShape shape{size, 0.875, form};
        const SampleRows rows = sample_rows(surface_views(5000, 2), shape, 0, 1);
        std::vector<std::uint32_t> expected(3000);
        std::iota(expected.begin(), expected.end(), 0U);
        std::stable_sort(expected.begin(), expected.end(), [&](std::uint32_t a, std::uint32_t b) {
            return runs_of(rows, 700 + a, shape) < runs_of(rows, 700 + b, shape);
        });
        CHECK(order_of_rows(rows, 700, 3000, shape) == expected);
    }
    CHECK(order_of_rows({}, 0, 0, {}).empty());
}

TEST_CASE("the samples of a fit keep their radiance through the order, block by block") {
    const int count = static_cast<int>(ordered_rows) + 3000, cut = 70000;
    const FactorSettings settings = map_of(16);
    FitSamples fit(settings, static_cast<std::size_t>(count));
    fit.add(numbered(0, cut), 1);
    fit.add(numbered(cut, count - cut), 2);
    const FitSamples::Parts parts = std::move(fit).parts();
    const LogRows given = log_rows(numbered(0, count).at, settings);
    std::vector<bool> seen(given.samples, false);
    std::size_t astray = 0;
    for (std::size_t k = 0; k < given.samples; ++k) {
        const auto i = static_cast<std::size_t>(parts.radiance[0][k]);
        const RowEntries row = parts.left.matrix.row(k), expected = given.matrix.row(i);
        const bool same = std::equal(row.begin(), row.end(), expected.begin(), expected.end(),
                                     [](const MatrixEntry& a, const MatrixEntry& b) {
                                         return a.column == b.column && a.value == b.value;
                                     });
        const double value = parts.radiance[0][k];
        if (!same || seen[i] || (i < ordered_rows) != (k < ordered_rows) ||
            parts.radiance[1][k] != 2.0 * value || parts.radiance[2][k] != 3.0 * value)
            ++astray;
        seen[i] = true;
    }
    CHECK(astray == 0);
}
