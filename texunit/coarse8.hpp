#pragma once
#include "texunit/nv17.hpp"

namespace twofold {

/// The lower bracket: how bad could 8 bits be. Everything is cut instead of rounded, white does not
/// leave a colour alone, and no register holds a negative number. Chosen throughout; no chip is
/// meant.
struct Coarse8 : Nv17 {
    using Vertex = IeeeArithmetic<float>;
    static constexpr Preset preset = Preset::coarse8;

    static SnapRule snap() { return {4, 0.0}; }

    static Color<int> vertex_color(const Color<float>& c) {
        const auto byte = [](float x) { return floor8(static_cast<double>(x)); };
        return {byte(c[0]), byte(c[1]), byte(c[2]), byte(c[3])};
    }

    /// Binary64, then cut, within 0..255. An offset from the first vertex, so that a constant
    /// colour stays exact.
    static int iterate_color(const InterpolationWeights<double>& w, int c0, int c1, int c2) {
        const double l0 = static_cast<double>(w.edge[0]) * w.inverse_w[0];
        const double l1 = static_cast<double>(w.edge[1]) * w.inverse_w[1];
        const double l2 = static_cast<double>(w.edge[2]) * w.inverse_w[2];
        return cut_within(c0 + (l1 * (c1 - c0) + l2 * (c2 - c0)) / (l0 + l1 + l2), 255);
    }

    static int expand(int v, int bits) { return v << (8 - bits); }

    /// Four weights at once, their sum 256; weights of 4 bits, which is u and v cut to 1/16 texel.
    static int filter(int t00, int t10, int t01, int t11, double a, double b) {
        const int wa = cut_weight(a, 4), wb = cut_weight(b, 4);
        return ((16 - wb) * ((16 - wa) * t00 + wa * t10) + wb * ((16 - wa) * t01 + wa * t11)) >> 8;
    }
    /// No filter between levels: the finer one.
    static int filter_levels(int fine, int, double) { return fine; }

    static int modulate(int a, int b) { return a * b >> 8; }
    static int product(int a, int b) { return a * b >> 8; }
    static int sum_of_products(int a, int b, int c, int d) { return product(a, b) + product(c, d); }
    static int dot(const Color<int>& a, const Color<int>& b) {
        return product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2]);
    }
    static int lerp(int a, int b, int f) { return sum_of_products(a, f, b, 255 - f); }

    static int scale_and_bias(int x, CombinerScale scale, bool bias) {
        const int biased = bias ? x - 128 : x;
        return clamp_unsigned(scale == CombinerScale::one_half ? biased >> 1
                                                               : scaled(biased, scale));
    }
    static int add_signed_scale(int scale) { return scale; }

    static int pixel(double constant) { return floor8(constant); }
    static int blend(int s, int f, int d, int g) {
        return clamp_unsigned(s * f / 255 + d * g / 255);
    }
    static int blend_subtract(int s, int f, int d, int g) {
        return clamp_unsigned(s * f / 255 - d * g / 255);
    }
    /// 16 bits whatever the buffer could hold.
    static Depth depth(double z, int) { return depth_cut(z, 16); }
};

static_assert(NumericModel<Coarse8>);

}  // namespace twofold
