#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "factor/fit_error.hpp"
#include "factor/settings.hpp"

/// Where the constant of a product goes: into the two maps, the vertex colour, the combiner's scale
/// and doubling passes. @source seed paper, section 4, which knows the vertex colour alone
namespace twofold {

/// A constant spread over what the hardware has: c = color x combiner_scale x 2^doubling_passes in
/// each channel.
struct ScaleSplit {
    Rgb color{0.0};           ///< vertex colour, in [0, 1]
    int combiner_scale = 1;   ///< k, the smallest of 1, 2, 4 that is not below c, or the largest
    int doubling_passes = 0;  ///< ceil(log2(c / k)) where c exceeds k
    std::vector<std::string> warnings;
};

/// Splits the constants of the three channels.
/// @param largest_scale that a combiner may apply: 1, 2 or 4
/// @throws Error naming the channel if a constant is not finite or negative
ScaleSplit split_scale(Rgb c, int largest_scale = 4);

/// The same constant where `doubling_passes` passes double whatever is drawn, which may be more
/// than this constant alone needs.
ScaleSplit with_doubling(ScaleSplit split, int doubling_passes);

/// A product whose maps are in the units of their textures, and the constant beside them.
struct ScaledProduct {
    std::array<ChannelProduct, 3> channels;
    Rgb c{0.0};  ///< max t1 max t2 max g / white, before anything was clipped
    ScaleSplit split;
};

/// Chooses the units of both maps by settings.scale: `maximum` divides each by its largest texel;
/// `percentile` by the percentile settings.scale_percentile, clipping what is above; `best_split`
/// searches the units of t1 in steps of 2^(1/4) and the scales 1, 2, 4 up to
/// settings.combiner_scale (and one doubling pass where c exceeds that and it pays) for the least
/// rms difference that bytes and clipping make of the displayed product.
/// @param channels maps divided by their maxima
/// @param pairs what the search looks at
ScaledProduct scaled_product(const std::array<ChannelProduct, 3>& channels,
                             const FactorSettings& settings, double white,
                             std::span<const PairFootprint> pairs);

}  // namespace twofold
