#pragma once
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
    floor     ///< floor(255 x)
};

/// What the preset `custom` takes at run time, so that a study can vary one stage alone. The
/// initial values are nv17's; each changes its stage and no other.
struct CustomSettings {
    int filter_weight_bits = 8;  ///< 1 to 16; between texels and between levels
    FilterRounding filter_rounding = FilterRounding::half_up;
    ProductRounding product_rounding = ProductRounding::nearest;
    /// 8 to 16, the width of everything from the iterated colour and the texel to the last unit. 8:
    /// unsigned bytes, negative results become 0. 9: bytes with a sign, as nv17. Each bit more is a
    /// fraction bit below the byte, which lives until the framebuffer: 1.0 is 255 x 2^(bits - 9).
    int register_bits = 9;
    VertexColorRounding vertex_color = VertexColorRounding::nv17;
    int snap_bits = 4;              ///< 0 to 12 fraction bits of window coordinates
    double snap_bias = 1.0 / 32.0;  ///< -1 to 1 pixel
    int framebuffer_bits = 8;       ///< 4 to 8 a channel
    bool operator==(const CustomSettings&) const = default;
};

/// @throws Error naming the setting that is out of its range
void check_custom(const CustomSettings& settings);

/// nv17 with roundings and widths set at run time.
class Custom : public Nv17 {
  public:
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
        const auto bytes = Nv17::texel(t);
        return {from_byte(bytes[0]), from_byte(bytes[1]), from_byte(bytes[2]), from_byte(bytes[3])};
    }
    int expand(int v, int bits) const { return from_byte(Nv17::expand(v, bits)); }
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
    int finish(int a) const {
        return clamped((a + (from_byte(1) >> 1)) >> fraction_bits(), 0, 255);
    }
    int quantise(int p, int bits) const {
        const int kept = settings_.framebuffer_bits;
        return keep_high_bits(p, bits < kept ? bits : kept);
    }

  private:
    static std::int64_t wide(int x) { return x; }
    int fraction_bits() const {
        return settings_.register_bits > 9 ? settings_.register_bits - 9 : 0;
    }
    int from_byte(int byte) const { return byte << fraction_bits(); }
    int divided(std::int64_t product) const;
    int mix(int p, int q, int weight) const;

    CustomSettings settings_;
};

static_assert(NumericModel<Custom>);

}  // namespace twofold
