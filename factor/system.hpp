#pragma once
#include <cstddef>
#include <span>

#include "factor/gauge.hpp"
#include "factor/log_matrix.hpp"
#include "factor/parametrization.hpp"
#include "factor/samples.hpp"
#include "factor/settings.hpp"
#include "factor/solve.hpp"

/// The linear system of the logarithms, [A1 A2] (log t1; log t2) = log L. The unknowns are the
/// texels of map 1, those of map 2, then the knots of g(n.v) where there is one. The left side
/// depends on the directions alone and serves the three channels; each channel has its own right
/// side and row weights.
/// @source seed paper, equation 7 (its equation 6 prints a product where the logarithm gives a sum)
namespace twofold {

/// The left side. Rows: one a sample (four weights at pi_1, four at pi_2, two at n.v if there are
/// knots), then the smoothness rows of both maps, their seam rows and those of the knots.
struct LogRows {
    LogMatrix matrix;
    std::size_t samples;  ///< S, the number of sample rows
    MapShape shape;
    int view_knots = 0;  ///< of g(n.v)

    FactorStarts starts() const;  ///< of the two maps and the knots
};

/// Builds the left side. With k = smoothness sqrt(S / 2R^2) the row of texel j says k (x_j - mean
/// of its neighbours, 2 to 4 in its face) = 0; with seam k in place of k the row of a texel beyond
/// the rim says that it equals the other face's filtered value in its direction. Second differences
/// of g's knots are 0 with view_smoothness sqrt(S / knots).
/// @param settings map_size, guard, smoothness, seam, view_knots and view_smoothness are used
LogRows log_rows(std::span<const SurfaceView> at, const FactorSettings& settings, int threads = 1);

/// The same of samples that have their place, and of the rows after them.
LogRows log_rows(SampleRows at, SparseMatrix regulariser, const FactorSettings& settings);

/// The rows after those of so many samples.
SparseMatrix regulariser_of(const FactorSettings& settings, std::size_t samples);

/// What became of a channel's samples; each sample is counted once, under the first that applies.
struct TreatedSamples {
    std::size_t used = 0;        ///< all but the non-finite
    std::size_t non_finite = 0;  ///< left out
    std::size_t negative = 0;    ///< raised to the floor
    std::size_t zero = 0;        ///< raised to the floor
    std::size_t floored = 0;     ///< above 0 and raised to the floor
    std::size_t capped = 0;      ///< lowered to the cap
    TreatedSamples& operator+=(const TreatedSamples& b);
};

/// The right side of a channel.
struct ChannelRows {
    Vector right_side;  ///< log of the treated radiance; 0 for left-out samples and other rows
    Vector weight;      ///< row weights; 0 for left-out samples, 1 for the rows after the samples
    TreatedSamples treated;
    double mean = 0.0;  ///< Lmean: of the used samples, negative ones as 0, after the cap
    bool black() const { return mean == 0.0; }  ///< no sample above 0: no logarithm was taken
};

/// Builds the right side log max(min(L, cap white), floor Lmean) and the row weights
/// (the same / Lmean)^row_weight.
/// @param radiance one value a sample; becomes the right side in place
/// @param white radiance of the picture's white; a cap of 0 takes none
/// @throws Error if no sample is finite
ChannelRows channel_rows(const LogRows& rows, Vector radiance, const FactorSettings& settings,
                         double white, int threads = 1);

/// The weighted system of a channel, B = diag(weight) A D^-1 with D_j the norm of column j of the
/// weighted matrix (1 without column scaling and for empty columns), in unknowns D x. What the
/// gauge's null vectors, D (1; -1) and its like, would collect of rounding is projected out of
/// every product with B^T. Refers to the two it is made of.
class WeightedSystem {
  public:
    /// @param settings column_scaling and remove_null_vectors are used
    WeightedSystem(const LogRows& left, const ChannelRows& right, const FactorSettings& settings,
                   int threads);
    /// @param gauge of the rows of positive weight, where it is known
    WeightedSystem(const LogRows& left, const ChannelRows& right, Gauge gauge,
                   const FactorSettings& settings, int threads);

    Vector apply(const Vector& y) const;                  ///< B y
    Vector apply_transpose(const Vector& r) const;        ///< B^T r
    Vector right_side() const;                            ///< diag(weight) b
    const Vector& gradient() const { return gradient_; }  ///< B^T diag(weight) b
    Vector scaled_unknowns(const Vector& x) const;        ///< D x
    Vector unknowns(Vector y) const;                      ///< D^-1 y

    /// D^-1 A^T w of the columns' sums A^T w, without what the null vectors collected.
    Vector scaled_product(Vector columns) const;
    Vector without_null_vectors(Vector y) const;

    const Vector& column_scale() const { return column_scale_; }  ///< D

    const LogRows& left() const { return left_; }
    const ChannelRows& right() const { return right_; }
    const Gauge& gauge() const { return gauge_; }
    double magnitude() const { return magnitude_; }  ///< largest diagonal entry of B^T B

    LeastSquaresProblem problem() const;  ///< min |B y - diag(weight) b|

  private:
    const LogRows& left_;
    const ChannelRows& right_;
    int threads_;
    Gauge gauge_;
    Vector column_scale_;                     ///< D
    std::vector<SparseVector> null_vectors_;  ///< what is projected out
    double magnitude_;
    Vector gradient_;
};

}  // namespace twofold
