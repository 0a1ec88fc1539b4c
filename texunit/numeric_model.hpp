#pragma once
#include <array>
#include <concepts>
#include <cstdint>

#include "texunit/preset.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// Red, green, blue, alpha in a channel type.
template <class Channel>
using Color = std::array<Channel, 4>;

/// Window coordinates are cut toward zero to 1 / 2^fraction_bits pixel after `bias` (pixels) was
/// added to the viewport offset. A bias of half a step rounds to nearest.
struct SnapRule {
    int fraction_bits;
    double bias;
};

/// Linear interpolation inside a triangle at one pixel centre: the weight of vertex k is edge[k]
/// over their sum, with perspective edge[k] inverse_w[k] over theirs.
template <class Real>
struct InterpolationWeights {
    std::array<std::int64_t, 3> edge;  ///< doubled areas in snap units, >= 0
    std::array<Real, 3> inverse_w;

    bool equal_w() const { return inverse_w[0] == inverse_w[1] && inverse_w[1] == inverse_w[2]; }
};

/// What a numeric preset decides: the number format and rounding of each stage. Coverage, the order
/// of tests and texel addressing are common to all presets.
///
/// `Vertex` is the arithmetic of the vertex stage, `Real` iterates coordinates, `Channel` is what
/// the texture units compute with, `Pixel` what the fragment operations and the framebuffer hold.
template <class M>
concept NumericModel = requires(typename M::Vertex::Word word, typename M::Real real,
                                typename M::Channel channel, typename M::Pixel pixel,
                                Color<typename M::Channel> color) {
    { M::preset } -> std::convertible_to<Preset>;
    { M::snap } -> std::convertible_to<SnapRule>;
    { M::vertex_color({word, word, word, word}) } -> std::same_as<Color<typename M::Channel>>;
    {
        M::iterate_color(InterpolationWeights<typename M::Real>{}, channel, channel, channel)
        } -> std::same_as<typename M::Channel>;
    { M::texel(Rgba8{}) } -> std::same_as<Color<typename M::Channel>>;
    { M::texel(Rgba32f{}) } -> std::same_as<Color<typename M::Channel>>;
    {
        M::filter(channel, channel, channel, channel, real, real)
        } -> std::same_as<typename M::Channel>;
    { M::modulate(channel, channel) } -> std::same_as<typename M::Channel>;
    { M::scale(channel, int{}) } -> std::same_as<typename M::Channel>;
    { M::finish(channel) } -> std::same_as<typename M::Pixel>;
    { M::pixel(double{}) } -> std::same_as<typename M::Pixel>;
    { M::blend(pixel, pixel, pixel, pixel) } -> std::same_as<typename M::Pixel>;
    { M::depth(double{}) } -> std::same_as<typename M::Depth>;
    { M::to_unorm8(pixel) } -> std::same_as<std::uint8_t>;
    { M::to_real(pixel) } -> std::same_as<double>;
};

}  // namespace twofold
