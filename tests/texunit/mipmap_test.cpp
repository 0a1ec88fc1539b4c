#include "texunit/mipmap.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "texunit/random.hpp"

namespace {
using namespace twofold;

TextureUnitState unit_with(Filter min, Filter mag, MipFilter mip) {
    TextureUnitState unit;
    unit.min_filter = min;
    unit.mag_filter = mag;
    unit.mip_filter = mip;
    return unit;
}
}  // namespace

TEST_CASE("log2 of a power of two is its exponent exactly", "[mipmap]") {
    for (int k = -1022; k <= 1023; ++k) CHECK(log2_of(std::ldexp(1.0, k)) == k);
}

TEST_CASE("log2 is near the C library's, and never runs backwards across a power of two",
          "[mipmap]") {
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const double x = std::ldexp(1.0 + random_unit(5, i), static_cast<int>(i % 80) - 40);
        const double error = std::fabs(log2_of(x) - std::log2(x));
        if (!(error < 1e-14)) CHECK(error < 1e-14);
    }
    for (int k = -40; k <= 40; ++k) {
        const double x = std::ldexp(1.0, k);
        CHECK(log2_of(std::nextafter(x, 0.0)) <= k);
        CHECK(log2_of(std::nextafter(x, 2 * x)) >= k);
    }
}

TEST_CASE("log2 of what is no positive normal number is the least", "[mipmap]") {
    for (const double x : {0.0, -0.0, -3.0, 0x1p-1074, std::numeric_limits<double>::quiet_NaN()})
        CHECK(log2_of(x) == -1022.0);
}

TEMPLATE_TEST_CASE("rho is the longer of the two steps, exactly for whole texels", "[mipmap]",
                   float, double) {
    using Point = TexelPoint<TestType>;
    const Point here{10, 20};
    CHECK(squared_scale(here, Point{13, 24}, Point{10, 21}) == 25.0);
    CHECK(squared_scale(here, Point{11, 20}, Point{4, 12}) == 100.0);
    CHECK(squared_scale(here, here, here) == 0.0);
    for (int k = -8; k <= 12; ++k) {
        const auto step = static_cast<TestType>(std::ldexp(1.0, k));
        const Point origin{0, 0};
        CHECK(level_of_detail(squared_scale(origin, Point{step, 0}, origin), 0.0) == k);
        CHECK(level_of_detail(squared_scale(origin, origin, Point{0, -step}), 0.25) == k + 0.25);
    }
}

TEST_CASE("the nearest level changes half-way, and half-way is the finer", "[mipmap]") {
    struct Row {
        double lambda;
        int level;
    };
    const double above = std::nextafter(0.5, 1.0);
    for (const auto [lambda, level] :
         {Row{-5.0, 0}, Row{0.0, 0}, Row{0.5, 0}, Row{above, 1}, Row{1.0, 1}, Row{1.5, 1},
          Row{1.5000001, 2}, Row{2.5, 2}, Row{3.5, 3}, Row{3.50001, 3}, Row{100.0, 3}}) {
        CAPTURE(lambda);
        CHECK(nearest_level(lambda, 3) == level);
    }
}

TEST_CASE("magnification ends at 0, or at 1/2 with LINEAR above NEAREST_MIPMAP", "[mipmap]") {
    for (const Filter mag : {Filter::nearest, Filter::linear})
        for (const Filter min : {Filter::nearest, Filter::linear})
            for (const MipFilter mip : {MipFilter::off, MipFilter::nearest, MipFilter::linear}) {
                const auto unit = unit_with(min, mag, mip);
                const bool late =
                    mag == Filter::linear && min == Filter::nearest && mip != MipFilter::off;
                const double c = late ? 0.5 : 0.0;
                CHECK(select_levels(unit, c, 4).filter == mag);
                CHECK(select_levels(unit, c, 4).coarse == 0);
                CHECK(select_levels(unit, c + 1e-9, 4).filter == min);
            }
}

TEST_CASE("without mipmaps the base image is used whatever the state says", "[mipmap]") {
    for (const MipFilter mip : {MipFilter::off, MipFilter::nearest, MipFilter::linear})
        for (const double lambda : {-1.0, 0.3, 0.9, 7.0}) {
            const auto chosen =
                select_levels(unit_with(Filter::nearest, Filter::linear, mip), lambda, 0);
            CHECK(chosen.fine == 0);
            CHECK(chosen.coarse == 0);
            CHECK((chosen.filter == Filter::linear) == (lambda <= 0.0));
        }
    const auto off =
        select_levels(unit_with(Filter::nearest, Filter::nearest, MipFilter::off), 3.0, 4);
    CHECK(off.coarse == 0);
}

TEST_CASE("linear mipmapping reads two neighbouring levels up to the last", "[mipmap]") {
    const auto unit = unit_with(Filter::linear, Filter::linear, MipFilter::linear);
    for (int k = 1; k < 400; ++k) {
        const double lambda = k / 64.0;
        const auto chosen = select_levels(unit, lambda, 4);
        CHECK(chosen.fine + chosen.fraction == std::fmin(lambda, 4.0));
        CHECK(chosen.coarse == (lambda < 4.0 ? chosen.fine + 1 : 4));
        CHECK(chosen.fraction < 1.0);
    }
}
