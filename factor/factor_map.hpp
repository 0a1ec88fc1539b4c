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
    std::vector<double> texel;   ///< in [0, 1], one a texel; all 0 for a black channel
    double log_maximum = 0.0;    ///< logarithm of what was divided by
    double clipped_share = 0.0;  ///< share of the texels with alpha 1 that were lowered to 1
};

/// Exponentiates and normalises one channel. The maximum is taken over the texels whose alpha is 1,
/// since no pass shows the others; those are lowered to 1 where they exceed it.
/// @param name what an error calls the channel, such as "t1 red"
/// @throws Error naming the texel if a logarithm is not finite
NormalisedChannel normalised(std::span<const double> log_texels, const MapShape& shape,
                             const std::string& name);

/// The same for values themselves, >= 0: divided by the largest of alpha 1; black if that is 0.
NormalisedChannel normalised_values(std::vector<double> texels, const MapShape& shape);

/// The value that a channel's 1 stands for; 0 for a black channel.
double maximum_of(const NormalisedChannel& channel);

/// The same with `limit` of its values as the new 1, which takes what is above down to it.
NormalisedChannel limited(const NormalisedChannel& channel, const MapShape& shape, double limit);

/// The value that `percent` of a hundred of the texels with alpha 1 do not exceed.
double percentile(const NormalisedChannel& channel, const MapShape& shape, double percent);

/// A channel whose texels are all 1.
NormalisedChannel white_channel(const MapShape& shape);

/// The channel of a factor that is 0 everywhere.
NormalisedChannel black_channel(const MapShape& shape);

/// What 8 bits leave of a channel, over the texels whose alpha is 1.
struct ByteLoss {
    int levels = 0;              ///< distinct bytes below the largest
    double zero_share = 0.0;     ///< share of texels stored as 0
    double clipped_share = 0.0;  ///< share of texels that were lowered to the largest
};

/// A factor as textures: [0] the front paraboloid and [1] the back, or one cube or sphere map.
/// Alpha is that of is_opaque(); colours go on beyond it.
struct FactorMap {
    MapShape shape;
    std::vector<Texture> real;     ///< Rgba32f in [0, 1]
    std::vector<Texture> bytes;    ///< Rgba8, each rounded once from binary64: floor(255 T + 1/2)
    std::array<ByteLoss, 3> loss;  ///< by channel
};

/// Builds the images of a factor from its three channels.
/// @throws Error naming the texel if a value is not finite
FactorMap make_factor_map(const std::array<NormalisedChannel, 3>& channels, const MapShape& shape,
                          const std::string& name);

/// The faces of the images one by one: those of a cube map are parted.
std::vector<Texture> faces_of(const std::vector<Texture>& images);

/// The loss of one channel in 8 bits.
ByteLoss byte_loss(std::span<const double> texels, const MapShape& shape);

/// floor(255 x + 1/2) in 0..255.
std::uint8_t to_byte(double x);

/// "front" and "back", or "px", "nx", "py", "ny", "pz", "nz"; of other forms that of the form.
const char* face_name(std::size_t face, MapForm form);

/// "red", "green" or "blue".
const char* channel_name(std::size_t channel);

}  // namespace twofold
