#pragma once
#include <array>
#include <span>
#include <vector>

#include "factor/factor_map.hpp"
#include "factor/samples.hpp"

namespace twofold {

/// How far a product P = t1 t2 is from the lighting function L at a set of pairs, in one channel.
/// P is looked up as the hardware does, filtering the exponentiated texels linearly. Radiance below
/// 0 counts as 0, pairs of non-finite radiance are left out; all figures are 0 for a black channel.
struct FitError {
    double relative_rms = 0.0;  ///< rms(P - L) / rms(L)
    double byte_rms = 0.0;      ///< the same with both maps in 8 bits
    double log_rms = 0.0;       ///< rms of ln(P / L), both raised to 1e-3 of the mean of L
    double median = 0.0;        ///< of |P - L| / L where L is at least that
    double p95 = 0.0;           ///< 95th percentile of the same
};

/// The texels that a pair touches in both maps.
struct PairFootprint {
    TexelFootprint first;   ///< at pi_1
    TexelFootprint second;  ///< at pi_2
};

std::vector<PairFootprint> footprints_of(std::span<const SurfaceView> at, const MapShape& shape);

/// Measures one channel. @param scale maximum of t1 times maximum of t2
/// @param radiance one value a pair
FitError fit_error(const NormalisedChannel& t1, const NormalisedChannel& t2, double scale,
                   std::span<const PairFootprint> pairs, std::span<const double> radiance);

/// One channel of samples. @param channel 0 red, 1 green, 2 blue
std::vector<double> channel_of(std::span<const Rgb> radiance, int channel);

}  // namespace twofold
