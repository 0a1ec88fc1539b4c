#include <catch2/catch.hpp>
#include <type_traits>

#include "tests/texunit/laws.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/random.hpp"

/// Laws of vertex colours, their iteration, and the framebuffer that hold for every preset. coarse8
/// may lose a step of a vertex colour k/255: that law is stated for the others.
namespace {
using namespace twofold;
using namespace twofold::laws;
}  // namespace

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

TEMPLATE_TEST_CASE("an iterated colour stays among bytes where w differ in sign or are 0", "[law]",
                   Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    const auto a = in<M>(13), b = in<M>(200), c = in<M>(77);
    constexpr bool among_vertices = !std::is_same_v<M, Coarse8>;
    int outside = 0;
    for (const double w0 : {-3.0, 0.0, 1e-30, 1.0, 1e30})
        for (const double w1 : {-1.0, 0.0, -1e30, 2.0})
            for (std::int64_t x = 0; x <= 12; ++x) {
                const int k = m<M>.iterate_color({{x, 12 - x, 5}, {w0, w1, 1.0}}, a, b, c);
                outside += among_vertices ? k < 13 || k > 200 : k < 0 || k > 255;
            }
    CHECK(outside == 0);
}

TEST_CASE("registers of 24 bits iterate without overflow, w of any sign", "[law]") {
    CustomSettings settings;
    settings.register_bits = 24;
    const Custom wide(settings);
    const int one = wide.one();
    for (const double w : {-1.0 - 0x1p-20, -1.0, 0.0, 1e-30, 1.0, 1e30}) {
        CAPTURE(w);
        const int k = wide.iterate_color({{7, 7, 1}, {1.0, w, 1.0}}, one, 0, one);
        CHECK((k >= 0 && k <= one));
        CHECK(wide.iterate_color({{7, 7, 1}, {1.0, w, 1.0}}, one, one, one) == one);
    }
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

TEST_CASE("nv2x takes a vertex colour without the 22-bit rounding", "[nv2x]") {
    const auto word = Nv2xArithmetic::from_double(0.7);
    CHECK(Nv17::vertex_color({word, word, word, word}) == Color<int>{179, 179, 179, 178});
    CHECK(Nv2x::vertex_color({word, word, word, word}) == Color<int>{178, 178, 178, 178});
    CHECK_FALSE(Nv2x::coords_over_w);
    CHECK(Nv17::coords_over_w);
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
