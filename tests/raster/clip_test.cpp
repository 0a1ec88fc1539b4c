#include "raster/clip.hpp"

#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <limits>

#include "raster/project.hpp"
#include "raster/transform.hpp"
#include "texunit/ideal64.hpp"
#include "texunit/random.hpp"

namespace {
using namespace twofold;

const Viewport view = viewport_of(64, 64, Ideal64{}.snap());

ClipVertex vertex(double x, double y, double z, double w) {
    ClipVertex v{};
    v.clip = {x, y, z, w};
    v.color = {x, y, z, w};
    return v;
}

ClippedPolygon clipped(Vec4 a, Vec4 b, Vec4 c) {
    return clip(
        {vertex(a.x, a.y, a.z, a.w), vertex(b.x, b.y, b.z, b.w), vertex(c.x, c.y, c.z, c.w)}, view,
        {64, 64});
}

/// What later stages rely on: w > 0, depth in 0..1 and a place within the guard band, up to
/// rounding.
bool keeps_its_promise(const ClippedPolygon& p) {
    const auto within = [](double x, double lo, double hi) {
        const double slack = 1e-12 * (hi - lo);
        return x >= lo - slack && x <= hi + slack;
    };
    for (std::size_t k = 0; k < p.size; ++k) {
        const Vec4& c = p.vertices[k].clip;
        if (!(c.w > 0.0 && within(c.x / c.w + view.offset.x, -guard_band, guard_band) &&
              within(c.y / c.w + view.offset.y, -guard_band, guard_band) &&
              within(c.z / c.w + view.offset.z, 0.0, 1.0)))
            return false;
    }
    return p.size <= p.vertices.size();
}
}  // namespace

TEST_CASE("a triangle within all planes is returned as it is", "[clip]") {
    const auto p = clipped({0, 0, 0, 1}, {20, 0, 0.25, 1}, {0, 20, -0.25, 1});
    CHECK(p.result == ClipResult::inside);
    REQUIRE(p.size == 3);
    CHECK(p.vertices[1].clip == Vec4{20, 0, 0.25, 1});
}

TEST_CASE("R09 a triangle beyond one plane or one side is rejected", "[hard][R09]") {
    CHECK(clipped({0, 0, -0.6, 1}, {9, 0, -0.7, 1}, {0, 9, -2, 1}).result == ClipResult::rejected);
    CHECK(clipped({0, 0, 0.6, 1}, {9, 0, 0.7, 1}, {0, 9, 2, 1}).result == ClipResult::rejected);
    CHECK(clipped({40, 0, 0, 1}, {50, 0, 0, 1}, {40, 9, 0, 1}).result == ClipResult::rejected);
    CHECK(clipped({-40, 0, 0, 1}, {-50, 0, 0, 1}, {-40, 9, 0, 1}).result == ClipResult::rejected);
    CHECK(clipped({0, 40, 0, 1}, {0, 50, 0, 1}, {9, 40, 0, 1}).result == ClipResult::rejected);
    CHECK(clipped({0, -40, 0, 1}, {0, -50, 0, 1}, {9, -40, 0, 1}).result == ClipResult::rejected);
}

TEST_CASE("R07 vertices with w = 0 are cut away before the division", "[hard][R07]") {
    std::feclearexcept(FE_ALL_EXCEPT);
    const Vec4 a{-20, -20, 0, 1}, b{20, -20, 0, 1}, c{0, 20, 0, 1};
    const Vec4 a0{-20, -20, 0, 0}, b0{20, -20, 0, 0}, c0{0, 20, 0, 0};
    for (const auto& p : {clipped(a, b, c0), clipped(a, b0, c0), clipped(a0, b, c)}) {
        CHECK(p.result == ClipResult::cut);
        CHECK(p.size >= 3);
        CHECK(keeps_its_promise(p));
        for (std::size_t k = 0; k < p.size; ++k) project(Ideal64{}, p.vertices[k], view, true);
    }
    CHECK(clipped(a0, b0, c0).result == ClipResult::rejected);
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID) == 0);
}

TEST_CASE("R08 vertices with w < 0 are cut away and three of them draw nothing", "[hard][R08]") {
    const Vec4 a{-20, -20, 0, 1}, b{20, -20, 0, 1}, c{0, 20, 0, 1};
    CHECK(keeps_its_promise(clipped(a, b, -c)));
    CHECK(clipped(a, b, -c).result == ClipResult::cut);
    CHECK(keeps_its_promise(clipped(a, -b, -c)));
    CHECK(clipped(-a, -b, -c).result == ClipResult::rejected);
}

TEST_CASE("R08 two triangles get the same new vertex on the edge they share", "[hard][R08]") {
    for (std::uint64_t i = 0; i < 500; ++i) {
        const auto draw = [&](std::uint64_t k) { return 2 * random_unit(5, 20 * i + k) - 1; };
        const Vec4 a{30 * draw(0), 30 * draw(1), 0.1 * draw(2), 1.0};
        const Vec4 b{30 * draw(3), 30 * draw(4), draw(5), draw(6)};
        const auto one = clipped(a, b, {-20, 20, 0, 1}), two = clipped(b, a, {25, -20, 0, 1});
        if (one.result != ClipResult::cut || two.result != ClipResult::cut) continue;
        // The corners of both polygons that lie on the line a b: a's side of the cut.
        int shared = 0, alike = 0;
        for (std::size_t j = 0; j < one.size; ++j)
            for (std::size_t k = 0; k < two.size; ++k) {
                if (one.vertices[j].clip != two.vertices[k].clip) continue;
                ++shared;
                alike += one.vertices[j].color == two.vertices[k].color;
            }
        CHECK(shared >= 2);
        CHECK(alike == shared);
    }
}

TEST_CASE("R13 R14 R15 vertices that are huge, NaN or infinite make the triangle unusable",
          "[hard][R13][R14][R15]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {1e30, -1e30, infinity, -infinity, nan, -nan})
        for (int component = 0; component < 4; ++component)
            for (int corner = 0; corner < 3; ++corner) {
                std::array<Vec4, 3> v{Vec4{0, 0, 0, 1}, {9, 0, 0, 1}, {0, 9, 0, 1}};
                v[static_cast<std::size_t>(corner)][component] = bad;
                const auto p = clipped(v[0], v[1], v[2]);
                CHECK(p.result == ClipResult::not_finite);
                CHECK(p.size == 0);
            }
    CHECK(clipped({-largest_clip_coordinate, 0, 0, 1}, {9, 0, 0, 1}, {0, 9, 0, 1}).result ==
          ClipResult::cut);
}

TEST_CASE("R10 the guard band is 2^15 pixels, beyond which a triangle is cut", "[hard][R10]") {
    const double to_band = guard_band - view.offset.x, step = 1.0 / 16;
    CHECK(clipped({0, 0, 0, 1}, {to_band, 0, 0, 1}, {0, to_band, 0, 1}).result ==
          ClipResult::inside);
    const auto p = clipped({0, 0, 0, 1}, {to_band + step, 0, 0, 1}, {0, 9, 0, 1});
    CHECK(p.result == ClipResult::cut);
    CHECK(p.size == 4);
    CHECK(keeps_its_promise(p));
    const auto q =
        clipped({0, 0, 0, 1}, {-guard_band - view.offset.x - step, 0, 0, 1}, {0, 9, 0, 1});
    CHECK(q.result == ClipResult::cut);
}

TEST_CASE("attributes are cut with the same fraction as places", "[clip]") {
    const auto p = clipped({0, 0, 0, 1}, {20, 0, 2, 1}, {0, 20, 0, 1});
    CHECK(p.result == ClipResult::cut);
    for (std::size_t k = 0; k < p.size; ++k)
        for (int i = 0; i < 4; ++i)
            CHECK(p.vertices[k].color[i] == Approx(p.vertices[k].clip[i]).margin(1e-12));
}

TEST_CASE("a clipped polygon has places that can be snapped, however degenerate the triangle",
          "[clip]") {
    // Coordinates at which many planes, or several at once, are met exactly or nearly, and ends so
    // far apart that a careless intersection leaves w negative or more corners than ten.
    const std::array<double, 12> places{0.0,  1.0,   -1.0,    0.5,      -0.5, 0x1p-30,
                                        32.0, -32.0, 32736.0, -32800.0, 1e9,  -0x1p-31};
    int broken = 0;
    std::size_t largest = 0;
    for (std::uint64_t i = 0; i < 300000; ++i) {
        std::array<Vec4, 3> v;
        for (std::uint64_t k = 0; k < 12; ++k) {
            const std::uint64_t r = random_u64(77, 12 * i + k);
            const double ulps = (r >> 8) % 3 == 0 ? static_cast<double>(r >> 60) : 0.0;
            const double huge = (r >> 16) % 8 == 0 ? -1e9 : 1.0;
            v[k / 4][static_cast<int>(k % 4)] = places[r % 12] * huge * (1.0 + 0x1p-52 * ulps);
        }
        if (i % 3 == 0) v[2] = v[0] + 0.3 * (v[1] - v[0]);  // collinear
        const auto p = clipped(v[0], v[1], v[2]);
        broken += !keeps_its_promise(p);
        largest = std::max(largest, p.size);
    }
    CHECK(broken == 0);
    CHECK(largest <= 10);
}

TEST_CASE("a clipped polygon of ordinary size lies within depth 0..1 and the guard band",
          "[clip]") {
    int broken = 0, cut = 0;
    for (std::uint64_t i = 0; i < 100000; ++i) {
        std::array<Vec4, 3> v;
        for (std::uint64_t k = 0; k < 12; ++k)
            v[k / 4][static_cast<int>(k % 4)] =
                (k % 4 < 2 ? 200.0 : 4.0) * (random_unit(78, 12 * i + k) - 0.5);
        const auto p = clipped(v[0], v[1], v[2]);
        cut += p.result == ClipResult::cut;
        broken += !keeps_its_promise(p);
    }
    CHECK(broken == 0);
    CHECK(cut > 30000);
}
