#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "factor/parametrization.hpp"
#include "factor/samples.hpp"

/// The sample rows of the logarithms' system as the solvers read them: places in the maps, from
/// which the weights follow. Fractions are rounded to 2^-16 of a texel (the card itself has 2^-8),
/// so that the four weights of a footprint are exact in binary64 and their sum is exactly 1.
namespace twofold {

/// Where the samples lie, 16 bytes each in place of eight stored entries. A footprint is the texels
/// k, k + 1, k + R and k + R + 1; those past the edge of a face have weight 0.
struct SampleRows {
    std::array<std::vector<std::uint32_t>, 2> texel;     ///< k in map 1 and 2, an unknown
    std::array<std::vector<std::uint16_t>, 4> fraction;  ///< x, y in map 1, x, y in map 2; 2^-16
    std::vector<std::uint16_t> knot;           ///< the last knot before n.v; none without knots
    std::vector<std::uint16_t> knot_fraction;  ///< 2^-16 of the way to the next

    std::size_t size() const { return texel[0].size(); }
    void reserve(std::size_t rows, int view_knots);

    /// The rows of more pairs. @param view_knots 0 for no third factor
    void append(std::span<const SurfaceView> at, const MapShape& shape, int view_knots,
                int threads);
};

/// The rows of the pairs. @param view_knots 0 for no third factor
SampleRows sample_rows(std::span<const SurfaceView> at, const MapShape& shape, int view_knots,
                       int threads);

/// The weights of a footprint's four texels, from its fractions.
[[gnu::always_inline]] inline std::array<double, 4> corner_weights(std::uint16_t x,
                                                                   std::uint16_t y) {
    const double u = x * 0x1p-16, v = y * 0x1p-16;
    return {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
}

/// Rows whose weights are formed at a time.
inline constexpr std::size_t row_run = 64;

/// The weights of a run of rows, an array for each entry.
struct alignas(64) RunWeights {
    double first[4][row_run], second[4][row_run], view[2][row_run];
};

/// What a loop over sample rows needs of them, and one row's part in A x and A^T y. A value is a
/// double, or a ChannelLanes. Loops may touch R + 1 values past the last unknown, with weight 0:
/// vectors of unknowns are that much longer.
class RowReader {
  public:
    RowReader(const SampleRows& rows, const MapShape& shape)
        : texel_{rows.texel[0].data(), rows.texel[1].data()},
          fraction_{rows.fraction[0].data(), rows.fraction[1].data(), rows.fraction[2].data(),
                    rows.fraction[3].data()},
          knot_(rows.knot.empty() ? nullptr : rows.knot.data()),
          knot_fraction_(rows.knot_fraction.data()),
          stride_(static_cast<std::size_t>(shape.size)),
          view_start_(2 * shape.texels()) {}

    /// The weights of the rows [first, first + count), count <= row_run.
    [[gnu::always_inline]] void weights(RunWeights& w, std::size_t first, std::size_t count) const {
        put_corners(w.first, fraction_[0] + first, fraction_[1] + first, count);
        put_corners(w.second, fraction_[2] + first, fraction_[3] + first, count);
        if (knot_ == nullptr) return;
        for (std::size_t k = 0; k < count; ++k) {
            w.view[1][k] = knot_fraction_[first + k] * 0x1p-16;
            w.view[0][k] = 1.0 - w.view[1][k];
        }
    }

    /// Row i, number k of its run, times x: each factor's entries left to right, then factor by
    /// factor.
    template <class Value>
    [[gnu::always_inline]] Value times(std::size_t i, const RunWeights& w, std::size_t k,
                                       const Value* x) const {
        const Value maps =
            corners(x + texel_[0][i], w.first, k) + corners(x + texel_[1][i], w.second, k);
        if (knot_ == nullptr) return maps;
        const Value* knot = x + view_start_ + knot_[i];
        return maps + (w.view[0][k] * knot[0] + w.view[1][k] * knot[1]);
    }

    /// Adds the row times y to the sums of the columns.
    template <class Value>
    [[gnu::always_inline]] void add(std::size_t i, const RunWeights& w, std::size_t k,
                                    const Value& y, Value* sums) const {
        add_corners(sums + texel_[0][i], w.first, k, y);
        add_corners(sums + texel_[1][i], w.second, k, y);
        if (knot_ == nullptr) return;
        Value* knot = sums + view_start_ + knot_[i];
        knot[0] += w.view[0][k] * y;
        knot[1] += w.view[1][k] * y;
    }

  private:
    using Corners = double[4][row_run];

    [[gnu::always_inline]] static void put_corners(Corners& w, const std::uint16_t* x,
                                                   const std::uint16_t* y, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::array<double, 4> weights = corner_weights(x[k], y[k]);
            for (std::size_t j = 0; j < 4; ++j) w[j][k] = weights[j];
        }
    }
    template <class Value>
    [[gnu::always_inline]] Value corners(const Value* x, const Corners& w, std::size_t k) const {
        return w[0][k] * x[0] + w[1][k] * x[1] + w[2][k] * x[stride_] + w[3][k] * x[stride_ + 1];
    }
    template <class Value>
    [[gnu::always_inline]] void add_corners(Value* sums, const Corners& w, std::size_t k,
                                            const Value& y) const {
        sums[0] += w[0][k] * y;
        sums[1] += w[1][k] * y;
        sums[stride_] += w[2][k] * y;
        sums[stride_ + 1] += w[3][k] * y;
    }

    std::array<const std::uint32_t*, 2> texel_;
    std::array<const std::uint16_t*, 4> fraction_;
    const std::uint16_t* knot_;  ///< null without knots
    const std::uint16_t* knot_fraction_;
    std::size_t stride_;  ///< R
    std::size_t view_start_;
};

/// Calls row(i, weights, k) for the rows [first, end), k being the row's number in its run.
template <class Row>
[[gnu::always_inline]] inline void for_rows(const RowReader& read, std::size_t first,
                                            std::size_t end, const Row& row) {
    RunWeights weights;
    for (std::size_t start = first; start < end; start += row_run) {
        const std::size_t count = end - start < row_run ? end - start : row_run;
        read.weights(weights, start, count);
        for (std::size_t k = 0; k < count; ++k) row(start + k, weights, k);
    }
}

}  // namespace twofold
