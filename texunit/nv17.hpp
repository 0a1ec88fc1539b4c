#pragma once
#include "texunit/byte_arithmetic.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/nv1x_arithmetic.hpp"
#include "texunit/real_model.hpp"

namespace twofold {

/// The paper's card (GeForce4 MX, NV17/NV18): the public NV1x vertex arithmetic, then bytes in
/// every stage.
struct Nv17 {
    using Vertex = Nv1xArithmetic;
    using Real = double;
    using Channel = int;
    using Pixel = int;
    using Depth = std::uint32_t;
    static constexpr Preset preset = Preset::nv17;
    static constexpr SnapRule snap{4, 1.0 / 32.0};

    /// Red, green and blue pass through a 22-bit float first, alpha does not.
    static Color<int> vertex_color(const Color<nv1x::Word>& c) {
        const auto rgb = [](nv1x::Word x) {
            return nv1x::float_to_byte(nv1x::round_to_22_bits(x));
        };
        return {rgb(c[0]), rgb(c[1]), rgb(c[2]), nv1x::float_to_byte(c[3])};
    }

    /// Weights in 1/256, cut for the first and third vertex; the second takes the rest. Halves
    /// round up.
    static int iterate_color(const InterpolationWeights<double>& w, int c0, int c1, int c2) {
        const auto [n0, n2] = w.equal_w() ? linear_weights(w) : perspective_weights(w);
        return (n0 * c0 + (256 - n0 - n2) * c1 + n2 * c2 + 128) >> 8;
    }

    static Color<int> texel(Rgba8 t) { return {t.r, t.g, t.b, t.a}; }
    static Color<int> texel(const Rgba32f& t) {
        return {pixel(static_cast<double>(t[0])), pixel(static_cast<double>(t[1])),
                pixel(static_cast<double>(t[2])), pixel(static_cast<double>(t[3]))};
    }

    /// Along s on both rows, each rounded to 8 bits, then along t; weights of 8 bits, cut.
    static int filter(int t00, int t10, int t01, int t11, double a, double b) {
        const int wa = filter_weight(a), wb = filter_weight(b);
        return flerp(flerp(t00, t10, wa), flerp(t01, t11, wa), wb);
    }

    static int modulate(int a, int b) { return mul_rn(a, b); }
    static int scale(int a, int k) { return a * k < 255 ? a * k : 255; }
    static int finish(int a) { return a; }
    static int pixel(double constant) { return rn8(constant); }
    static int blend(int s, int f, int d, int g) { return sum_rn(s, f, d, g); }
    static Depth depth(double z) { return depth_cut(z, 24); }
    static std::uint8_t to_unorm8(int p) { return static_cast<std::uint8_t>(p); }
    static double to_real(int p) { return p / 255.0; }

  private:
    /// floor(256 f) for the exact fraction f < 1, which binary64 may have rounded to 1 (T08).
    static int filter_weight(double f) { return f < 1.0 ? static_cast<int>(256.0 * f) : 255; }

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
        return {static_cast<int>(256.0 * l0 / sum), static_cast<int>(256.0 * l2 / sum)};
    }
};

static_assert(NumericModel<Nv17>);

}  // namespace twofold
