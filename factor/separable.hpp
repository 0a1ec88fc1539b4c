#pragma once
#include "factor/bilinear_fit.hpp"
#include "factor/factorize.hpp"
#include "factor/system.hpp"

/// The two relatives that are sums of products of the same two maps: `svd` (seed equation 2) and
/// `nd`, normalised decomposition.
namespace twofold {

/// Both sides at the samples of a fit.
struct Sides {
    LogRows log;  ///< counts the samples
    BilinearSide first, second;
    TermShapes shapes;
};

/// Both maps, with the rows of the paper's fit.
Sides sides_of(const LightingSamples& fit, FactorSettings settings, int threads);

/// What the settings' model, svd, slf or nd, makes of the samples.
FactoredLighting fitted_separably(const Sides& sides, const std::vector<Rgb>& radiance,
                                  const JudgedPairs& judged, const FactorSettings& settings,
                                  double white, int threads);

/// `svd`: settings.terms signed products in least squares of the absolute error, over the pairs
/// that exist, with the smoothness and seam rows of the paper's fit. Hardware has no signs: each
/// product becomes up to four of positive maps, u+ v+ and u- v- added, u+ v- and u- v+ subtracted.
/// Where the sum of those that are added exceeds white, all is drawn darker and doubled in the end.
/// `nd`: one positive product without iteration.
/// @param settings map_form, map_size, guard, terms, rounds, smoothness, seam, cap, row_norm,
///        fill_power and scale are used; no g(n.v)
/// @throws Error as factorize() does
FactoredLighting factor_separable(const MaterialSamples& samples, const FactorSettings& settings,
                                  double white, int threads);

/// What normalised decomposition makes of a matrix.
struct NormalisedDecomposition {
    Vector first;   ///< by x: the norm of row x
    Vector second;  ///< by y: the mean over x of M(x, y) / first(x)
};

/// @param values M at the samples, >= 0; means are over the samples that touch x or y, weighted by
///        their footprints, so that rows with missing entries are comparable
/// @source Kautz & McCool, Interactive Rendering with Arbitrary BRDFs using Separable
///         Approximations, 1999
NormalisedDecomposition decompose(const SparseMatrix& first, const SparseMatrix& second,
                                  const Vector& values, RowNorm norm, int threads);

/// The positive maps of signed products, a channel at a time: for each product
/// u+ v+, u- v-, u+ v-, u- v+; black where a part is empty.
std::vector<ChannelProduct> positive_parts(const SignedSum& sum, const TermShapes& shapes);

/// The parts as they are drawn: those that are added before those that are subtracted, so that
/// nothing is clamped at 0 on the way; without those below half a step of 255 everywhere in all
/// channels. The first stays.
std::vector<std::array<ChannelProduct, 3>> drawn_parts(
    std::vector<std::array<ChannelProduct, 3>> parts, double white);

/// Share of the pairs at which clamping to [0, 1] after each pass changes what is displayed by more
/// than half a step of 255.
/// @param doubling passes that double the sum in the end: so much room is there above white
double clamped_share(std::span<const ChannelProduct> terms, std::span<const PairFootprint> pairs,
                     double white, int doubling);

/// The fewest doubling passes, at most 2, that leave next to no pair clamped.
int headroom(const std::vector<std::array<ChannelProduct, 3>>& parts,
             std::span<const PairFootprint> pairs, double white);

}  // namespace twofold
