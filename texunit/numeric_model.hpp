#pragma once
#include <array>
#include <concepts>
#include <cstdint>

#include "texunit/combiner_state.hpp"
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

/// What a preset decides before a fragment exists, and its limits. Models are used through an
/// instance, because `custom` holds settings that are known only at run time.
template <class M>
concept VertexRules = requires(const M& m, typename M::Vertex::Word word,
                               InterpolationWeights<typename M::Real> weights,
                               typename M::Channel e) {
    { M::preset } -> std::convertible_to<Preset>;
    { M::is_integer } -> std::convertible_to<bool>;      // the units compute in integers
    { M::coords_over_w } -> std::convertible_to<bool>;   // coordinates leave the vertex times 1/w
    { M::texture_units } -> std::convertible_to<int>;    // at most max_units
    { M::combiner_stages } -> std::convertible_to<int>;  // general ones
    { m.snap() } -> std::same_as<SnapRule>;
    { m.vertex_color({word, word, word, word}) } -> std::same_as<Color<typename M::Channel>>;
    { m.iterate_color(weights, e, e, e) } -> std::same_as<typename M::Channel>;
};

/// What reaches the texture units. `Channel` is signed: [-1, 1] between stages, more inside one.
template <class M>
concept TexelRules = requires(const M& m, typename M::Real real, typename M::Channel e) {
    { m.texel(Rgba8{}) } -> std::same_as<Color<typename M::Channel>>;
    { m.texel(Rgba32f{}) } -> std::same_as<Color<typename M::Channel>>;
    {
        m.expand(int{}, int{})
        } -> std::same_as<typename M::Channel>;                     // (v, bits): a stored component
    { m.constant(double{}) } -> std::same_as<typename M::Channel>;  // of a constant colour
    { m.filter(e, e, e, e, real, real) } -> std::same_as<typename M::Channel>;
    {
        m.filter_levels(e, e, real)
        } -> std::same_as<typename M::Channel>;  // (fine, coarse, fraction)
};

/// What the texture units compute with; combiner.hpp and tex_env.hpp are written in these terms.
/// Only the operations named so clamp: sums of products and add() reach beyond [-1, 1] until
/// scale_and_bias().
template <class M>
concept UnitArithmetic = requires(const M& m, typename M::Channel e,
                                  Color<typename M::Channel> color) {
    { m.one() } -> std::same_as<typename M::Channel>;
    { m.modulate(e, e) } -> std::same_as<typename M::Channel>;               // of [0, 1]
    { m.scale(e, int{}) } -> std::same_as<typename M::Channel>;              // of [0, 1], clamped
    { m.product(e, e) } -> std::same_as<typename M::Channel>;                // signed
    { m.sum_of_products(e, e, e, e) } -> std::same_as<typename M::Channel>;  // a b + c d
    { m.dot(color, color) } -> std::same_as<typename M::Channel>;            // of r, g, b
    { m.lerp(e, e, e) } -> std::same_as<typename M::Channel>;                // a f + b (1 - f)
    { m.add(e, e) } -> std::same_as<typename M::Channel>;
    { m.negate(e) } -> std::same_as<typename M::Channel>;
    { m.invert(e) } -> std::same_as<typename M::Channel>;         // 1 - e clamped to [0, 1]
    { m.expand_normal(e) } -> std::same_as<typename M::Channel>;  // 2 max(0, e) - 1
    { m.half_bias(e) } -> std::same_as<typename M::Channel>;      // max(0, e) - 1/2
    { m.clamp_unsigned(e) } -> std::same_as<typename M::Channel>;
    // ((x - 1/2 if bias) times scale) clamped to [-1, 1]
    { m.scale_and_bias(e, CombinerScale{}, bool{}) } -> std::same_as<typename M::Channel>;
    { m.add_signed_scale(int{}) } -> std::same_as<int>;  // the scale that ADD_SIGNED really gets
};

/// What the fragment operations and the framebuffer hold.
template <class M>
concept PixelRules = requires(const M& m, typename M::Channel e, typename M::Pixel p) {
    { m.finish(e) } -> std::same_as<typename M::Pixel>;
    { m.pixel(double{}) } -> std::same_as<typename M::Pixel>;
    { m.blend(p, p, p, p) } -> std::same_as<typename M::Pixel>;           // s f + d g
    { m.blend_subtract(p, p, p, p) } -> std::same_as<typename M::Pixel>;  // s f - d g
    { m.quantise(p, int{}) } -> std::same_as<typename M::Pixel>;  // keeps that many bits of 8
    // (p, bits, n): n / 16 of a step of that many bits more
    { m.add_dither(p, int{}, int{}) } -> std::same_as<typename M::Pixel>;
    { m.depth(double{}, int{}) } -> std::same_as<typename M::Depth>;  // (z, bits of the buffer)
    { m.to_unorm8(p) } -> std::same_as<std::uint8_t>;
    { m.to_real(p) } -> std::same_as<double>;
};

/// What a numeric preset decides: the number format and rounding of each stage. Coverage, the order
/// of tests and texel addressing are common to all presets.
///
/// `Vertex` is the arithmetic of the vertex stage, `Real` iterates coordinates, `Channel` is what
/// the texture units compute with, `Pixel` what the fragment operations and the framebuffer hold.
template <class M>
concept NumericModel = VertexRules<M> && TexelRules<M> && UnitArithmetic<M> && PixelRules<M>;

/// A constant colour of the state as the texture units hold it, each component clamped to [0, 1].
template <NumericModel M>
Color<typename M::Channel> constant_color(const M& m, const Vec4& c) {
    return {m.constant(c.x), m.constant(c.y), m.constant(c.z), m.constant(c.w)};
}

}  // namespace twofold
