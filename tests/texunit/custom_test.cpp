#include "texunit/custom.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "texunit/error.hpp"
#include "texunit/presets.hpp"
#include "texunit/random.hpp"

namespace {
using namespace twofold;

Custom with(auto CustomSettings::*setting, auto value) {
    CustomSettings settings;
    settings.*setting = value;
    return Custom(settings);
}

std::string error_of(auto CustomSettings::*setting, auto value) {
    try {
        with(setting, value);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

int draw(std::uint64_t index, int end) {
    return static_cast<int>(random_u64(17, index) % static_cast<std::uint64_t>(end));
}

double fraction(std::uint64_t index) {
    return static_cast<double>(draw(index, 1 << 20)) / (1 << 20);
}

Color<nv1x::Word> words(double x) {
    const auto w = Nv1xArithmetic::from_double(x);
    return {w, w, w, w};
}
}  // namespace

TEST_CASE("custom without settings computes what nv17 computes", "[custom]") {
    const Custom c;
    int unlike = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const auto byte = [i](std::uint64_t k) { return draw(16 * i + k, 256); };
        const auto is_signed = [i](std::uint64_t k) { return draw(16 * i + k, 511) - 255; };
        const double a = fraction(16 * i + 14), b = fraction(16 * i + 15);
        unlike += c.filter(byte(0), byte(1), byte(2), byte(3), a, b) !=
                  Nv17::filter(byte(0), byte(1), byte(2), byte(3), a, b);
        unlike += c.filter_levels(byte(0), byte(1), a) != Nv17::filter_levels(byte(0), byte(1), a);
        unlike += c.sum_of_products(is_signed(0), is_signed(1), is_signed(2), is_signed(3)) !=
                  Nv17::sum_of_products(is_signed(0), is_signed(1), is_signed(2), is_signed(3));
        unlike += c.lerp(byte(0), byte(1), byte(2)) != Nv17::lerp(byte(0), byte(1), byte(2));
        unlike += c.vertex_color(words(a)) != Nv17::vertex_color(words(a));
    }
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) unlike += c.modulate(a, b) != Nv17::modulate(a, b);
    for (int x = -510; x <= 510; ++x)
        for (const auto s :
             {CombinerScale::one, CombinerScale::two, CombinerScale::four, CombinerScale::one_half})
            for (const bool bias : {false, true})
                unlike += c.scale_and_bias(x, s, bias) != Nv17::scale_and_bias(x, s, bias);
    CHECK(unlike == 0);
    CHECK(c.snap().fraction_bits == Nv17::snap().fraction_bits);
    CHECK(c.snap().bias == Nv17::snap().bias);
}

TEST_CASE("a setting out of its range is named", "[custom]") {
    CHECK(error_of(&CustomSettings::filter_weight_bits, 0) ==
          "custom preset: filter_weight_bits is 0, not 1 to 16");
    CHECK_FALSE(error_of(&CustomSettings::filter_weight_bits, 17).empty());
    CHECK(error_of(&CustomSettings::register_bits, 7) ==
          "custom preset: register_bits is 7, not 8 to 24");
    CHECK_FALSE(error_of(&CustomSettings::register_bits, 25).empty());
    CHECK_FALSE(error_of(&CustomSettings::texel_bits, 3).empty());
    CHECK_FALSE(error_of(&CustomSettings::texel_bits, 17).empty());
    CHECK_FALSE(error_of(&CustomSettings::snap_bits, -1).empty());
    CHECK_FALSE(error_of(&CustomSettings::snap_bits, 13).empty());
    CHECK_FALSE(error_of(&CustomSettings::snap_bias, 1.5).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(error_of(&CustomSettings::snap_bias, nan).empty());
    CHECK_FALSE(error_of(&CustomSettings::framebuffer_bits, 3).empty());
    CHECK_FALSE(error_of(&CustomSettings::framebuffer_bits, 9).empty());
    CHECK(error_of(&CustomSettings::framebuffer_bits, 0).empty());
    CHECK(error_of(&CustomSettings::snap_bits, 12).empty());
}

TEST_CASE("each product rounding is its formula, and nv2x's alone is neutral", "[custom]") {
    const Custom floor = with(&CustomSettings::product_rounding, ProductRounding::floor);
    const Custom shift = with(&CustomSettings::product_rounding, ProductRounding::shift);
    int wrong = 0, unlike_nearest = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            wrong += floor.modulate(a, b) != a * b / 255;
            wrong += shift.modulate(a, b) != a * b >> 8;
            unlike_nearest += shift.modulate(a, b) != mul_rn(a, b);
        }
    CHECK(wrong == 0);
    CHECK(unlike_nearest == 47056);  // C01
    CHECK(floor.product(-1, 1) == -1);
    CHECK(floor.product(255, -255) == -255);
}

TEST_CASE("each filter rounding is its formula", "[custom]") {
    const Custom floor = with(&CustomSettings::filter_rounding, FilterRounding::floor);
    const Custom once = with(&CustomSettings::filter_rounding, FilterRounding::once);
    int wrong = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const auto t = [i](std::uint64_t k) { return draw(8 * i + k, 256); };
        const double a = fraction(8 * i + 6), b = fraction(8 * i + 7);
        const double wa = std::floor(256 * a) / 256, wb = std::floor(256 * b) / 256;
        const auto mix = [](double p, double q, double w) { return p + w * (q - p); };
        const double row0 = mix(t(0), t(1), wa), row1 = mix(t(2), t(3), wa);
        wrong += floor.filter(t(0), t(1), t(2), t(3), a, b) !=
                 static_cast<int>(std::floor(mix(std::floor(row0), std::floor(row1), wb)));
        wrong += once.filter(t(0), t(1), t(2), t(3), a, b) !=
                 static_cast<int>(std::floor(mix(row0, row1, wb) + 0.5));
    }
    CHECK(wrong == 0);
}

TEST_CASE("weights of n bits have 2^n steps and never reach the next texel", "[custom]") {
    for (int bits = 1; bits <= 16; ++bits) {
        const Custom c = with(&CustomSettings::filter_weight_bits, bits);
        CHECK(c.filter(0, 255, 0, 255, 0.0, 0.0) == 0);
        CHECK(c.filter(255, 255, 255, 255, 0.7, 0.3) == 255);
        const double last = 255.0 * (1.0 - std::ldexp(1.0, -bits));
        CHECK(c.filter(0, 255, 0, 255, 1.0 - 0x1p-30, 0.0) == static_cast<int>(last + 0.5));
        CHECK(c.filter(0, 255, 0, 255, 1.0, 0.0) == static_cast<int>(last + 0.5));
    }
    CHECK(with(&CustomSettings::filter_weight_bits, 1).filter(0, 255, 0, 255, 0.49, 0.0) == 0);
}

TEST_CASE("registers of 8 bits hold no negative number, of more than 9 a fraction", "[custom]") {
    const Custom bytes = with(&CustomSettings::register_bits, 8);
    CHECK(bytes.scale_and_bias(-3, CombinerScale::one, false) == 0);
    CHECK(bytes.scale_and_bias(255, CombinerScale::two, false) == 255);
    CHECK(Custom{}.scale_and_bias(-3, CombinerScale::one, false) == -3);

    const Custom wide = with(&CustomSettings::register_bits, 16);
    CHECK(wide.one() == 255 << 7);
    CHECK(wide.finish(wide.one()) == 255);
    CHECK(wide.finish((10 << 7) + 63) == 10);
    CHECK(wide.finish((10 << 7) + 64) == 11);
    // 3 / 255 of 100 / 255, three times over: bytes lose it at once
    const int third = wide.product(wide.expand(3, 8), wide.expand(100, 8));
    CHECK(wide.finish(wide.add(third, wide.add(third, third))) == 4);  // 3.53
    CHECK(3 * mul_rn(3, 100) == 3);
}

TEST_CASE("at every register width a byte's way through a unit is itself and white neutral",
          "[custom][law]") {
    for (int bits = 8; bits <= 24; ++bits) {
        const Custom c = with(&CustomSettings::register_bits, bits);
        int wrong = 0;
        for (int k = 0; k < 256; ++k) {
            const auto b = static_cast<std::uint8_t>(k);
            const int e = c.texel(Rgba8{b, b, b, b})[3];
            wrong += c.finish(e) != k;
            wrong += c.modulate(e, c.one()) != e || c.modulate(e, 0) != 0;
            wrong += c.filter(e, e, e, e, 0.3, 0.9) != e;
            wrong += c.iterate_color({{3, 5, 7}, {1, 2, 3}}, e, e, e) != e;
            wrong += c.vertex_color(words(k / 255.0))[0] != e;
            wrong += c.invert(c.invert(e)) != e;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE(
    "wider registers bring a product of three bytes nearer to the truth, but one bit does not",
    "[custom]") {
    std::array<int, 17> off{};
    for (const int bits : {9, 10, 12, 16}) {
        const Custom c = with(&CustomSettings::register_bits, bits);
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const int x = draw(3 * i, 256), y = draw(3 * i + 1, 256), z = draw(3 * i + 2, 256);
            const auto in = [&c](int k) { return c.expand(k, 8); };
            const auto shown =
                static_cast<int>(c.finish(c.modulate(c.modulate(in(x), in(y)), in(z))));
            off[static_cast<std::size_t>(bits)] += shown != (2 * x * y * z + 65025) / (2 * 65025);
        }
    }
    CHECK(off[10] > off[9]);  // a half that was rounded up is rounded up again
    CHECK(off[10] > off[12]);
    CHECK(off[12] > off[16]);
    CHECK(std::abs(off[9] / 20000.0 - 0.121) < 0.01);  // 12.1 % of all triples of bytes
}

TEST_CASE("the vertex colour roundings give 0.7 as 179, 178, 179 and 178", "[custom]") {
    const auto byte = [](VertexColorRounding rounding) {
        return with(&CustomSettings::vertex_color, rounding).vertex_color(words(0.7));
    };
    CHECK(byte(VertexColorRounding::nv17) == Color<int>{179, 179, 179, 178});
    CHECK(byte(VertexColorRounding::nv2x) == Color<int>{178, 178, 178, 178});
    CHECK(byte(VertexColorRounding::nearest)[0] == rn8(static_cast<double>(0.7f)));
    CHECK(byte(VertexColorRounding::floor) == Color<int>{178, 178, 178, 178});
    CHECK(with(&CustomSettings::vertex_color, VertexColorRounding::floor)
              .vertex_color(words(2.0))[0] == 255);
}

TEST_CASE("a framebuffer of fewer bits cuts what any format would keep", "[custom]") {
    const Custom c = with(&CustomSettings::framebuffer_bits, 5);
    for (int k = 0; k < 256; ++k) {
        CHECK(c.quantise(k, 8) == (k & 0xf8));
        CHECK(c.quantise(k, 6) == (k & 0xf8));
        CHECK(c.quantise(k, 4) == (k & 0xf0));
    }
}

TEST_CASE("the snap rule of custom is as set", "[custom]") {
    CustomSettings settings;
    settings.snap_bits = 2;
    settings.snap_bias = -0.125;
    with_model(Preset::custom, settings, []<class M>(const M& model) {
        if constexpr (std::is_same_v<M, Custom>) {
            CHECK(model.snap().fraction_bits == 2);
            CHECK(model.snap().bias == -0.125);
        }
    });
}

TEST_CASE("a texel is the nearest of the values that its bits name, whatever it came as",
          "[custom]") {
    for (const int bits : {4, 5, 8, 12, 16}) {
        CustomSettings settings;
        settings.texel_bits = bits;
        settings.register_bits = 24;
        const Custom c(settings);
        const double steps = (1 << bits) - 1;
        double worst = 0.0;
        for (int k = 0; k <= 1000; ++k) {
            const float x = static_cast<float>(k) / 1000.0f;
            const double read = c.texel(Rgba32f{x, x, x, 1.0f})[1] / static_cast<double>(c.one());
            const double wanted = std::floor(steps * static_cast<double>(x) + 0.5) / steps;
            worst = std::max(worst, std::fabs(read - wanted));
        }
        CHECK(worst <= 0.5000001 / c.one());  // the registers' own rounding
        CHECK(c.texel(Rgba8{255, 0, 255, 0}) == Color<int>{c.one(), 0, c.one(), 0});
    }
    for (int k = 0; k < 256; ++k) {
        const auto b = static_cast<std::uint8_t>(k);
        const float x = static_cast<float>(k) / 255.0f;
        CHECK(Custom{}.texel(Rgba8{b, b, b, b}) == Custom{}.texel(Rgba32f{x, x, x, x}));
    }
}

TEST_CASE("with everything wide a product keeps what the registers hold", "[custom]") {
    CustomSettings settings;
    settings.texel_bits = 16;
    settings.register_bits = 24;
    settings.vertex_color = VertexColorRounding::real;
    settings.framebuffer_bits = 0;
    const Custom c(settings);
    double worst = 0.0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const double x = fraction(2 * i), y = fraction(2 * i + 1);
        const auto texel = c.texel(Rgba32f{static_cast<float>(y), 0.0f, 0.0f, 1.0f})[0];
        const int product = c.modulate(c.vertex_color(words(x))[0], texel);
        worst = std::max(worst, std::fabs(c.to_real(c.finish(product)) - x * y));
    }
    CHECK(worst < 1.1 / 65535.0);  // half a step of the texel and what the registers round
    CHECK(c.quantise(c.finish(c.one() / 3), 8) == Approx(85.0).margin(1e-4));
    CHECK(c.quantise(c.finish(c.one() / 3), 5) == 80.0);
    CHECK(c.blend(51.0, 127.5, 102.0, 255.0) == 127.5);
    CHECK(c.blend_subtract(51.0, 127.5, 102.0, 255.0) == 0.0);
    CHECK(c.to_unorm8(84.5) == 85);
}

TEST_CASE("a byte of a packed texel is rounded to the texels' bits as any other") {
    for (int bits = 4; bits <= 16; ++bits) {
        const Custom m = with(&CustomSettings::texel_bits, bits);
        int wrong = 0;
        for (int k = 0; k < 256; ++k) {
            const Rgba8 texel{static_cast<std::uint8_t>(k), 0, 0, 0};
            wrong += m.expand(k, 8) != m.texel(texel)[0];
        }
        CHECK(wrong == 0);
        CHECK(m.expand(31, 5) == m.one());
    }
}
