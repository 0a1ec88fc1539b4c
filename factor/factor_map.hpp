#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "factor/parametrization.hpp"
#include "texunit/texture.hpp"

/// From logarithms to the texture images of a factor and the constants beside them.
/// @source seed paper, section 4: each map is divided by its maximum, the constant goes into the
/// vertex
///         colour
namespace twofold {

/// One channel of a factor: exp(x) divided by its maximum.
struct NormalisedChannel {
    std::vector<double> texel;  ///< in [0, 1], 2 R^2 of them; all 0 for a black channel
    double log_maximum = 0.0;   ///< logarithm of what was divided by
};

/// Exponentiates and normalises one channel. The maximum is taken over the texels whose alpha is 1,
/// since no pass shows the others; those are lowered to 1 where they exceed it.
/// @param name what an error calls the channel, such as "t1 red"
/// @throws Error naming the texel if a logarithm is not finite
NormalisedChannel normalised(std::span<const double> log_texels, const MapShape& shape,
                             const std::string& name);

/// The channel of a factor that is 0 everywhere.
NormalisedChannel black_channel(const MapShape& shape);

/// What 8 bits leave of a channel, over the texels whose alpha is 1.
struct ByteLoss {
    int levels = 0;           ///< distinct bytes below the largest
    double zero_share = 0.0;  ///< share of texels stored as 0
};

/// A factor as texture images, [0] the front face and [1] the back. Alpha is the binary disc of
/// texel_is_opaque(); colours go on beyond it.
struct FactorMap {
    MapShape shape;
    std::array<Texture, 2> real;   ///< Rgba32f in [0, 1]
    std::array<Texture, 2> bytes;  ///< Rgba8, each rounded once from binary64: floor(255 T + 1/2)
    std::array<ByteLoss, 3> loss;  ///< by channel
};

/// Builds the images of a factor from its three channels.
/// @throws Error naming the texel if a value is not finite
FactorMap make_factor_map(const std::array<NormalisedChannel, 3>& channels, const MapShape& shape,
                          const std::string& name);

/// The loss of one channel in 8 bits.
ByteLoss byte_loss(std::span<const double> texels, const MapShape& shape);

/// floor(255 x + 1/2) in 0..255.
std::uint8_t to_byte(double x);

/// The constant c = max t1 max t2 / white spread over what the hardware has: c = color x
/// combiner_scale x 2^doubling_passes in each channel.
struct ScaleSplit {
    Rgb color{0.0};           ///< vertex colour, in [0, 1]
    int combiner_scale = 1;   ///< k, the smallest of 1, 2, 4 that is not below the largest c, or 4
    int doubling_passes = 0;  ///< ceil(log2(c / 4)) where c exceeds 4
    std::vector<std::string> warnings;
};

/// Splits the constants of the three channels.
/// @throws Error naming the channel if a constant is not finite or negative
ScaleSplit split_scale(Rgb c);

/// "red", "green" or "blue".
const char* channel_name(std::size_t channel);

}  // namespace twofold
