#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "sample_builders.hpp"
#include "texunit/sample.hpp"

/// Mipmaps, the choice of filters, targets and coordinates without a place.
using namespace twofold;

TEMPLATE_LIST_TEST_CASE("T12 16:1 with mipmaps shows the mean instead", "[hard][T12]", AllModels) {
    using M = TestType;
    const M m{};
    Texture checkerboard = red_texture(512, 512, {});
    auto& base = std::get<std::vector<Rgba8>>(checkerboard.texels);
    for (int i = 0; i < 512 * 512; ++i)
        base.push_back((i % 512 + i / 512) % 2 == 0 ? Rgba8{255, 0, 0, 255} : Rgba8{});
    for (int size = 256; size >= 1; size /= 2)
        checkerboard.mipmaps.push_back(
            {size, size,
             std::vector<Rgba8>(static_cast<std::size_t>(size * size), Rgba8{128, 0, 0, 255})});
    const auto texture = upload(m, checkerboard);
    REQUIRE(texture.levels.size() == 10);
    auto unit = unit_with(Wrap::repeat, Filter::nearest);
    std::set<int> reds;
    for (const MipFilter mip : {MipFilter::nearest, MipFilter::linear})
        for (int x = 0; x < 32; ++x) {
            unit.mip_filter = mip;
            const double s = (x + 0.5) / 32;
            using Real = typename M::Real;
            reds.insert(red_at(
                m, texture, unit,
                {coordinates<Real>(s, s, 0.0, 1.0), coordinates<Real>(s + 1.0 / 32, s, 0.0, 1.0),
                 coordinates<Real>(s, s + 1.0 / 32, 0.0, 1.0)}));
        }
    CHECK(reds == std::set<int>{128});
}

namespace {
/// 64 x 64 down to 1 x 1, level k of red 20 k + 10 throughout.
Texture stacked_texture() {
    Texture texture = red_texture(64, 64, std::vector<int>(64 * 64, 10));
    for (int level = 1, size = 32; size >= 1; ++level, size /= 2) {
        const Rgba8 texel{static_cast<std::uint8_t>(20 * level + 10), 255, 255, 255};
        texture.mipmaps.push_back(
            {size, size, std::vector<Rgba8>(static_cast<std::size_t>(size * size), texel)});
    }
    return texture;
}

/// A point of stacked_texture() where a pixel in x is `texels` of the base image.
template <class Real>
SamplePoint<Real> point_at_scale(double texels) {
    return {coordinates<Real>(0.5, 0.5, 0.0, 1.0),
            coordinates<Real>(0.5 + texels / 64, 0.5, 0.0, 1.0),
            coordinates<Real>(0.5, 0.5, 0.0, 1.0)};
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("a scale of 2^k reads level k alone, between them both levels blend",
                        "[sample]", AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, stacked_texture());
    auto unit = unit_with(Wrap::repeat, Filter::linear);
    unit.mip_filter = MipFilter::linear;
    const auto red = [&](double texels) {
        return red_at(m, texture, unit, point_at_scale<typename M::Real>(texels));
    };
    for (int k = 0; k <= 6; ++k) CHECK(red(std::ldexp(1.0, k)) == 20 * k + 10);
    CHECK(red(0.25) == 10);
    CHECK(red(500.0) == 130);
    for (const double lambda : {0.125, 1.5, 3.75, 5.0625}) {
        const double shown_level = M::preset == Preset::coarse8 ? std::floor(lambda) : lambda;
        const double exact = 20 * shown_level + 10, byte = red(std::exp2(lambda));
        CHECK(std::fabs(byte - exact) <= 1.0);
    }
    unit.lod_bias = 2.0;
    CHECK(red(1.0) == 50);
    unit.lod_bias = -2.0;
    CHECK(red(16.0) == 50);
}

TEST_CASE("the chips blend levels with 8 bits of the level of detail, halves up", "[sample]") {
    const Nv17 m{};
    const auto texture = upload(m, stacked_texture());
    auto unit = unit_with(Wrap::repeat, Filter::nearest);
    unit.mip_filter = MipFilter::linear;
    for (int k = 0; k < 512; ++k) {
        unit.lod_bias = 1.0 + k / 512.0;
        const int red = red_at(m, texture, unit, point_at_scale<double>(1.0));
        CHECK(red == flerp(30, 50, k / 2));
    }
}

TEMPLATE_LIST_TEST_CASE("the filters for a larger and a smaller picture are told apart", "[sample]",
                        AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(2, 1, {0, 200}));
    auto unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    unit.mag_filter = Filter::linear;
    using Real = typename M::Real;
    const auto red = [&](double texels) {
        return red_at(m, texture, unit,
                      {coordinates<Real>(0.5, 0.5, 0.0, 1.0),
                       coordinates<Real>(0.5 + texels / 2, 0.5, 0.0, 1.0),
                       coordinates<Real>(0.5, 0.5, 0.0, 1.0)});
    };
    CHECK(red(0.5) == 100);   // magnified: half-way between both
    CHECK(red(1.0) == 100);   // lambda = 0 still is
    CHECK(red(1.25) == 200);  // minified: the nearest
    CHECK(red(2.0) == 200);
}

TEMPLATE_LIST_TEST_CASE("a rectangle is addressed in texels, whatever its size", "[sample]",
                        AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(3, 2, {1, 2, 3, 4, 5, 6}));
    auto unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    unit.target = TextureTarget::rectangle;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i) {
            CHECK(red_at(m, texture, unit, i + 0.5, j + 0.5) == 3 * j + i + 1);
            CHECK(red_at(m, texture, unit, 2 * i + 1.0, 2 * j + 1.0, 2.0) == 3 * j + i + 1);
        }
    CHECK(red_at(m, texture, unit, 3.0, 2.0) == 6);
    CHECK(red_at(m, texture, unit, -1.0, -1.0) == 1);
}

TEMPLATE_LIST_TEST_CASE("without the division q does not matter, zero included", "[sample]",
                        AllModels) {
    using M = TestType;
    const M m{};
    const auto texture = upload(m, red_texture(4, 1, {1, 2, 3, 4}));
    auto unit = unit_with(Wrap::clamp_to_edge, Filter::nearest);
    unit.divide_by_q = false;
    for (const double q : {1.0, 2.0, -1.0, 0.0, not_a_number})
        for (int i = 0; i < 4; ++i) CHECK(red_at(m, texture, unit, (i + 0.5) / 4, 0.5, q) == i + 1);
}

TEMPLATE_TEST_CASE("T02 coordinates without a place are told", "[hard][T02]", float, double) {
    TextureUnitState unit;
    const auto undefined = [&](double s, double t, double r, double q) {
        return undefined_coordinates(unit, coordinates<TestType>(s, t, r, q));
    };
    CHECK_FALSE(undefined(0, 0, not_a_number, 1));
    CHECK_FALSE(undefined(infinity, 0, 0, 1));
    CHECK_FALSE(undefined(1, 1, 0, -2));
    for (const double q : {0.0, -0.0, not_a_number}) CHECK(undefined(1, 1, 1, q));
    CHECK(undefined(not_a_number, 0, 0, 1));
    CHECK(undefined(0, not_a_number, 0, 1));
    CHECK(undefined(infinity, 0, 0, infinity));
    unit.divide_by_q = false;
    for (const double q : {0.0, not_a_number}) CHECK_FALSE(undefined(1, 1, 1, q));
    CHECK(undefined(not_a_number, 0, 0, 1));
    unit.target = TextureTarget::cube_map;
    CHECK_FALSE(undefined(0, 0, 1, 0));
    CHECK(undefined(0, 0, 0, 1));
    CHECK(undefined(0, not_a_number, 1, 1));
    CHECK(undefined(infinity, infinity, 1, 1));
}

TEST_CASE("neighbours are asked for only where they decide something", "[sample]") {
    TextureUnitState unit;
    CHECK_FALSE(needs_derivatives(unit, true));
    unit.mip_filter = MipFilter::linear;
    CHECK(needs_derivatives(unit, true));
    CHECK_FALSE(needs_derivatives(unit, false));
    unit.target = TextureTarget::cube_map;
    CHECK(needs_derivatives(unit, true));
    unit.target = TextureTarget::rectangle;
    CHECK_FALSE(needs_derivatives(unit, true));
    unit.min_filter = Filter::nearest;
    CHECK(needs_derivatives(unit, false));
}
