#pragma once
#include "texunit/byte_arithmetic.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/nv1x_arithmetic.hpp"
#include "texunit/real_model.hpp"

namespace twofold {

/// The paper's card (GeForce4 MX, NV17/NV18): the public NV1x vertex arithmetic, then bytes in
/// every stage, with a sign inside the texture units: 255 is 1.
struct Nv17 {
    using Vertex = Nv1xArithmetic;
    using Real = double;
    using Channel = int;
    using Pixel = int;
    using Depth = std::uint32_t;
    static constexpr Preset preset = Preset::nv17;
    static constexpr bool is_integer = true;
    static constexpr bool coords_over_w = true;
    static constexpr int texture_units = 2;
    static constexpr int combiner_stages = 2;

    static SnapRule snap() { return {4, 1.0 / 32.0}; }

    /// Red, green and blue pass through a 22-bit float first, alpha does not.
    static Color<int> vertex_color(const Color<nv1x::Word>& c) {
        const auto rgb = [](nv1x::Word x) {
            return nv1x::float_to_byte(nv1x::round_to_22_bits(x));
        };
        return {rgb(c[0]), rgb(c[1]), rgb(c[2]), nv1x::float_to_byte(c[3])};
    }

    /// Weights in 1/256, cut for the first and third vertex; the second takes the rest. Halves
    /// round up. Weights are held to 0..256 together, so that the colour lies between the vertices'
    /// where their w differ in sign, too: chosen, no rule is published.
    static int iterate_color(const InterpolationWeights<double>& w, int c0, int c1, int c2) {
        const auto [n0, n2] = w.equal_w() ? linear_weights(w) : perspective_weights(w);
        return (n0 * c0 + (256 - n0 - n2) * c1 + n2 * c2 + 128) >> 8;
    }

    static Color<int> texel(Rgba8 t) { return {t.r, t.g, t.b, t.a}; }
    static Color<int> texel(const Rgba32f& t) {
        return {constant(static_cast<double>(t[0])), constant(static_cast<double>(t[1])),
                constant(static_cast<double>(t[2])), constant(static_cast<double>(t[3]))};
    }
    static int expand(int v, int bits) { return replicated_byte(v, bits); }
    static int constant(double c) { return rn8(c); }

    /// Along s on both rows, each rounded to 8 bits, then along t; weights of 8 bits, cut.
    static int filter(int t00, int t10, int t01, int t11, double a, double b) {
        const int wa = cut_weight(a, 8), wb = cut_weight(b, 8);
        return flerp(flerp(t00, t10, wa), flerp(t01, t11, wa), wb);
    }
    /// Of the two rounded results, by a fraction of 8 bits.
    static int filter_levels(int fine, int coarse, double fraction) {
        return flerp(fine, coarse, cut_weight(fraction, 8));
    }

    static int one() { return 255; }
    static int modulate(int a, int b) { return mul_rn(a, b); }
    static int scale(int a, int k) { return a * k < 255 ? a * k : 255; }
    static int product(int a, int b) { return rounded_255th(a * b); }
    static int sum_of_products(int a, int b, int c, int d) { return rounded_255th(a * b + c * d); }
    static int dot(const Color<int>& a, const Color<int>& b) {
        return rounded_255th(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    }
    static int lerp(int a, int b, int f) { return rounded_255th(a * f + b * (255 - f)); }
    static int add(int a, int b) { return a + b; }
    static int negate(int e) { return -e; }
    static int invert(int e) { return 255 - clamp_unsigned(e); }
    static int expand_normal(int e) { return 2 * (e > 0 ? e : 0) - 255; }
    static int half_bias(int e) { return (e > 0 ? e : 0) - 128; }
    static int clamp_unsigned(int e) { return clamped(e, 0, 255); }

    /// -1/2 is -128 and a half rounds up: 255 - 128 = 127, half of 255 is 128 (C04).
    static int scale_and_bias(int x, CombinerScale scale, bool bias) {
        const int biased = bias ? x - 128 : x;
        return clamped(scaled(biased, scale), -255, 255);
    }

    /// ADD_SIGNED with scale 4 is done with 2: the combiners have no bias with that scale.
    /// @source EXT_texture_env_combine, notes on TNT to GeForce; that this chip is among them is
    /// inferred
    static int add_signed_scale(int scale) { return scale == 4 ? 2 : scale; }

    /// Colours of a triangle whose 1/w differ in sign are extrapolated and leave the range.
    static int finish(int a) { return clamp_unsigned(a); }
    static int pixel(double constant) { return rn8(constant); }
    static int blend(int s, int f, int d, int g) { return sum_rn(s, f, d, g); }
    static int blend_subtract(int s, int f, int d, int g) { return difference_rn(s, f, d, g); }
    static int quantise(int p, int bits) { return keep_high_bits(p, bits); }
    static int add_dither(int p, int bits, int sixteenths) {
        return dither_byte(p, bits, sixteenths);
    }
    static Depth depth(double z, int bits) { return depth_cut(z, bits); }
    static std::uint8_t to_unorm8(int p) { return static_cast<std::uint8_t>(p); }
    static double to_real(int p) { return p / 255.0; }

  protected:
    static int clamped(int x, int lo, int hi) { return x < lo ? lo : (x > hi ? hi : x); }

    /// floor(2^bits f) for the exact fraction f < 1, which binary64 may have rounded to 1 (T08).
    static int cut_weight(double f, int bits) {
        const int steps = 1 << bits;
        return f < 1.0 ? static_cast<int>(steps * f) : steps - 1;
    }

    static int scaled(int x, CombinerScale scale) {
        switch (scale) {
            case CombinerScale::one:
                break;
            case CombinerScale::two:
                return x * 2;
            case CombinerScale::four:
                return x * 4;
            case CombinerScale::one_half:
                return (x + 1) >> 1;
        }
        return x;
    }

  private:
    struct EndWeights {
        int n0, n2;
    };

    static EndWeights linear_weights(const InterpolationWeights<double>& w) {
        const std::int64_t area = w.edge[0] + w.edge[1] + w.edge[2];
        return {static_cast<int>(256 * w.edge[0] / area), static_cast<int>(256 * w.edge[2] / area)};
    }

    static EndWeights perspective_weights(const InterpolationWeights<double>& w) {
        const double l0 = static_cast<double>(w.edge[0]) * w.inverse_w[0];
        const double l1 = static_cast<double>(w.edge[1]) * w.inverse_w[1];
        const double l2 = static_cast<double>(w.edge[2]) * w.inverse_w[2];
        const double sum = l0 + l1 + l2;
        const int n0 = cut_within(256.0 * l0 / sum, 256);
        return {n0, cut_within(256.0 * l2 / sum, 256 - n0)};
    }
};

static_assert(NumericModel<Nv17>);

}  // namespace twofold
