#pragma once
#include <array>

#include "texunit/nv17.hpp"

namespace twofold {

enum class FilterRounding {
    half_up,  ///< after each of the two steps, as nv17
    floor,    ///< cut after each of the two steps
    once      ///< the four weights at once, then half up
};

/// Of products and sums of products inside the texture units.
enum class ProductRounding {
    nearest,  ///< round(a b / 255), halves away from 0, as nv17
    floor,    ///< floor(a b / 255)
    shift     ///< a b >> 8: white is no identity
};

enum class VertexColorRounding {
    nv17,     ///< r, g, b through 22 bits, then 13 fraction bits, halves up
    nv2x,     ///< 13 fraction bits, halves up
    nearest,  ///< floor(255 x + 1/2)
    floor,    ///< floor(255 x)
    real      ///< no byte: rounded once, to the registers' width
};

/// What the preset `custom` takes at run time, so that a study can vary one stage alone. The
/// initial values are nv17's; each changes its stage and no other.
struct CustomSettings {
    int filter_weight_bits = 8;  ///< 1 to 16; between texels and between levels
    FilterRounding filter_rounding = FilterRounding::half_up;
    ProductRounding product_rounding = ProductRounding::nearest;
    /// 4 to 16, of a texture's texels: the nearest of 2^bits evenly spaced values from 0 to 1.
    /// Other than 8, factor maps come as real numbers, so that they are rounded once.
    int texel_bits = 8;
    /// 8 to 24, the width of everything from the iterated colour and the texel to the last unit. 8:
    /// unsigned bytes, negative results become 0. 9: bytes with a sign, as nv17. Each bit more is a
    /// fraction bit below the byte, which lives until the framebuffer: 1.0 is 255 x 2^(bits - 9).
    int register_bits = 9;
    VertexColorRounding vertex_color = VertexColorRounding::nv17;
    int snap_bits = 4;              ///< 0 to 12 fraction bits of window coordinates
    double snap_bias = 1.0 / 32.0;  ///< -1 to 1 pixel
    int framebuffer_bits = 8;       ///< 4 to 8 a channel, or 0: no rounding after the registers
    bool operator==(const CustomSettings&) const = default;
};

/// @throws Error naming the setting that is out of its range
void check_custom(const CustomSettings& settings);

/// nv17 with roundings and widths set at run time. Its framebuffer holds bytes as numbers, which
/// have a fraction only where nothing rounds it away.
class Custom : public Nv17 {
  public:
    using Pixel = double;
    static constexpr Preset preset = Preset::custom;
    /// A study of widths is not a study of units: as many as the state can name.
    static constexpr int texture_units = 4;
    static constexpr int combiner_stages = 8;

    /// @throws Error as check_custom
    explicit Custom(const CustomSettings& settings = {});

    const CustomSettings& settings() const { return settings_; }
    SnapRule snap() const { return {settings_.snap_bits, settings_.snap_bias}; }

    Color<int> vertex_color(const Color<nv1x::Word>& c) const;

    template <class Texel>
    Color<int> texel(const Texel& t) const {
        return {texel_channel(t, 0), texel_channel(t, 1), texel_channel(t, 2), texel_channel(t, 3)};
    }
    int expand(int v, int bits) const { return texel_byte(Nv17::expand(v, bits)); }
    int constant(double c) const { return from_byte(Nv17::constant(c)); }

    int filter(int t00, int t10, int t01, int t11, double a, double b) const;
    int filter_levels(int fine, int coarse, double fraction) const;

    int one() const { return from_byte(255); }
    int modulate(int a, int b) const { return product(a, b); }
    int scale(int a, int k) const { return a * k < one() ? a * k : one(); }
    int product(int a, int b) const { return divided(wide(a) * b); }
    int sum_of_products(int a, int b, int c, int d) const {
        return divided(wide(a) * b + wide(c) * d);
    }
    int dot(const Color<int>& a, const Color<int>& b) const {
        return divided(wide(a[0]) * b[0] + wide(a[1]) * b[1] + wide(a[2]) * b[2]);
    }
    int lerp(int a, int b, int f) const { return divided(wide(a) * f + wide(b) * (one() - f)); }
    int invert(int e) const { return one() - clamp_unsigned(e); }
    int expand_normal(int e) const { return 2 * (e > 0 ? e : 0) - one(); }
    int half_bias(int e) const { return (e > 0 ? e : 0) - from_byte(128); }
    int clamp_unsigned(int e) const { return clamped(e, 0, one()); }
    int scale_and_bias(int x, CombinerScale scale, bool bias) const;

    /// The fraction bits rounded away, halves up.
    Pixel finish(int a) const {
        if (real_framebuffer()) return static_cast<double>(clamp_unsigned(a)) / from_byte(1);
        return clamped((a + (from_byte(1) >> 1)) >> fraction_bits(), 0, 255);
    }
    Pixel pixel(double constant) const;
    Pixel blend(Pixel s, Pixel f, Pixel d, Pixel g) const;
    Pixel blend_subtract(Pixel s, Pixel f, Pixel d, Pixel g) const;
    Pixel quantise(Pixel p, int bits) const;
    Pixel add_dither(Pixel p, int bits, int sixteenths) const {
        return Nv17::add_dither(static_cast<int>(p), bits, sixteenths);
    }
    static std::uint8_t to_unorm8(Pixel p) { return static_cast<std::uint8_t>(p + 0.5); }
    static double to_real(Pixel p) { return p / 255.0; }

  private:
    static std::int64_t wide(int x) { return x; }
    int fraction_bits() const {
        return settings_.register_bits > 9 ? settings_.register_bits - 9 : 0;
    }
    int from_byte(int byte) const { return byte << fraction_bits(); }
    bool real_framebuffer() const { return settings_.framebuffer_bits == 0; }
    int texel_of(double x) const;
    int texel_byte(int byte) const {
        return settings_.texel_bits == 8 ? from_byte(byte) : texel_of(byte / 255.0);
    }
    int texel_channel(Rgba8 t, int c) const {
        const std::array<std::uint8_t, 4> bytes{t.r, t.g, t.b, t.a};
        return texel_byte(bytes[static_cast<std::size_t>(c)]);
    }
    int texel_channel(const Rgba32f& t, int c) const {
        return texel_of(static_cast<double>(t[static_cast<std::size_t>(c)]));
    }
    int divided(std::int64_t product) const;
    int mix(int p, int q, int weight) const;

    CustomSettings settings_;
};

static_assert(NumericModel<Custom>);

}  // namespace twofold
