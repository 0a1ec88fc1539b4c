#include "factor/system.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "factor/vector_arithmetic.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

/// The four entries of a footprint, scaled, in the columns of map 1 or 2.
void put_footprint(std::span<MatrixEntry> row, const TexelFootprint& footprint,
                   std::size_t first_column, double scale) {
    for (std::size_t k = 0; k < 4; ++k) {
        row[k] = {static_cast<std::uint32_t>(first_column) + footprint.index[k],
                  scale * footprint.weight[k]};
    }
}

/// scale (x_k-1 - 2 x_k + x_k+1) = 0 for the inner knots of g.
void add_view_rows(RowBuilder& builder, std::size_t first_column, int knots, double scale) {
    for (int k = 1; scale > 0.0 && k + 1 < knots; ++k) {
        const auto column =
            static_cast<std::uint32_t>(first_column) + static_cast<std::uint32_t>(k);
        builder.add(std::array<MatrixEntry, 3>{
            {{column - 1, scale}, {column, -2.0 * scale}, {column + 1, scale}}});
    }
}

constexpr std::array<std::pair<int, int>, 4> steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// scale (x_j - mean of the neighbours) = 0. A paraboloid's are those in the face.
void add_smoothness_row(RowBuilder& builder, std::size_t index, const MapShape& shape,
                        std::size_t first_column, double scale) {
    const auto column = [&](const MapTexel& texel) {
        return static_cast<std::uint32_t>(first_column) + texel_index(texel, shape);
    };
    const MapTexel texel = texel_at(index, shape);
    std::array<MatrixEntry, 5> row;
    std::size_t count = 0;
    row[count++] = {column(texel), scale};
    for (const auto& [columns, rows] : steps)
        if (const auto next = beside(texel, columns, rows, shape))
            row[count++].column = column(*next);
    for (std::size_t k = 1; k < count; ++k) row[k].value = -scale / static_cast<double>(count - 1);
    builder.add(std::span(row).first(count));
}

/// scale (x_j - the other face's value) = 0: of a paraboloid's texel beyond the rim, in its own
/// direction; of a texel at the edge of a cube's face, that of the texel across, since a look-up
/// stays on its face and shows both at the edge.
void add_seam_rows(RowBuilder& builder, std::size_t index, const MapShape& shape,
                   std::size_t first_column, double scale) {
    const MapTexel texel = texel_at(index, shape);
    const auto column = static_cast<std::uint32_t>(first_column + index);
    if (!within_face(texel, shape)) {
        std::array<MatrixEntry, 5> row;
        row[0] = {column, scale};
        put_footprint(std::span(row).last(4), footprint_of(texel_direction(texel, shape), shape),
                      first_column, -scale);
        builder.add(row);
    }
    for (const auto& [columns, rows] : steps)
        if (const auto next = beside(texel, columns, rows, shape); next && next->face != texel.face)
            builder.add(std::array<MatrixEntry, 2>{
                {{column, scale},
                 {static_cast<std::uint32_t>(first_column) + texel_index(*next, shape), -scale}}});
}

template <class AddRow>
void add_rows_of_both_maps(const MapShape& shape, double scale, const AddRow& add_row) {
    if (scale == 0.0) return;
    for (std::size_t map = 0; map < 2; ++map) {
        for (std::size_t j = 0; j < shape.texels(); ++j) add_row(j, map * shape.texels(), scale);
    }
}

}  // namespace

SparseMatrix regulariser_of(const FactorSettings& settings, std::size_t samples) {
    const MapShape shape = shape_of(settings);
    const auto texels = static_cast<double>(shape.texels());
    const auto count = static_cast<double>(samples);
    const double scale = settings.smoothness * std::sqrt(count / texels);
    // The seam rows are scaled from the same k; where there is no smoothness they stand by
    // themselves.
    const double seam_base = settings.smoothness > 0.0 ? scale : std::sqrt(count / texels);
    RowBuilder builder;
    add_rows_of_both_maps(shape, scale, [&](std::size_t j, std::size_t first, double k) {
        add_smoothness_row(builder, j, shape, first, k);
    });
    add_rows_of_both_maps(shape, settings.seam * seam_base,
                          [&](std::size_t j, std::size_t first, double k) {
                              add_seam_rows(builder, j, shape, first, k);
                          });
    const auto knots = static_cast<std::size_t>(settings.view_knots);
    add_view_rows(builder, 2 * shape.texels(), settings.view_knots,
                  settings.view_smoothness * std::sqrt(count / static_cast<double>(knots + 1)));
    return builder.build(2 * shape.texels() + knots);
}

LogRows log_rows(SampleRows at, SparseMatrix regulariser, const FactorSettings& settings) {
    const MapShape shape = shape_of(settings);
    const std::size_t samples = at.size();
    return {LogMatrix(std::move(at), shape, std::move(regulariser)), samples, shape,
            settings.view_knots};
}

LogRows log_rows(std::span<const SurfaceView> at, const FactorSettings& settings, int threads) {
    return log_rows(sample_rows(at, shape_of(settings), settings.view_knots, threads),
                    regulariser_of(settings, at.size()), settings);
}

FactorStarts LogRows::starts() const {
    FactorStarts starts{0, shape.texels(), 2 * shape.texels()};
    if (view_knots > 0) starts.push_back(2 * shape.texels() + static_cast<std::size_t>(view_knots));
    return starts;
}

WeightedSystem::WeightedSystem(const LogRows& left, const ChannelRows& right,
                               const FactorSettings& settings, int threads)
    : WeightedSystem(left, right, Gauge(left.matrix, right.weight, left.starts()), settings,
                     threads) {}

WeightedSystem::WeightedSystem(const LogRows& left, const ChannelRows& right, Gauge gauge,
                               const FactorSettings& settings, int threads)
    : left_(left),
      right_(right),
      threads_(threads),
      gauge_(std::move(gauge)),
      column_scale_(left.matrix.column_norms(right.weight, threads)) {
    const double largest = largest_magnitude(column_scale_);
    magnitude_ = settings.column_scaling ? 1.0 : largest * largest;
    for (double& scale : column_scale_)
        scale = settings.column_scaling && scale > 0.0 ? scale : 1.0;
    if (settings.remove_null_vectors) null_vectors_ = gauge_.null_vectors(column_scale_);
    gradient_ = scaled_product(left.matrix.multiply_transpose(
        [&](std::size_t i) { return right.weight[i] * (right.weight[i] * right.right_side[i]); },
        threads));
}

Vector WeightedSystem::apply(const Vector& y) const {
    Vector product = left_.matrix.multiply(unknowns(y), threads_);
    for (std::size_t i = 0; i < product.size(); ++i) product[i] *= right_.weight[i];
    return product;
}

Vector WeightedSystem::apply_transpose(const Vector& r) const {
    Vector weighted(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) weighted[i] = right_.weight[i] * r[i];
    return scaled_product(left_.matrix.multiply_transpose(weighted, threads_));
}

Vector WeightedSystem::scaled_product(Vector columns) const {
    return without_null_vectors(unknowns(std::move(columns)));
}

Vector WeightedSystem::without_null_vectors(Vector y) const {
    return without(std::move(y), null_vectors_);
}

Vector WeightedSystem::right_side() const {
    Vector weighted(right_.right_side.size());
    for (std::size_t i = 0; i < weighted.size(); ++i) {
        weighted[i] = right_.weight[i] * right_.right_side[i];
    }
    return weighted;
}

Vector WeightedSystem::scaled_unknowns(const Vector& x) const {
    Vector y(x.size());
    for (std::size_t j = 0; j < x.size(); ++j) y[j] = column_scale_[j] * x[j];
    return y;
}

Vector WeightedSystem::unknowns(Vector y) const {
    for (std::size_t j = 0; j < y.size(); ++j) y[j] /= column_scale_[j];
    return y;
}

LeastSquaresProblem WeightedSystem::problem() const {
    return {{[this](const Vector& y) { return apply(y); },
             [this](const Vector& r) { return apply_transpose(r); }},
            right_side(),
            magnitude_};
}

}  // namespace twofold
