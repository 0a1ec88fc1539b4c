#pragma once
#include <array>
#include <span>
#include <vector>

#include "factor/factor_map.hpp"
#include "factor/samples.hpp"
#include "factor/view_table.hpp"

namespace twofold {

/// One channel of a product, each factor divided by what its 1 stands for.
struct ChannelProduct {
    NormalisedChannel t1;
    NormalisedChannel t2;
    std::vector<double> view;  ///< g at its knots, the largest 1; empty: 1 everywhere
    double scale = 0.0;        ///< the radiance that 1 x 1 x 1 stands for
    bool subtract = false;     ///< taken off the sum
};

/// The product of two maps, its scale that of what their 1s stand for.
ChannelProduct product_of(NormalisedChannel t1, NormalisedChannel t2);

/// How far a sum P of products t1 t2 g is from the lighting function L at a set of pairs, in one
/// channel.
/// P is looked up as the hardware does, filtering the exponentiated texels linearly. Radiance below
/// 0 counts as 0, pairs of non-finite radiance are left out; all figures are 0 for a black channel.
struct FitError {
    double relative_rms = 0.0;  ///< rms(P - L) / rms(L)
    double byte_rms = 0.0;      ///< the same with both maps in 8 bits
    double log_rms = 0.0;       ///< rms of ln(P / L), both raised to 1e-3 of the mean of L
    double median = 0.0;        ///< of |P - L| / L where L is at least that
    double p95 = 0.0;           ///< 95th percentile of the same
    double psnr = 0.0;          ///< dB of what is displayed, min(P, white), against min(L, white)
};

/// The texels that a pair touches in both maps.
struct PairFootprint {
    TexelFootprint first;   ///< at pi_1
    TexelFootprint second;  ///< at pi_2
    double cosine = 0.0;    ///< n.v
};

std::vector<PairFootprint> footprints_of(std::span<const SurfaceView> at, const MapShape& shape);

/// Measures one channel of any approximation. @param product, in_bytes, radiance one value a pair
/// @param white > 0, or 0 if all is black
FitError fit_error(std::span<const double> product, std::span<const double> in_bytes,
                   std::span<const double> radiance, double white);

/// Measures one channel of a sum of products.
FitError fit_error(std::span<const ChannelProduct> terms, std::span<const PairFootprint> pairs,
                   std::span<const double> radiance, double white);

/// P at one pair; negative where the product is subtracted.
double product_at(const ChannelProduct& product, const PairFootprint& at);

/// The values that bytes of these store.
std::vector<double> byte_values(std::span<const double> texels);

/// One channel of samples. @param channel 0 red, 1 green, 2 blue
std::vector<double> channel_of(std::span<const Rgb> radiance, int channel);

}  // namespace twofold
