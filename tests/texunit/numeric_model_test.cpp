#include "texunit/numeric_model.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <type_traits>

#include "texunit/presets.hpp"
#include "texunit/random.hpp"

/// Laws that hold for every preset, over all bytes. `texel` is the way in, `finish` and `to_unorm8`
/// the way out. coarse8 breaks some by design: white is not neutral, products are not to nearest,
/// and a vertex colour k/255 may lose a step. Those laws are stated for the others.
namespace {
using namespace twofold;

/// Models hold no state but `custom`, whose initial settings are nv17's.
template <NumericModel M>
const M m{};

template <NumericModel M>
typename M::Channel in(int byte) {
    return m<M>.texel(Rgba8{static_cast<std::uint8_t>(byte), 0, 0, 0})[0];
}

template <NumericModel M>
int out(typename M::Channel c) {
    return m<M>.to_unorm8(m<M>.finish(c));
}

template <NumericModel M>
typename M::Pixel pixel_of(int byte) {
    return m<M>.finish(in<M>(byte));
}

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

TEMPLATE_TEST_CASE("a vertex colour k/255 comes back as k in all four channels", "[law]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    for (int k = 0; k < 256; ++k) {
        const auto w = M::Vertex::from_double(k / 255.0);
        for (const auto c : m<M>.vertex_color({w, w, w, w})) CHECK(out<M>(c) == k);
    }
}

TEMPLATE_TEST_CASE("a vertex colour outside 0..1 becomes the nearer end", "[law]", Ideal64, Float32,
                   Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    const auto color_of = [](double x) {
        const auto w = M::Vertex::from_double(x);
        return m<M>.vertex_color({w, w, w, w});
    };
    for (const double x : {-1e30, -1.0, -1e-3, -0.0})
        for (const auto c : color_of(x)) CHECK(out<M>(c) == 0);
    for (const double x : {1.0, 1.001, 2.0, 1e30})
        for (const auto c : color_of(x)) CHECK(out<M>(c) == 255);
}

TEMPLATE_TEST_CASE("iterating a constant colour keeps it exactly", "[law]", Ideal64, Float32, Gl13,
                   Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    for (std::uint64_t i = 0; i < 64; ++i) {
        const auto draw = [i](std::uint64_t k) {
            return static_cast<std::int64_t>(random_u64(7, 8 * i + k) % 100000);
        };
        const std::array<std::int64_t, 3> edge{draw(0) + 1, draw(1), draw(2)};
        const auto w = static_cast<Real>(1 + draw(3)), v = static_cast<Real>(1 + draw(4));
        for (int k = 0; k < 256; ++k) {
            const auto c = in<M>(k);
            if (m<M>.iterate_color({edge, {w, w, w}}, c, c, c) != c) FAIL_CHECK("equal w, " << k);
            if (m<M>.iterate_color({edge, {w, v, w}}, c, c, c) != c)
                FAIL_CHECK("perspective, " << k);
        }
    }
}

TEMPLATE_TEST_CASE("the colour iterator gives each vertex its colour and stays between", "[law]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    using Real = typename M::Real;
    const auto a = in<M>(13), b = in<M>(200), c = in<M>(77);
    for (const Real w : {Real{1}, Real{5}}) {
        CHECK(out<M>(m<M>.iterate_color({{9, 0, 0}, {Real{1}, w, Real{1}}}, a, b, c)) == 13);
        CHECK(out<M>(m<M>.iterate_color({{0, 9, 0}, {Real{1}, w, Real{1}}}, a, b, c)) == 200);
        CHECK(out<M>(m<M>.iterate_color({{0, 0, 9}, {Real{1}, w, Real{1}}}, a, b, c)) == 77);
    }
    int outside = 0;
    for (std::int64_t x = 0; x <= 40; ++x)
        for (std::int64_t y = 0; x + y <= 40; ++y)
            for (const Real w : {Real{1}, Real{1} / Real{3}, Real{7}}) {
                const int k = out<M>(
                    m<M>.iterate_color({{x, y, 40 - x - y}, {Real{1}, w, Real{1}}}, a, b, c));
                outside += k < 13 || k > 200;
            }
    CHECK(outside == 0);
}

TEST_CASE("the nv17 iterator cuts the weights of the first and third vertex to 1/256", "[nv17]") {
    const auto at = [](std::array<std::int64_t, 3> edge, std::array<double, 3> w) {
        return Nv17::iterate_color({edge, w}, 0, 255, 0);
    };
    CHECK(at({1, 1, 1}, {1, 1, 1}) == 86);     // n = 85, 86, 85: (86 x 255 + 128) >> 8
    CHECK(at({1, 2, 1}, {1, 1, 1}) == 128);    // n1 = 128
    CHECK(at({1, 1, 1}, {1, 2, 1}) == 128);    // perspective: the same weights
    CHECK(at({127, 2, 127}, {1, 1, 1}) == 2);  // floor(127) twice leaves 2
    CHECK(at({3, 0, 4}, {1, 1, 1}) == 1);      // 109.7 and 146.3: the cut leaves 1 to the second
}

TEMPLATE_TEST_CASE("blending with (one, zero) replaces and with (zero, one) keeps", "[law]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    const auto one = m<M>.pixel(1.0), zero = m<M>.pixel(0.0);
    int wrong = 0;
    for (int s = 0; s < 256; ++s)
        for (int d = 0; d < 256; ++d) {
            wrong += m<M>.blend(pixel_of<M>(s), one, pixel_of<M>(d), zero) != pixel_of<M>(s);
            wrong += m<M>.blend(pixel_of<M>(s), zero, pixel_of<M>(d), one) != pixel_of<M>(d);
        }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("C06 adding in the framebuffer saturates at 255", "[hard][C06]", Ideal64,
                   Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    const auto one = m<M>.pixel(1.0);
    for (int s = 0; s < 256; ++s)
        for (int d = 0; d < 256; d += 5) {
            const int expected = s + d < 255 ? s + d : 255;
            CHECK(m<M>.to_unorm8(m<M>.blend(pixel_of<M>(s), one, pixel_of<M>(d), one)) == expected);
        }
}

TEST_CASE("R20 the ends of the depth range never wrap", "[hard][R20]") {
    constexpr std::uint32_t last = 0xffffff;
    const double below_one = 1.0 - 0x1p-24;
    CHECK(depth_rounded(1.0, 24) == last);
    CHECK(depth_cut(1.0, 24) == last);
    CHECK(depth_rounded(below_one, 24) == last - 1);
    CHECK(depth_cut(below_one, 24) == last - 1);
    CHECK(depth_rounded(1.0 - 0x1p-53, 24) == last);
    CHECK(depth_cut(1.0 - 0x1p-53, 24) == last - 1);
    CHECK(depth_rounded(1.0, 16) == 0xffff);
    CHECK(depth_cut(1.0, 16) == 0xffff);
    CHECK(depth_cut(54886.93 / 65535.0, 16) == 54886);
    for (const double z : {0.0, -0.0, -1.0, -1e300}) {
        CHECK(depth_rounded(z, 24) == 0);
        CHECK(depth_cut(z, 24) == 0);
    }
    for (const double z : {1.0 + 0x1p-20, 1.25, 255.0}) {
        CHECK(depth_rounded(z, 24) == last);
        CHECK(depth_cut(z, 24) == last);
    }
    CHECK(depth_rounded(1e300, 24) == last);
    CHECK(depth_cut(1e300, 24) == last);
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

TEMPLATE_TEST_CASE("blending by subtraction rounds once and ends at 0", "[law]", Gl13, Nv2x, Nv17,
                   Custom) {
    using M = TestType;
    int wrong = 0;
    for (int s = 0; s < 256; s += 3)
        for (int f = 0; f < 256; f += 5)
            for (int d = 0; d < 256; d += 5)
                for (const int g : {0, 1, 100, 255}) {
                    const int x = s * f - d * g;
                    const int expected = x < 0 ? 0 : (2 * x + 255) / 510;
                    wrong += m<M>.to_unorm8(m<M>.blend_subtract(s, f, d, g)) != expected;
                }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("subtracting in a real framebuffer ends at 0", "[law]", Ideal64, Float32) {
    using M = TestType;
    using P = typename M::Pixel;
    CHECK(M::blend_subtract(P{0.75}, P{1}, P{0.5}, P{0.5}) == P{0.5});
    CHECK(M::blend_subtract(P{0.25}, P{1}, P{0.5}, P{1}) == P{0});
}

TEMPLATE_TEST_CASE("a pixel keeps its highest bits and real presets keep it whole", "[law]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    // custom's numbers hold what its settings ask for: bytes unless the framebuffer is unrounded.
    constexpr bool bytes = std::is_integral_v<typename M::Pixel> || std::is_same_v<M, Custom>;
    for (int k = 0; k < 256; ++k)
        for (const int bits : {4, 5, 6, 8}) {
            const auto p = pixel_of<M>(k);
            const int kept = bytes ? k & (0xff00 >> bits) : k;
            CHECK(m<M>.to_unorm8(m<M>.quantise(p, bits)) == kept);
            for (const int n : {0, 7, 15}) {
                const auto raised = m<M>.quantise(m<M>.add_dither(p, bits, n), bits);
                const int step = 256 >> bits;
                const int rise = m<M>.to_unorm8(raised) - kept;
                CHECK((rise == 0 || (n > 0 && rise == step)));
                CHECK(m<M>.to_unorm8(raised) <= 255);
            }
        }
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

TEST_CASE("nv2x takes a vertex colour without the 22-bit rounding", "[nv2x]") {
    const auto word = Nv2xArithmetic::from_double(0.7);
    CHECK(Nv17::vertex_color({word, word, word, word}) == Color<int>{179, 179, 179, 178});
    CHECK(Nv2x::vertex_color({word, word, word, word}) == Color<int>{178, 178, 178, 178});
    CHECK_FALSE(Nv2x::coords_over_w);
    CHECK(Nv17::coords_over_w);
}

TEST_CASE("the chips have their numbers of units and stages", "[preset]") {
    CHECK(Nv17::texture_units == 2);
    CHECK(Nv17::combiner_stages == 2);
    CHECK(Nv2x::texture_units == 4);
    CHECK(Nv2x::combiner_stages == 8);
    CHECK(Ideal64::texture_units == static_cast<int>(max_units));
}
