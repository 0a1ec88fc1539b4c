#include "texunit/custom.hpp"

#include <fmt/format.h>

#include "texunit/error.hpp"
#include "texunit/fixed.hpp"

namespace twofold {
namespace {

/// Written so that NaN is out of range.
template <class T>
void check_range(const char* name, T value, T lo, T hi) {
    if (value >= lo && value <= hi) return;
    throw Error(ExitCode::failure,
                fmt::format("custom preset: {} is {}, not {} to {}", name, value, lo, hi));
}

int floor_quotient(std::int64_t x, std::int64_t divisor) {
    const std::int64_t q = x / divisor;
    return static_cast<int>(x % divisor < 0 ? q - 1 : q);
}

int nearest_quotient(std::int64_t x, std::int64_t divisor) {
    const std::int64_t magnitude = x < 0 ? -x : x;
    const auto q = static_cast<int>((2 * magnitude + divisor) / (2 * divisor));
    return x < 0 ? -q : q;
}

int vertex_byte(VertexColorRounding rounding, nv1x::Word x) {
    const double real = Nv1xArithmetic::to_double(x);
    switch (rounding) {
        case VertexColorRounding::nv17:
            return nv1x::float_to_byte(nv1x::round_to_22_bits(x));
        case VertexColorRounding::nv2x:
            return nv1x::float_to_byte(x);
        case VertexColorRounding::nearest:
            return rn8(real);
        case VertexColorRounding::floor:
        case VertexColorRounding::real:
            break;
    }
    return floor8(real);
}

}  // namespace

void check_custom(const CustomSettings& s) {
    check_range("filter_weight_bits", s.filter_weight_bits, 1, 16);
    check_range("texel_bits", s.texel_bits, 4, 16);
    check_range("register_bits", s.register_bits, 8, 24);
    check_range("snap_bits", s.snap_bits, 0, 12);
    check_range("snap_bias", s.snap_bias, -1.0, 1.0);
    if (s.framebuffer_bits != 0) check_range("framebuffer_bits", s.framebuffer_bits, 4, 8);
}

Custom::Custom(const CustomSettings& settings) : settings_(settings) { check_custom(settings); }

Color<int> Custom::vertex_color(const Color<nv1x::Word>& c) const {
    const auto rounding = settings_.vertex_color;
    if (rounding == VertexColorRounding::real) {
        const auto rounded = [&](nv1x::Word x) {
            return to_fixed_half_up(one() * Nv1xArithmetic::to_double(x), 0, one());
        };
        return {rounded(c[0]), rounded(c[1]), rounded(c[2]), rounded(c[3])};
    }
    // The 22-bit rounding leaves alpha out.
    const auto of_alpha =
        rounding == VertexColorRounding::nv17 ? VertexColorRounding::nv2x : rounding;
    return {from_byte(vertex_byte(rounding, c[0])), from_byte(vertex_byte(rounding, c[1])),
            from_byte(vertex_byte(rounding, c[2])), from_byte(vertex_byte(of_alpha, c[3]))};
}

/// One step of the filter: p (1 - w) + q w.
int Custom::mix(int p, int q, int weight) const {
    const int bits = settings_.filter_weight_bits;
    const std::int64_t sum = wide(p) * ((1 << bits) - weight) + wide(q) * weight;
    const int half = settings_.filter_rounding == FilterRounding::floor ? 0 : 1 << (bits - 1);
    return static_cast<int>((sum + half) >> bits);
}

int Custom::filter(int t00, int t10, int t01, int t11, double a, double b) const {
    const int bits = settings_.filter_weight_bits;
    const int wa = cut_weight(a, bits), wb = cut_weight(b, bits);
    if (settings_.filter_rounding != FilterRounding::once)
        return mix(mix(t00, t10, wa), mix(t01, t11, wa), wb);
    const std::int64_t full = std::int64_t{1} << bits;
    const std::int64_t sum = (full - wb) * ((full - wa) * t00 + wa * wide(t10)) +
                             wb * ((full - wa) * t01 + wa * wide(t11));
    return static_cast<int>((sum + full * full / 2) >> (2 * bits));
}

int Custom::filter_levels(int fine, int coarse, double fraction) const {
    return mix(fine, coarse, cut_weight(fraction, settings_.filter_weight_bits));
}

int Custom::scale_and_bias(int x, CombinerScale scale, bool bias) const {
    const int biased = bias ? x - from_byte(128) : x;
    const int least = settings_.register_bits == 8 ? 0 : -one();
    return clamped(scaled(biased, scale), least, one());
}

/// A texel's value in [0, 1], rounded to the texels' bits and then to the registers' width.
int Custom::texel_of(double x) const {
    const int steps = (1 << settings_.texel_bits) - 1;
    return nearest_quotient(wide(to_fixed_half_up(steps * x, 0, steps)) * one(), steps);
}

Custom::Pixel Custom::pixel(double constant) const {
    if (!real_framebuffer()) return Nv17::pixel(constant);
    return 255.0 * (constant > 0.0 ? (constant < 1.0 ? constant : 1.0) : 0.0);
}

Custom::Pixel Custom::blend(Pixel s, Pixel f, Pixel d, Pixel g) const {
    const double sum = s * f + d * g;
    if (real_framebuffer()) return sum < 255.0 * 255.0 ? sum / 255.0 : 255.0;
    return Nv17::blend(static_cast<int>(s), static_cast<int>(f), static_cast<int>(d),
                       static_cast<int>(g));
}

Custom::Pixel Custom::blend_subtract(Pixel s, Pixel f, Pixel d, Pixel g) const {
    const double difference = s * f - d * g;
    if (real_framebuffer()) return difference > 0.0 ? difference / 255.0 : 0.0;
    return Nv17::blend_subtract(static_cast<int>(s), static_cast<int>(f), static_cast<int>(d),
                                static_cast<int>(g));
}

Custom::Pixel Custom::quantise(Pixel p, int bits) const {
    if (real_framebuffer() && bits == 8) return p;
    const int kept = real_framebuffer() ? bits : settings_.framebuffer_bits;
    return keep_high_bits(static_cast<int>(p), bits < kept ? bits : kept);
}

/// A product of two registers, or a sum of such, as a register.
int Custom::divided(std::int64_t product) const {
    switch (settings_.product_rounding) {
        case ProductRounding::nearest:
            return nearest_quotient(product, one());
        case ProductRounding::floor:
            return floor_quotient(product, one());
        case ProductRounding::shift:
            break;
    }
    return static_cast<int>(product >> (8 + fraction_bits()));
}

}  // namespace twofold
