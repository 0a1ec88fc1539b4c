#include "texunit/numeric_model.hpp"

#include <catch2/catch.hpp>

#include "texunit/presets.hpp"
#include "texunit/random.hpp"

/// Laws that hold for every preset, over all bytes. `texel` is the way in, `finish` and `to_unorm8`
/// the way out.
namespace {
using namespace twofold;

template <NumericModel M>
typename M::Channel in(int byte) {
    return M::texel(Rgba8{static_cast<std::uint8_t>(byte), 0, 0, 0})[0];
}

template <NumericModel M>
int out(typename M::Channel c) {
    return M::to_unorm8(M::finish(c));
}

template <NumericModel M>
typename M::Pixel pixel_of(int byte) {
    return M::finish(in<M>(byte));
}

/// Fractions whose bits reach further than those of any preset's filter weight.
constexpr std::array<double, 9> fractions{0.0,   0x1p-30, 0.0999, 1.0 / 3.0,    0.5,
                                          0.625, 0.7001,  0.998,  1.0 - 0x1p-20};
}  // namespace

TEMPLATE_TEST_CASE("a byte's way through a texture unit and out is itself", "[law]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    for (int k = 0; k < 256; ++k) {
        const auto b = static_cast<std::uint8_t>(k);
        const auto color = M::texel(Rgba8{b, b, b, b});
        for (const auto c : color) CHECK(out<M>(c) == k);
        const auto real = static_cast<float>(k / 255.0);
        for (const auto c : M::texel(Rgba32f{real, real, real, real})) CHECK(out<M>(c) == k);
        CHECK(M::to_unorm8(M::pixel(k / 255.0)) == k);
        CHECK(M::to_unorm8(M::pixel(M::to_real(pixel_of<M>(k)))) == k);
    }
}

TEMPLATE_TEST_CASE("white is the identity of modulate and black annihilates", "[law]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    const auto white = in<M>(255), black = in<M>(0);
    for (int k = 0; k < 256; ++k) {
        const auto c = in<M>(k);
        CHECK(M::modulate(c, white) == c);
        CHECK(M::modulate(white, c) == c);
        CHECK(M::modulate(c, black) == black);
        CHECK(M::modulate(black, c) == black);
    }
}

TEMPLATE_TEST_CASE("modulate commutes, stays in range and shows the product to nearest", "[law]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    int asymmetric = 0, outside = 0, not_nearest = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            const auto product = M::modulate(in<M>(a), in<M>(b));
            asymmetric += product != M::modulate(in<M>(b), in<M>(a));
            outside += product < in<M>(0) || product > in<M>(255);
            not_nearest += out<M>(product) != mul_rn(a, b);
        }
    CHECK(asymmetric == 0);
    CHECK(outside == 0);
    CHECK(not_nearest == 0);
}

TEMPLATE_TEST_CASE("filtering with fraction 0 gives the first texel exactly", "[law]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    int wrong = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b)
            wrong += M::filter(in<M>(a), in<M>(b), in<M>(b), in<M>(255 - b), Real{0}, Real{0}) !=
                     in<M>(a);
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("filtering four equal texels shows that texel", "[law]", Ideal64, Float32, Gl13,
                   Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    for (const double a : fractions)
        for (const double b : fractions)
            for (int k = 0; k < 256; ++k) {
                const auto t = in<M>(k);
                const auto filtered =
                    M::filter(t, t, t, t, static_cast<Real>(a), static_cast<Real>(b));
                if (out<M>(filtered) != k) CHECK(out<M>(filtered) == k);
            }
}

TEMPLATE_TEST_CASE("a filtered texel lies within the range of its four texels", "[law]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    int outside = 0;
    for (const double a : fractions)
        for (const double b : fractions)
            for (int p = 0; p < 256; p += 5)
                for (int q = 0; q < 256; q += 3) {
                    const int lo = p < q ? p : q, hi = p < q ? q : p;
                    const int shown = out<M>(M::filter(in<M>(p), in<M>(q), in<M>(q), in<M>(p),
                                                       static_cast<Real>(a), static_cast<Real>(b)));
                    outside += shown < lo || shown > hi;
                }
    CHECK(outside == 0);
    for (const double a : fractions) {
        const auto w = in<M>(255);
        const auto f = static_cast<Real>(a);
        CHECK_FALSE(M::filter(w, w, w, w, f, f) > w);
    }
}

TEMPLATE_TEST_CASE("C02 scale by 2 and 4 saturates after the scale", "[hard][C02]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    for (int k = 0; k < 256; ++k)
        for (const int factor : {1, 2, 4}) {
            const int expected = factor * k < 255 ? factor * k : 255;
            CHECK(out<M>(M::scale(in<M>(k), factor)) == expected);
        }
    CHECK(out<M>(M::scale(in<M>(100), 4)) == 255);
    CHECK(out<M>(M::scale(in<M>(200), 2)) == 255);
}

TEMPLATE_TEST_CASE("a vertex colour k/255 comes back as k in all four channels", "[law]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    for (int k = 0; k < 256; ++k) {
        const auto w = M::Vertex::from_double(k / 255.0);
        for (const auto c : M::vertex_color({w, w, w, w})) CHECK(out<M>(c) == k);
    }
}

TEMPLATE_TEST_CASE("a vertex colour outside 0..1 becomes the nearer end", "[law]", Ideal64, Float32,
                   Gl13, Nv17) {
    using M = TestType;
    const auto color_of = [](double x) {
        const auto w = M::Vertex::from_double(x);
        return M::vertex_color({w, w, w, w});
    };
    for (const double x : {-1e30, -1.0, -1e-3, -0.0})
        for (const auto c : color_of(x)) CHECK(out<M>(c) == 0);
    for (const double x : {1.0, 1.001, 2.0, 1e30})
        for (const auto c : color_of(x)) CHECK(out<M>(c) == 255);
}

TEMPLATE_TEST_CASE("iterating a constant colour keeps it exactly", "[law]", Ideal64, Float32, Gl13,
                   Nv17) {
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
            if (M::iterate_color({edge, {w, w, w}}, c, c, c) != c) FAIL_CHECK("equal w, " << k);
            if (M::iterate_color({edge, {w, v, w}}, c, c, c) != c) FAIL_CHECK("perspective, " << k);
        }
    }
}

TEMPLATE_TEST_CASE("the colour iterator gives each vertex its colour and stays between", "[law]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    const auto a = in<M>(13), b = in<M>(200), c = in<M>(77);
    for (const Real w : {Real{1}, Real{5}}) {
        CHECK(out<M>(M::iterate_color({{9, 0, 0}, {Real{1}, w, Real{1}}}, a, b, c)) == 13);
        CHECK(out<M>(M::iterate_color({{0, 9, 0}, {Real{1}, w, Real{1}}}, a, b, c)) == 200);
        CHECK(out<M>(M::iterate_color({{0, 0, 9}, {Real{1}, w, Real{1}}}, a, b, c)) == 77);
    }
    int outside = 0;
    for (std::int64_t x = 0; x <= 40; ++x)
        for (std::int64_t y = 0; x + y <= 40; ++y)
            for (const Real w : {Real{1}, Real{1} / Real{3}, Real{7}}) {
                const int k =
                    out<M>(M::iterate_color({{x, y, 40 - x - y}, {Real{1}, w, Real{1}}}, a, b, c));
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
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    const auto one = M::pixel(1.0), zero = M::pixel(0.0);
    int wrong = 0;
    for (int s = 0; s < 256; ++s)
        for (int d = 0; d < 256; ++d) {
            wrong += M::blend(pixel_of<M>(s), one, pixel_of<M>(d), zero) != pixel_of<M>(s);
            wrong += M::blend(pixel_of<M>(s), zero, pixel_of<M>(d), one) != pixel_of<M>(d);
        }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("C06 adding in the framebuffer saturates at 255", "[hard][C06]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    const auto one = M::pixel(1.0);
    for (int s = 0; s < 256; ++s)
        for (int d = 0; d < 256; d += 5) {
            const int expected = s + d < 255 ? s + d : 255;
            CHECK(M::to_unorm8(M::blend(pixel_of<M>(s), one, pixel_of<M>(d), one)) == expected);
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
    CHECK(depth_rounded(1e300, 24) == last);
    CHECK(depth_cut(1e300, 24) == last);
}
