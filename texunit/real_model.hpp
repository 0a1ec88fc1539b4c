#pragma once
#include "texunit/byte_arithmetic.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/vertex_arithmetic.hpp"

namespace twofold {

/// The formulas of OpenGL 1.3 in one IEEE format, one rounding an operation. ideal64 and float32
/// are this model in their format; gl13 takes its texture units from it.
template <class Float>
struct RealModel {
    using Vertex = IeeeArithmetic<Float>;
    using Real = Float;
    using Channel = Float;
    using Pixel = Float;

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
        constexpr Float one{255};
        return {Float{static_cast<Float>(t.r)} / one, static_cast<Float>(t.g) / one,
                static_cast<Float>(t.b) / one, static_cast<Float>(t.a) / one};
    }
    static Color<Float> texel(const Rgba32f& t) {
        return {static_cast<Float>(t[0]), static_cast<Float>(t[1]), static_cast<Float>(t[2]),
                static_cast<Float>(t[3])};
    }

    /// Along s on both rows, then along t. `a`, `b` are the fractions of texel (i1, j1).
    /// @source OpenGL 1.3, equation 3.20
    static Float filter(Float t00, Float t10, Float t01, Float t11, Float a, Float b) {
        const Float row0 = (Float{1} - a) * t00 + a * t10;
        const Float row1 = (Float{1} - a) * t01 + a * t11;
        return (Float{1} - b) * row0 + b * row1;
    }

    static Float modulate(Float a, Float b) { return a * b; }
    static Float scale(Float a, int k) { return clamp01(a * static_cast<Float>(k)); }
    static Float finish(Float a) { return clamp01(a); }
    static Float pixel(double constant) { return clamp01(static_cast<Float>(constant)); }

    /// s f + d g, limited to [0, 1]. @source OpenGL 1.3, 4.1.7
    static Float blend(Float s, Float f, Float d, Float g) { return clamp01(s * f + d * g); }

    static std::uint8_t to_unorm8(Float p) {
        return static_cast<std::uint8_t>(rn8(static_cast<double>(p)));
    }
    static double to_real(Float p) { return static_cast<double>(p); }
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
