#pragma once
#include "texunit/real_model.hpp"

namespace twofold {

/// What the text of OpenGL 1.3 alone implies: bytes wherever it says that values are rounded to the
/// number of stored bits (vertex colours, texels, framebuffer), real arithmetic between.
struct Gl13 : RealModel<double> {
    using Pixel = int;
    using Depth = std::uint32_t;
    static constexpr Preset preset = Preset::gl13;

    static SnapRule snap() { return {8, 1.0 / 512.0}; }

    static Color<double> vertex_color(const Color<double>& c) {
        return {rn8(c[0]) / 255.0, rn8(c[1]) / 255.0, rn8(c[2]) / 255.0, rn8(c[3]) / 255.0};
    }

    static Color<double> texel(Rgba8 t) { return RealModel<double>::texel(t); }

    /// A float image is rounded to the stored bits when it is uploaded. @source OpenGL 1.3, 3.8.1
    static Color<double> texel(const Rgba32f& t) {
        const auto c = RealModel<double>::texel(t);
        return {rn8(c[0]) / 255.0, rn8(c[1]) / 255.0, rn8(c[2]) / 255.0, rn8(c[3]) / 255.0};
    }

    static int finish(double a) { return rn8(a); }
    static int pixel(double constant) { return rn8(constant); }
    static int blend(int s, int f, int d, int g) { return sum_rn(s, f, d, g); }
    static int blend_subtract(int s, int f, int d, int g) { return difference_rn(s, f, d, g); }
    static int quantise(int p, int bits) { return keep_high_bits(p, bits); }
    static int add_dither(int p, int bits, int sixteenths) {
        return dither_byte(p, bits, sixteenths);
    }
    static Depth depth(double z, int bits) { return depth_rounded(z, bits); }
    static std::uint8_t to_unorm8(int p) { return static_cast<std::uint8_t>(p); }
    static double to_real(int p) { return p / 255.0; }
};

static_assert(NumericModel<Gl13>);

}  // namespace twofold
