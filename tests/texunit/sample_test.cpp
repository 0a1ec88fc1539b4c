#include "texunit/sample.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "texunit/paraboloid.hpp"
#include "texunit/presets.hpp"

namespace {
using namespace twofold;

constexpr std::array all_wraps{Wrap::repeat, Wrap::clamp, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border};

/// A texture whose red channel holds `reds` (bottom row first); the other channels are 255.
Texture red_texture(int width, int height, const std::vector<int>& reds) {
    std::vector<Rgba8> texels;
    for (const int r : reds) texels.push_back({static_cast<std::uint8_t>(r), 255, 255, 255});
    return {width, height, texels};
}

TextureUnitState unit_with(Wrap wrap, Filter filter) {
    TextureUnitState unit;
    unit.wrap_s = unit.wrap_t = wrap;
    unit.filter = filter;
    return unit;
}

/// The byte shown for the red channel of a sample at (s, t, q); the border is 77.
template <NumericModel M>
int red_at(const UploadedTexture<M>& texture, const TextureUnitState& unit, double s, double t,
           double q = 1.0) {
    using Real = typename M::Real;
    const auto border = M::texel(Rgba8{77, 77, 77, 77});
    return M::to_unorm8(M::finish(
        sample<M>(texture, unit, {static_cast<Real>(s), static_cast<Real>(t), static_cast<Real>(q)},
                  border)[0]));
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEMPLATE_TEST_CASE("T02 a coordinate with q = 0 is 0, whatever stands above", "[hard][T02]", float,
                   double) {
    using Real = TestType;
    const auto at = [](double s, double q) {
        return texel_coordinate(static_cast<Real>(s), static_cast<Real>(q), 64);
    };
    for (const double q : {0.0, -0.0})
        for (const double s : {0.0, -0.0, 0.5, -3.0, infinity, not_a_number}) CHECK(at(s, q) == 0);
}

TEMPLATE_TEST_CASE("T02 the opposite poles of both paraboloid maps read the texel at 0",
                   "[hard][T02]", Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    const auto texture = upload<M>(red_texture(2, 2, {10, 20, 30, 40}));
    for (const Face face : {Face::front, Face::back}) {
        const Vec4 pole{0.0, 0.0, face == Face::front ? -1.0 : 1.0, 1.0};
        const Vec4 st = paraboloid_matrix(face, 1.0) * pole;
        REQUIRE(st.w == 0.0);
        for (const double q : {0.0, -0.0})
            CHECK(red_at(texture, unit_with(Wrap::clamp_to_edge, Filter::nearest), st.x, st.y, q) ==
                  10);
    }
}

TEMPLATE_TEST_CASE("T03 coordinates stop at the farthest texel however small q is", "[hard][T03]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    const auto texture = upload<M>(red_texture(4, 1, {1, 2, 3, 4}));
    for (int k = 0; k <= 149; ++k) {
        const double q = std::ldexp(1.0, -k);
        const auto u = texel_coordinate(Real{1}, static_cast<Real>(q), 4);
        CHECK(static_cast<double>(u) == std::min(4.0 / q, 32768.0));
        CHECK(texel_coordinate(Real{-1}, static_cast<Real>(q), 4) == -u);
        CHECK(red_at(texture, unit_with(Wrap::clamp_to_edge, Filter::linear), 1.0, 0.0, q) == 4);
        CHECK(red_at(texture, unit_with(Wrap::clamp_to_edge, Filter::linear), -1.0, 0.0, q) == 1);
        CHECK(red_at(texture, unit_with(Wrap::clamp_to_border, Filter::linear), -1.0, 0.5, q) ==
              77);
        CHECK(red_at(texture, unit_with(Wrap::repeat, Filter::nearest), 1.0, 0.0, q) == 1);
    }
}

TEMPLATE_TEST_CASE("T04 a negative q divides like any other", "[hard][T04]", Ideal64, Float32, Gl13,
                   Nv17) {
    using M = TestType;
    const auto texture = upload<M>(red_texture(4, 1, {1, 2, 3, 4}));
    const auto unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    for (const double q : {-1e-8, -0.5, -1.0})
        for (const double s : {-2.0, 0.1, 0.3, 0.6, 0.9})
            CHECK(red_at(texture, unit, s * q, 0.5 * q, q) == red_at(texture, unit, s, 0.5));
}

TEMPLATE_TEST_CASE("T05 coordinates far outside, infinite or NaN read a texel or the border",
                   "[hard][T05]", Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    const auto texture = upload<M>(red_texture(3, 1, {1, 2, 3}));
    const auto red = [&](Wrap wrap, Filter filter, double s) {
        return red_at(texture, unit_with(wrap, filter), s, 0.5);
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

TEMPLATE_TEST_CASE("T06 the wrap modes differ at the rim as the text of OpenGL says", "[hard][T06]",
                   float, double) {
    using Real = TestType;
    struct Row {
        Wrap wrap;
        int where;  ///< of s: 0, 1/2N, 1 - 1/2N, 1
        int i0, i1;
        double fraction;
        int nearest;
    };
    constexpr int border = -1;
    for (const int n : {1, 2, 4, 64}) {
        const int last = n - 1, second = n > 1 ? 1 : 0;
        const int past = border;  // the neighbour behind the last texel
        const std::vector<Row> rows{
            {Wrap::repeat, 0, last, 0, 0.5, 0},
            {Wrap::repeat, 1, 0, second, 0.0, 0},
            {Wrap::repeat, 2, last, 0, 0.0, last},
            {Wrap::repeat, 3, last, 0, 0.5, 0},
            {Wrap::clamp, 0, border, 0, 0.5, 0},
            {Wrap::clamp, 1, 0, n > 1 ? 1 : past, 0.0, 0},
            {Wrap::clamp, 2, last, past, 0.0, last},
            {Wrap::clamp, 3, last, border, 0.5, last},
            {Wrap::clamp_to_edge, 0, 0, second, 0.0, 0},
            {Wrap::clamp_to_edge, 1, 0, second, 0.0, 0},
            {Wrap::clamp_to_edge, 2, last, last, 0.0, last},
            {Wrap::clamp_to_edge, 3, last, last, 0.0, last},
            {Wrap::clamp_to_border, 0, border, 0, 0.5, 0},
            {Wrap::clamp_to_border, 1, 0, n > 1 ? 1 : past, 0.0, 0},
            {Wrap::clamp_to_border, 2, last, past, 0.0, last},
            {Wrap::clamp_to_border, 3, last, border, 0.5, border},
        };
        const std::array<double, 4> us{0.0, 0.5, n - 0.5, 1.0 * n};
        for (const Row& row : rows) {
            CAPTURE(n, static_cast<int>(row.wrap), row.where);
            const auto u = static_cast<Real>(us[static_cast<std::size_t>(row.where)]);
            const auto footprint = linear_footprint(u, n, row.wrap);
            CHECK(footprint.i0 == row.i0);
            CHECK(footprint.i1 == row.i1);
            CHECK(static_cast<double>(footprint.fraction) == row.fraction);
            CHECK(nearest_texel(u, n, row.wrap) == row.nearest);
        }
    }
}

TEST_CASE("T06 only clamp_to_border goes half a texel beyond the image", "[hard][T06]") {
    for (const int n : {1, 2, 4, 64}) {
        const auto edge = linear_footprint(-0.5, n, Wrap::clamp_to_border);
        CHECK(edge.i0 == -1);
        CHECK(edge.fraction == 0.0);
        CHECK(linear_footprint(-0.5, n, Wrap::clamp).fraction == 0.5);
        CHECK(linear_footprint(n + 0.5, n, Wrap::clamp_to_border).i0 == -1);
        CHECK(nearest_texel(-1e-9, n, Wrap::clamp_to_border) == -1);
        CHECK(nearest_texel(-1e-9, n, Wrap::clamp) == 0);
    }
}

TEMPLATE_TEST_CASE("T07 a texel's centre gives the texel", "[hard][T07]", Ideal64, Float32, Gl13,
                   Nv17) {
    using M = TestType;
    const std::vector<int> reds{0, 1, 127, 254, 255, 0, 1, 127, 254, 255, 0, 1, 127, 254, 255, 0};
    const auto texture = upload<M>(red_texture(4, 4, reds));
    for (const Wrap wrap : all_wraps)
        for (const Filter filter : {Filter::nearest, Filter::linear})
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    CHECK(red_at(texture, unit_with(wrap, filter), (i + 0.5) / 4, (j + 0.5) / 4) ==
                          reds[static_cast<std::size_t>(4 * j + i)]);
}

TEMPLATE_TEST_CASE("T07 a texel's edge gives the mean with the preset's rounding", "[hard][T07]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    constexpr bool by_stages = M::preset == Preset::nv17;  // s first, rounded, then t
    const auto half_up = [](int a, int b) { return (a + b + 1) >> 1; };
    const std::array values{0, 1, 127, 254, 255};
    for (const int a : values)
        for (const int b : values)
            for (const int c : values)
                for (const int d : values) {
                    const auto texture = upload<M>(red_texture(2, 2, {a, b, c, d}));
                    const auto unit = unit_with(Wrap::clamp_to_edge, Filter::linear);
                    const int mean = by_stages ? half_up(half_up(a, b), half_up(c, d))
                                               : (a + b + c + d + 2) >> 2;
                    // Exactly half-way reals may fall to either side by one rounding of k/255.
                    const bool tie = !by_stages && (a + b + c + d) % 4 == 2;
                    const int red = red_at(texture, unit, 0.5, 0.5);
                    if (red != mean && !(tie && red == mean - 1)) CHECK(red == mean);
                }
}

TEST_CASE("T08 the filter weight is floor(256 f) and never 256", "[hard][T08]") {
    for (int k = 254 * 256; k < 65536; ++k)
        CHECK(Nv17::filter(0, 255, 0, 255, k / 65536.0, 0.0) == flerp(0, 255, k / 256));
    CHECK(Nv17::filter(0, 255, 0, 255, 1.0 - 0x1p-53, 0.0) == 254);
}

TEST_CASE("T08 a fraction that rounds to 1 keeps the weight 255", "[hard][T08]") {
    const double below_centre = std::nextafter(0.5, 0.0);  // u - 1/2 = -2^-54, fraction 1 - 2^-54
    const auto texture = upload<Nv17>(red_texture(1, 1, {255}));
    const auto unit = unit_with(Wrap::clamp_to_border, Filter::linear);
    CHECK(red_at(texture, unit, below_centre, 0.5) == flerp(77, 255, 255));
    CHECK(red_at(texture, unit, 0.5, below_centre) == flerp(77, 255, 255));
}

TEMPLATE_TEST_CASE("T09 a texture of one texel is a constant inside the image", "[hard][T09]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    const auto texture = upload<M>(red_texture(1, 1, {123}));
    for (const Filter filter : {Filter::nearest, Filter::linear})
        for (const double s : {-7.3, -1.0, -0.25, 0.0, 0.1, 0.5, 0.9, 1.0, 1.5, 1e30})
            for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge})
                CHECK(red_at(texture, unit_with(wrap, filter), s, s) == 123);
    for (const double s : {0.0, 0.25, 0.999})
        for (const Wrap wrap : all_wraps)
            CHECK(red_at(texture, unit_with(wrap, Filter::nearest), s, s) == 123);
}

TEMPLATE_TEST_CASE("T09 sizes need not be powers of two or square", "[hard][T09]", Ideal64, Float32,
                   Gl13, Nv17) {
    using M = TestType;
    struct Size {
        int width, height;
    };
    for (const auto [w, h] : {Size{1, 7}, Size{7, 1}, Size{1000, 500}, Size{3, 5}}) {
        std::vector<int> reds;
        for (int i = 0; i < w * h; ++i) reds.push_back(i * 37 % 256);
        const auto texture = upload<M>(red_texture(w, h, reds));
        int wrong = 0;
        for (int j = 0; j < h; ++j)
            for (int i = 0; i < w; ++i) {
                const int red = reds[static_cast<std::size_t>(j * w + i)];
                const double s = (i + 0.5) / w, t = (j + 0.5) / h;
                for (const Wrap wrap : all_wraps)
                    wrong += red_at(texture, unit_with(wrap, Filter::nearest), s, t) != red;
                const auto repeat = unit_with(Wrap::repeat, Filter::nearest);
                wrong += red_at(texture, repeat, s + 3.0, t - 2.0) != red;
            }
        CHECK(wrong == 0);
    }
}

TEMPLATE_TEST_CASE("T09 every coordinate names a texel or the border", "[hard][T09]", float,
                   double) {
    using Real = TestType;
    int outside = 0;
    for (const int n : {1, 2, 3, 64, 1000})
        for (const Wrap wrap : all_wraps)
            for (int k = -4000; k <= 4000; ++k)
                for (const double nudge : {0.0, 1e-7, -1e-7, 1e-20, -1e-20}) {
                    const auto u = static_cast<Real>(k * n * 0.001 + nudge);
                    const auto f = linear_footprint(u, n, wrap);
                    const int i = nearest_texel(u, n, wrap);
                    const int least = wrap == Wrap::repeat || wrap == Wrap::clamp_to_edge ? 0 : -1;
                    outside += f.i0 < least || f.i0 >= n || f.i1 < least || f.i1 >= n;
                    outside += i < least || i >= n;
                    outside += !(f.fraction >= Real{0} && f.fraction <= Real{1});
                }
    CHECK(outside == 0);
}

TEMPLATE_TEST_CASE("T12 minification without mipmaps aliases: 16:1 on a checkerboard",
                   "[hard][T12]", Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    std::vector<int> reds;
    for (int i = 0; i < 512 * 512; ++i) reds.push_back((i % 512 + i / 512) % 2 == 0 ? 255 : 0);
    const auto texture = upload<M>(red_texture(512, 512, reds));
    std::set<int> nearest, linear;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double s = (x + 0.5) / 32, t = (y + 0.5) / 32;
            nearest.insert(red_at(texture, unit_with(Wrap::repeat, Filter::nearest), s, t));
            linear.insert(red_at(texture, unit_with(Wrap::repeat, Filter::linear), s, t));
        }
    CHECK(nearest == std::set<int>{255});  // every centre falls on a white texel's corner
    CHECK(linear == std::set<int>{128});   // and half-way between four texels
}

TEMPLATE_TEST_CASE("T01 along the seam both maps agree, for +0 and -0, and both are opaque",
                   "[hard][T01]", Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    using Real = typename M::Real;
    constexpr int size = 32;
    constexpr double guard = 0.875;
    std::vector<int> alpha;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            alpha.push_back(texel_is_opaque(x, y, size, guard) ? 255 : 0);
    const auto texture = upload<M>(red_texture(size, size, alpha));
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
                    holes += red_at(texture, unit_with(Wrap::clamp_to_edge, filter), at.x, at.y,
                                    at.w) != 255;
            }
        }
        apart += places.size() != 1;
    }
    CHECK(holes == 0);
    CHECK(apart == 0);
    CHECK(not_front == 0);
}

TEMPLATE_TEST_CASE("uploading keeps rows and channels in place", "[sample]", Ideal64, Float32, Gl13,
                   Nv17) {
    using M = TestType;
    const auto texture = upload<M>({2, 1, std::vector<Rgba8>{{1, 2, 3, 4}, {250, 251, 252, 253}}});
    REQUIRE(texture.texels.size() == 2);
    for (std::size_t c = 0; c < 4; ++c) {
        CHECK(M::to_unorm8(M::finish(texture.texels[0][c])) == 1 + static_cast<int>(c));
        CHECK(M::to_unorm8(M::finish(texture.texels[1][c])) == 250 + static_cast<int>(c));
    }
}

TEST_CASE("a float texture above 1 is kept by the float presets and cut by the 8-bit ones",
          "[sample]") {
    const Rgba32f bright{2.0f, 0.3f, -1.0f, 1.0f};
    CHECK(Ideal64::texel(bright)[0] == 2.0);
    CHECK(Float32::texel(bright)[1] == 0.3f);
    CHECK(Gl13::texel(bright)[0] == 1.0);
    CHECK(Gl13::texel(bright)[2] == 0.0);
    CHECK(Nv17::texel(bright) == Color<int>{255, 77, 0, 255});
}
