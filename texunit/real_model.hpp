#pragma once
#include "texunit/byte_arithmetic.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/vertex_arithmetic.hpp"

namespace twofold {

/// The formulas of OpenGL 1.3 and NV_register_combiners in one IEEE format, one rounding an
/// operation. ideal64 and float32 are this model in their format; gl13 takes its texture units from
/// it.
template <class Float>
struct RealModel {
    using Vertex = IeeeArithmetic<Float>;
    using Real = Float;
    using Channel = Float;
    using Pixel = Float;
    static constexpr bool is_integer = false;
    static constexpr bool coords_over_w = true;
    static constexpr int texture_units = 4;
    static constexpr int combiner_stages = 8;

    /// x limited to [0, 1]; NaN gives 0.
    static Float clamp01(Float x) {
        return x > Float{0} ? (x < Float{1} ? x : Float{1}) : Float{0};
    }

    static Color<Float> vertex_color(const Color<Float>& c) {
        return {clamp01(c[0]), clamp01(c[1]), clamp01(c[2]), clamp01(c[3])};
    }

    /// Written as an offset from the first vertex, so that a constant colour stays exact.
    static Float iterate_color(const InterpolationWeights<Float>& w, Float c0, Float c1, Float c2) {
        const Float l0 = static_cast<Float>(w.edge[0]) * w.inverse_w[0];
        const Float l1 = static_cast<Float>(w.edge[1]) * w.inverse_w[1];
        const Float l2 = static_cast<Float>(w.edge[2]) * w.inverse_w[2];
        return c0 + (l1 * (c1 - c0) + l2 * (c2 - c0)) / (l0 + l1 + l2);
    }

    static Color<Float> texel(Rgba8 t) {
        return {expand(t.r, 8), expand(t.g, 8), expand(t.b, 8), expand(t.a, 8)};
    }
    static Color<Float> texel(const Rgba32f& t) {
        return {static_cast<Float>(t[0]), static_cast<Float>(t[1]), static_cast<Float>(t[2]),
                static_cast<Float>(t[3])};
    }

    /// k / (2^n - 1). @source OpenGL 1.3, 2.13.9
    static Float expand(int v, int bits) {
        return static_cast<Float>(v) / static_cast<Float>((1 << bits) - 1);
    }
    static Float constant(double c) { return clamp01(static_cast<Float>(c)); }

    /// Along s on both rows, then along t. `a`, `b` are the fractions of texel (i1, j1).
    /// @source OpenGL 1.3, equation 3.20
    static Float filter(Float t00, Float t10, Float t01, Float t11, Float a, Float b) {
        const Float row0 = (Float{1} - a) * t00 + a * t10;
        const Float row1 = (Float{1} - a) * t01 + a * t11;
        return (Float{1} - b) * row0 + b * row1;
    }
    /// @source OpenGL 1.3, 3.8.8
    static Float filter_levels(Float fine, Float coarse, Float fraction) {
        return (Float{1} - fraction) * fine + fraction * coarse;
    }

    static Float one() { return Float{1}; }
    static Float modulate(Float a, Float b) { return a * b; }
    static Float scale(Float a, int k) { return clamp01(a * static_cast<Float>(k)); }
    static Float product(Float a, Float b) { return a * b; }
    static Float sum_of_products(Float a, Float b, Float c, Float d) { return a * b + c * d; }
    static Float dot(const Color<Float>& a, const Color<Float>& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
    static Float lerp(Float a, Float b, Float f) { return a * f + b * (Float{1} - f); }
    static Float add(Float a, Float b) { return a + b; }
    static Float negate(Float e) { return -e; }
    static Float invert(Float e) { return Float{1} - clamp01(e); }
    static Float expand_normal(Float e) { return Float{2} * at_least_0(e) - Float{1}; }
    static Float half_bias(Float e) { return at_least_0(e) - Float{0.5}; }
    static Float clamp_unsigned(Float e) { return clamp01(e); }

    static Float scale_and_bias(Float x, CombinerScale scale, bool bias) {
        const Float scaled = (bias ? x - Float{0.5} : x) * factor_of(scale);
        return scaled > Float{-1} ? (scaled < Float{1} ? scaled : Float{1}) : Float{-1};
    }
    static int add_signed_scale(int scale) { return scale; }

    static Float finish(Float a) { return clamp01(a); }
    static Float pixel(double constant) { return clamp01(static_cast<Float>(constant)); }

    /// s f + d g, limited to [0, 1]. @source OpenGL 1.3, 4.1.7
    static Float blend(Float s, Float f, Float d, Float g) { return clamp01(s * f + d * g); }
    static Float blend_subtract(Float s, Float f, Float d, Float g) {
        return clamp01(s * f - d * g);
    }

    /// A float framebuffer keeps every bit, whatever format the scene names.
    static Float quantise(Float p, int) { return p; }
    static Float add_dither(Float p, int, int) { return p; }

    static std::uint8_t to_unorm8(Float p) {
        return static_cast<std::uint8_t>(rn8(static_cast<double>(p)));
    }
    static double to_real(Float p) { return static_cast<double>(p); }

  private:
    static Float at_least_0(Float e) { return e > Float{0} ? e : Float{0}; }

    static Float factor_of(CombinerScale scale) {
        constexpr std::array<Float, 4> factors{Float{1}, Float{2}, Float{4}, Float{0.5}};
        return factors[static_cast<std::size_t>(scale)];
    }
};

/// Depth z of [0, 1] as an integer of `bits` bits, rounded to nearest.
constexpr std::uint32_t depth_rounded(double z, int bits) {
    const double steps = static_cast<double>((std::uint64_t{1} << bits) - 1);
    if (!(z > 0.0)) return 0;
    return static_cast<std::uint32_t>(z < 1.0 ? z * steps + 0.5 : steps);
}

/// The same, cut: only z = 1 gives the largest value.
constexpr std::uint32_t depth_cut(double z, int bits) {
    const double steps = static_cast<double>((std::uint64_t{1} << bits) - 1);
    if (!(z > 0.0)) return 0;
    return static_cast<std::uint32_t>(z < 1.0 ? z * steps : steps);
}

}  // namespace twofold
