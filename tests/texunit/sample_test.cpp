#include "texunit/sample.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "sample_builders.hpp"
#include "texunit/paraboloid.hpp"

using namespace twofold;

TEMPLATE_LIST_TEST_CASE("T02 the opposite poles of both paraboloid maps read the texel at 0",
                        "[hard][T02]", AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(2, 2, {10, 20, 30, 40}));
    for (const Face face : {Face::front, Face::back}) {
        const Vec4 pole{0.0, 0.0, face == Face::front ? -1.0 : 1.0, 1.0};
        const Vec4 st = paraboloid_matrix(face, 1.0) * pole;
        REQUIRE(st.w == 0.0);
        for (const double q : {0.0, -0.0})
            CHECK(red_at(m, texture, unit_with(Wrap::clamp_to_edge, Filter::nearest), st.x, st.y,
                         q) == 10);
    }
}

TEMPLATE_LIST_TEST_CASE("T03 coordinates stop at the farthest texel however small q is",
                        "[hard][T03]", AllModels) {
    using M = TestType;
    const M m{};
    using Real = typename M::Real;
    const auto texture = upload(m, red_texture(4, 1, {1, 2, 3, 4}));
    for (int k = 0; k <= 149; ++k) {
        const double q = std::ldexp(1.0, -k);
        const auto u = texel_coordinate(Real{1}, static_cast<Real>(q), 4);
        CHECK(static_cast<double>(u) == std::min(4.0 / q, 32768.0));
        CHECK(texel_coordinate(Real{-1}, static_cast<Real>(q), 4) == -u);
        CHECK(red_at(m, texture, unit_with(Wrap::clamp_to_edge, Filter::linear), 1.0, 0.0, q) == 4);
        CHECK(red_at(m, texture, unit_with(Wrap::clamp_to_edge, Filter::linear), -1.0, 0.0, q) ==
              1);
        CHECK(red_at(m, texture, unit_with(Wrap::clamp_to_border, Filter::linear), -1.0, 0.5, q) ==
              77);
        CHECK(red_at(m, texture, unit_with(Wrap::repeat, Filter::nearest), 1.0, 0.0, q) == 1);
    }
}

TEMPLATE_LIST_TEST_CASE("T04 a negative q divides like any other", "[hard][T04]", AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(4, 1, {1, 2, 3, 4}));
    const auto unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    for (const double q : {-1e-8, -0.5, -1.0})
        for (const double s : {-2.0, 0.1, 0.3, 0.6, 0.9})
            CHECK(red_at(m, texture, unit, s * q, 0.5 * q, q) == red_at(m, texture, unit, s, 0.5));
}

TEMPLATE_LIST_TEST_CASE("T05 coordinates far outside, infinite or NaN read a texel or the border",
                        "[hard][T05]", AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(3, 1, {1, 2, 3}));
    const auto red = [&](Wrap wrap, Filter filter, double s) {
        return red_at(m, texture, unit_with(wrap, filter), s, 0.5);
    };
    for (const Filter filter : {Filter::nearest, Filter::linear})
        for (const double s : {1e30, infinity}) {
            CHECK(red(Wrap::clamp_to_edge, filter, s) == 3);
            CHECK(red(Wrap::clamp_to_edge, filter, -s) == 1);
            CHECK(red(Wrap::clamp_to_border, filter, s) == 77);
            CHECK(red(Wrap::clamp_to_border, filter, -s) == 77);
        }
    CHECK(red(Wrap::clamp, Filter::nearest, 1e30) == 3);
    CHECK(red(Wrap::clamp, Filter::linear, 1e30) == 40);   // half texel 3, half border 77
    CHECK(red(Wrap::repeat, Filter::nearest, 1e30) == 3);  // 2^15 = 3 x 10922 + 2
    CHECK(red(Wrap::repeat, Filter::nearest, -1e30) == 2);
    for (const Wrap wrap : all_wraps) CHECK(red(wrap, Filter::nearest, not_a_number) == 1);
}

TEMPLATE_LIST_TEST_CASE("T07 a texel's centre gives the texel", "[hard][T07]", AllModels) {
    using M = TestType;
    const M m{};
    const std::vector<int> reds{0, 1, 127, 254, 255, 0, 1, 127, 254, 255, 0, 1, 127, 254, 255, 0};
    const auto texture = upload(m, red_texture(4, 4, reds));
    for (const Wrap wrap : all_wraps)
        for (const Filter filter : {Filter::nearest, Filter::linear})
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    CHECK(red_at(m, texture, unit_with(wrap, filter), (i + 0.5) / 4,
                                 (j + 0.5) / 4) == reds[static_cast<std::size_t>(4 * j + i)]);
}

namespace {
/// The mean of a row of two texels and the row above it, rounded as the model does.
template <NumericModel M>
int mean_of_four(int a, int b, int c, int d) {
    const auto half_up = [](int p, int q) { return (p + q + 1) >> 1; };
    if constexpr (M::preset == Preset::coarse8) return (a + b + c + d) >> 2;
    if constexpr (M::is_integer) return half_up(half_up(a, b), half_up(c, d));
    return (a + b + c + d + 2) >> 2;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("T07 a texel's edge gives the mean with the preset's rounding",
                        "[hard][T07]", AllModels) {
    using M = TestType;
    const M m{};
    const std::array values{0, 1, 127, 254, 255};
    for (const int a : values)
        for (const int b : values)
            for (const int c : values)
                for (const int d : values) {
                    const auto texture = upload(m, red_texture(2, 2, {a, b, c, d}));
                    const auto unit = unit_with(Wrap::clamp_to_edge, Filter::linear);
                    const int mean = mean_of_four<M>(a, b, c, d);
                    // Exactly half-way reals may fall to either side by one rounding of k/255.
                    const bool tie = !M::is_integer && (a + b + c + d) % 4 == 2;
                    const int red = red_at(m, texture, unit, 0.5, 0.5);
                    if (red != mean && !(tie && red == mean - 1)) CHECK(red == mean);
                }
}

TEST_CASE("T08 the filter weight is floor(256 f) and never 256", "[hard][T08]") {
    const Nv17 m{};
    for (int k = 254 * 256; k < 65536; ++k)
        CHECK(m.filter(0, 255, 0, 255, k / 65536.0, 0.0) == flerp(0, 255, k / 256));
    CHECK(m.filter(0, 255, 0, 255, 1.0 - 0x1p-53, 0.0) == 254);
}

TEST_CASE("T08 a fraction that rounds to 1 keeps the weight 255", "[hard][T08]") {
    const Nv17 m{};
    const double below_centre = std::nextafter(0.5, 0.0);  // u - 1/2 = -2^-54, fraction 1 - 2^-54
    const auto texture = upload(m, red_texture(1, 1, {255}));
    const auto unit = unit_with(Wrap::clamp_to_border, Filter::linear);
    CHECK(red_at(m, texture, unit, below_centre, 0.5) == flerp(77, 255, 255));
    CHECK(red_at(m, texture, unit, 0.5, below_centre) == flerp(77, 255, 255));
}

TEMPLATE_LIST_TEST_CASE("T09 a texture of one texel is a constant inside the image", "[hard][T09]",
                        AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(1, 1, {123}));
    for (const Filter filter : {Filter::nearest, Filter::linear})
        for (const double s : {-7.3, -1.0, -0.25, 0.0, 0.1, 0.5, 0.9, 1.0, 1.5, 1e30})
            for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
                CHECK(red_at(m, texture, unit_with(wrap, filter), s, s) == 123);
    for (const double s : {0.0, 0.25, 0.999})
        for (const Wrap wrap : all_wraps)
            CHECK(red_at(m, texture, unit_with(wrap, Filter::nearest), s, s) == 123);
}

TEMPLATE_LIST_TEST_CASE("T09 sizes need not be powers of two or square", "[hard][T09]", AllModels) {
    using M = TestType;
    const M m{};
    struct Size {
        int width, height;
    };
    for (const auto [w, h] : {Size{1, 7}, Size{7, 1}, Size{1000, 500}, Size{3, 5}}) {
        std::vector<int> reds;
        for (int i = 0; i < w * h; ++i) reds.push_back(i * 37 % 256);
        const auto texture = upload(m, red_texture(w, h, reds));
        int wrong = 0;
        for (int j = 0; j < h; ++j)
            for (int i = 0; i < w; ++i) {
                const int red = reds[static_cast<std::size_t>(j * w + i)];
                const double s = (i + 0.5) / w, t = (j + 0.5) / h;
                for (const Wrap wrap : all_wraps)
                    wrong += red_at(m, texture, unit_with(wrap, Filter::nearest), s, t) != red;
                const auto repeat = unit_with(Wrap::repeat, Filter::nearest);
                wrong += red_at(m, texture, repeat, s + 3.0, t - 2.0) != red;
            }
        CHECK(wrong == 0);
    }
}

TEMPLATE_LIST_TEST_CASE("T12 minification without mipmaps aliases: 16:1 on a checkerboard",
                        "[hard][T12]", AllModels) {
    using M = TestType;
    const M m{};
    std::vector<int> reds;
    for (int i = 0; i < 512 * 512; ++i) reds.push_back((i % 512 + i / 512) % 2 == 0 ? 255 : 0);
    const auto texture = upload(m, red_texture(512, 512, reds));
    std::set<int> nearest, linear;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double s = (x + 0.5) / 32, t = (y + 0.5) / 32;
            nearest.insert(red_at(m, texture, unit_with(Wrap::repeat, Filter::nearest), s, t));
            linear.insert(red_at(m, texture, unit_with(Wrap::repeat, Filter::linear), s, t));
        }
    CHECK(nearest == std::set<int>{255});  // every centre falls on a white texel's corner
    const int grey = M::preset == Preset::coarse8 ? 127 : 128;
    CHECK(linear == std::set<int>{grey});  // and half-way between four texels
}

TEMPLATE_LIST_TEST_CASE("T01 along the seam both maps agree, for +0 and -0, and both are opaque",
                        "[hard][T01]", AllModels) {
    using M = TestType;
    const M m{};
    using Real = typename M::Real;
    constexpr int size = 32;
    constexpr double guard = 0.875;
    std::vector<int> alpha;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            alpha.push_back(texel_is_opaque(x, y, size, guard) ? 255 : 0);
    const auto texture = upload(m, red_texture(size, size, alpha));
    int holes = 0, apart = 0, not_front = 0;
    for (int i = 0; i < 4096; ++i) {
        // 4,096 rational points of the unit circle, all four quadrants.
        const double h = (i % 1024) / 1024.0, c = (1 - h * h) / (1 + h * h),
                     s = 2 * h / (1 + h * h);
        const std::array<Vec2, 4> turned{Vec2{c, s}, Vec2{-s, c}, Vec2{-c, -s}, Vec2{s, -c}};
        const Vec2 xy = turned[static_cast<std::size_t>(i / 1024)];
        std::set<std::pair<double, double>> places;
        for (const double z : {0.0, -0.0}) {
            not_front += face_of({xy.x, xy.y, z}) != Face::front;
            for (const Face face : {Face::front, Face::back}) {
                const Vec4 at = paraboloid_matrix(face, guard) * Vec4{xy.x, xy.y, z, 1.0};
                const auto u =
                    texel_coordinate(static_cast<Real>(at.x), static_cast<Real>(at.w), size);
                const auto v =
                    texel_coordinate(static_cast<Real>(at.y), static_cast<Real>(at.w), size);
                places.insert({static_cast<double>(u), static_cast<double>(v)});
                for (const Filter filter : {Filter::nearest, Filter::linear})
                    holes += red_at(m, texture, unit_with(Wrap::clamp_to_edge, filter), at.x, at.y,
                                    at.w) != 255;
            }
        }
        apart += places.size() != 1;
    }
    CHECK(holes == 0);
    CHECK(apart == 0);
    CHECK(not_front == 0);
}

TEMPLATE_LIST_TEST_CASE("T11 a unit without a texture reads white from every target and filter",
                        "[hard][T11]", AllModels) {
    using M = TestType;
    const M m{};
    const auto white = white_texture(m);
    const auto one = m.texel(Rgba8{255, 255, 255, 255});
    for (const TextureTarget target :
         {TextureTarget::texture_2d, TextureTarget::rectangle, TextureTarget::cube_map})
        for (const Filter filter : {Filter::nearest, Filter::linear}) {
            auto unit = unit_with(Wrap::clamp_to_edge, filter);
            unit.target = target;
            const auto here = coordinates<typename M::Real>(0.3, -5.0, 2.0, 0.7);
            const Color<typename M::Channel> black{};
            CHECK(sample(m, white, unit, {here, here, here}, black) == one);
        }
}
