#include "texunit/numeric_model.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/texunit/laws.hpp"

/// Laws of the texture units that hold for every preset, over all bytes. coarse8 breaks some by
/// design: white is not neutral and products are not to nearest. Those laws are stated for the
/// others.
namespace {
using namespace twofold;
using namespace twofold::laws;

/// Fractions whose bits reach further than those of any preset's filter weight.
constexpr std::array<double, 9> fractions{0.0,   0x1p-30, 0.0999, 1.0 / 3.0,    0.5,
                                          0.625, 0.7001,  0.998,  1.0 - 0x1p-20};
}  // namespace

TEMPLATE_TEST_CASE("a byte's way through a texture unit and out is itself", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    for (int k = 0; k < 256; ++k) {
        const auto b = static_cast<std::uint8_t>(k);
        const auto color = m<M>.texel(Rgba8{b, b, b, b});
        for (const auto c : color) CHECK(out<M>(c) == k);
        const auto real = static_cast<float>(k / 255.0);
        for (const auto c : m<M>.texel(Rgba32f{real, real, real, real})) CHECK(out<M>(c) == k);
        CHECK(m<M>.to_unorm8(m<M>.pixel(k / 255.0)) == k);
        CHECK(m<M>.to_unorm8(m<M>.pixel(m<M>.to_real(pixel_of<M>(k)))) == k);
    }
}

TEMPLATE_TEST_CASE("white is the identity of modulate and black annihilates", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    const auto white = in<M>(255), black = in<M>(0);
    for (int k = 0; k < 256; ++k) {
        const auto c = in<M>(k);
        CHECK(m<M>.modulate(c, white) == c);
        CHECK(m<M>.modulate(white, c) == c);
        CHECK(m<M>.modulate(c, black) == black);
        CHECK(m<M>.modulate(black, c) == black);
    }
}

TEMPLATE_TEST_CASE("modulate commutes, stays in range and shows the product to nearest", "[law]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    int asymmetric = 0, outside = 0, not_nearest = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            const auto product = m<M>.modulate(in<M>(a), in<M>(b));
            asymmetric += product != m<M>.modulate(in<M>(b), in<M>(a));
            outside += product < in<M>(0) || product > in<M>(255);
            not_nearest += out<M>(product) != mul_rn(a, b);
        }
    CHECK(asymmetric == 0);
    CHECK(outside == 0);
    CHECK(not_nearest == 0);
}

TEMPLATE_TEST_CASE("filtering with fraction 0 gives the first texel exactly", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    int wrong = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b)
            wrong += m<M>.filter(in<M>(a), in<M>(b), in<M>(b), in<M>(255 - b), Real{0}, Real{0}) !=
                     in<M>(a);
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("filtering four equal texels shows that texel", "[law]", Ideal64, Float32, Gl13,
                   Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    for (const double a : fractions)
        for (const double b : fractions)
            for (int k = 0; k < 256; ++k) {
                const auto t = in<M>(k);
                const auto filtered =
                    m<M>.filter(t, t, t, t, static_cast<Real>(a), static_cast<Real>(b));
                if (out<M>(filtered) != k) CHECK(out<M>(filtered) == k);
            }
}

TEMPLATE_TEST_CASE("a filtered texel lies within the range of its four texels", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    int outside = 0;
    for (const double a : fractions)
        for (const double b : fractions)
            for (int p = 0; p < 256; p += 5)
                for (int q = 0; q < 256; q += 3) {
                    const int lo = p < q ? p : q, hi = p < q ? q : p;
                    const int shown =
                        out<M>(m<M>.filter(in<M>(p), in<M>(q), in<M>(q), in<M>(p),
                                           static_cast<Real>(a), static_cast<Real>(b)));
                    outside += shown < lo || shown > hi;
                }
    CHECK(outside == 0);
    for (const double a : fractions) {
        const auto w = in<M>(255);
        const auto f = static_cast<Real>(a);
        CHECK_FALSE(m<M>.filter(w, w, w, w, f, f) > w);
    }
}

TEMPLATE_TEST_CASE("C02 scale by 2 and 4 saturates after the scale", "[hard][C02]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    for (int k = 0; k < 256; ++k)
        for (const int factor : {1, 2, 4}) {
            const int expected = factor * k < 255 ? factor * k : 255;
            CHECK(out<M>(m<M>.scale(in<M>(k), factor)) == expected);
        }
    CHECK(out<M>(m<M>.scale(in<M>(100), 4)) == 255);
    CHECK(out<M>(m<M>.scale(in<M>(200), 2)) == 255);
}

TEMPLATE_TEST_CASE("lerp at 0 and 1 gives the ends, and between them the mean to nearest", "[law]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    int wrong = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; b += 3) {
            wrong += m<M>.lerp(in<M>(a), in<M>(b), m<M>.one()) != in<M>(a);
            wrong += m<M>.lerp(in<M>(a), in<M>(b), in<M>(0)) != in<M>(b);
            for (int f = 0; f < 256; f += 5)
                wrong +=
                    out<M>(m<M>.lerp(in<M>(a), in<M>(b), in<M>(f))) != sum_rn(a, f, b, 255 - f);
        }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("the filter between levels begins at the finer and stays between the two",
                   "[law]", Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    for (int a = 0; a < 256; a += 5)
        for (int b = 0; b < 256; b += 5) {
            CHECK(m<M>.filter_levels(in<M>(a), in<M>(b), Real{0}) == in<M>(a));
            for (const double f : fractions) {
                const int k = out<M>(m<M>.filter_levels(in<M>(a), in<M>(b), static_cast<Real>(f)));
                const bool between = k >= std::min(a, b) && k <= std::max(a, b);
                if (!between) FAIL_CHECK(k << " is not between " << a << " and " << b);
            }
        }
}

TEMPLATE_TEST_CASE("signed products and sums of products turn with their signs", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    int wrong = 0;
    for (int i = 0; i < 256; i += 3)
        for (int j = 0; j < 256; ++j) {
            const auto a = in<M>(i), b = in<M>(j), n = m<M>.negate(a), one = m<M>.one();
            wrong += m<M>.product(a, b) != m<M>.modulate(a, b);
            wrong += m<M>.product(n, b) != m<M>.negate(m<M>.product(a, b));
            wrong += m<M>.product(n, m<M>.negate(b)) != m<M>.product(a, b);
            wrong += m<M>.sum_of_products(a, one, b, one) != m<M>.add(a, b);
            wrong +=
                m<M>.sum_of_products(a, one, b, m<M>.negate(one)) != m<M>.add(a, m<M>.negate(b));
            wrong += m<M>.dot({a, a, b, one}, {b, one, one, one}) !=
                     m<M>.negate(m<M>.dot({n, n, m<M>.negate(b), one}, {b, one, one, one}));
        }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("the products of integer presets are rounded once, whatever they sum", "[law]",
                   Nv2x, Nv17, Custom) {
    using M = TestType;
    const auto is_nearest = [](int n, int x) { return 2 * std::abs(255 * n - x) < 255; };
    int wrong = 0;
    for (int a = -255; a < 256; a += 7)
        for (int b = -255; b < 256; b += 6)
            for (int c = -255; c < 256; c += 17) {
                wrong += !is_nearest(m<M>.sum_of_products(a, b, c, 200), a * b + c * 200);
                wrong += !is_nearest(m<M>.dot({a, b, c, 0}, {b, c, 77, 0}), a * b + b * c + 77 * c);
            }
    CHECK(wrong == 0);
}

TEST_CASE("T10 5, 6, 4 and 1 bits become bytes by repetition, k / (2^n - 1) or zeros",
          "[hard][T10]") {
    std::array<int, 2> unlike{};
    for (const int bits : {1, 4, 5, 6, 8})
        for (int v = 0; v < 1 << bits; ++v) {
            const int last = (1 << bits) - 1;
            const int replicated = Nv17::expand(v, bits), rounded = rn8(Ideal64::expand(v, bits));
            CHECK(Nv2x::expand(v, bits) == replicated);
            CHECK(m<Custom>.expand(v, bits) == replicated);
            CHECK(Gl13::expand(v, bits) == static_cast<double>(v) / last);
            CHECK(Coarse8::expand(v, bits) == v * (256 >> bits));
            if (bits == 4) CHECK(replicated == v * 17);
            if (bits == 5) CHECK(replicated == (v << 3) + (v >> 2));
            if (bits == 6) CHECK(replicated == (v << 2) + (v >> 4));
            if (bits == 5 || bits == 6)
                unlike[static_cast<std::size_t>(bits - 5)] += replicated != rounded;
            else
                CHECK(replicated == rounded);
        }
    CHECK(unlike == std::array{4, 10});
}

TEST_CASE("T10 the bytes of five bits that differ from the nearest are 3, 7, 24 and 28",
          "[hard][T10]") {
    CHECK(Nv17::expand(3, 5) == 24);
    CHECK(Nv17::expand(7, 5) == 57);
    CHECK(Nv17::expand(24, 5) == 198);
    CHECK(Nv17::expand(28, 5) == 231);
    CHECK(Nv17::expand(11, 6) == 44);
    CHECK(Nv17::expand(48, 6) == 195);
}

TEST_CASE("coarse8 breaks the laws that it is meant to break", "[coarse8]") {
    CHECK(Coarse8::modulate(255, 255) == 254);
    CHECK(Coarse8::lerp(255, 0, 255) == 254);
    CHECK(Coarse8::product(-1, 1) == -1);
    CHECK(Coarse8::vertex_color({0.999f, 0.5f, 1.0f, 2.0f}) == Color<int>{254, 127, 255, 255});
    CHECK(Coarse8::scale_and_bias(-5, CombinerScale::two, false) == 0);
    CHECK(Coarse8::scale_and_bias(25, CombinerScale::one_half, false) == 12);
    CHECK(Coarse8::blend(255, 100, 255, 155) == 255);
    CHECK(Coarse8::blend(128, 127, 127, 128) == 126);  // 63 + 63 of 127.5
    CHECK(Coarse8::filter(0, 255, 0, 255, 0.99, 0.0) == 239);
    CHECK(Coarse8::filter_levels(10, 200, 0.99) == 10);
    CHECK(Coarse8::depth(1.0, 24) == 65535);
}

TEST_CASE("the chips have their numbers of units and stages", "[preset]") {
    CHECK(Nv17::texture_units == 2);
    CHECK(Nv17::combiner_stages == 2);
    CHECK(Nv2x::texture_units == 4);
    CHECK(Nv2x::combiner_stages == 8);
    CHECK(Ideal64::texture_units == static_cast<int>(max_units));
}
