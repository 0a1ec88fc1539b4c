#include <catch2/catch.hpp>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "factor/evaluate.hpp"
#include "factor/lighting.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

using namespace twofold;

namespace {

const Vec3 up(0.0, 0.0, 1.0);

Vec3 at_angle(double theta, double phi) {
    return {exact::sin(theta) * exact::cos(phi), exact::sin(theta) * exact::sin(phi),
            exact::cos(theta)};
}

/// The defaults with one lobe. (Default construction inlined into a test makes g++ 12 see an
/// uninitialised initializer list.)
CookTorrance one_lobe(double m) {
    return CookTorrance{.lobes = std::vector<BeckmannLobe>(1, BeckmannLobe{m, 1.0})};
}

CookTorrance glossy() {
    CookTorrance material = one_lobe(0.4);
    material.diffuse = Rgb(0.3, 0.2, 0.1);
    material.specular = Rgb(0.7);
    material.f0 = Rgb(0.04, 0.5, 0.9);
    material.lobes = {{0.4, 0.4}, {0.2, 0.6}};
    return material;
}

bool finite(Rgb c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); }

}  // namespace

TEST_CASE("Fresnel's reflectance is f0 at normal incidence and 1 at grazing", "[brdf]") {
    for (const double f0 : {0.0, 0.04, 0.5, 0.95}) {
        CHECK(fresnel(1.0, f0) == Approx(f0).margin(1e-15).epsilon(1e-12));
    }
    CHECK(fresnel(1e-12, 0.04) == Approx(1.0).epsilon(1e-10));
    // Glass, index 1.5, at 60 degrees: 0.5 (Rs + Rp) by Fresnel's two equations.
    const double n = 1.5, c = 0.5, t = std::sqrt(1.0 - 0.75 / (n * n));
    const double s = (c - n * t) / (c + n * t), p = (n * c - t) / (n * c + t);
    CHECK(fresnel(c, 0.04) == Approx(0.5 * (s * s + p * p)).epsilon(1e-13));
}

TEST_CASE("Both materials are reciprocal", "[brdf]") {
    // Phong's lobe is symmetric in l and v, as r_v.l = 2 (n.l) (n.v) - l.v.
    const Brdf materials[] = {Brdf(glossy()), Brdf(ModifiedPhong{Rgb(.2), Rgb(.6), 37.0})};
    for (const Brdf& material : materials) {
        for (const SurfaceView& pair : surface_views(500, 1)) {
            const Vec3 v = about(up, 0.6, 0.0, 0.8);
            const Vec3 l = dot(pair.v, up) > 0.0 ? pair.v : -pair.v;
            const Rgb f = evaluate(material, up, v, l), back = evaluate(material, up, l, v);
            REQUIRE(length(f - back) <= 1e-12 * length(f));
        }
    }
}

TEST_CASE("S01 A view or a light at or below the horizon gives nothing", "[brdf][S01]") {
    for (const Brdf& material : {Brdf(glossy()), Brdf(ModifiedPhong{})}) {
        for (const double cosine : {0.0, -0.0, -1e-8, -0.5, -1.0}) {
            const Vec3 low(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
            CHECK(evaluate(material, up, low, up) == Rgb(0.0));
            CHECK(evaluate(material, up, up, low) == Rgb(0.0));
        }
    }
}

TEST_CASE("S02 Grazing Cook-Torrance stays finite and tends to its stated limit", "[brdf][S02]") {
    const Brdf material = glossy();
    for (int k = 1; k <= 15; ++k) {
        double graze = 1.0;
        for (int i = 0; i < k; ++i) {
            graze /= 10.0;
        }
        const Vec3 v(std::sqrt(1.0 - graze * graze), 0.0, graze);
        for (const Vec3 l : {up, v, Vec3(-v.x, 0.0, graze), Vec3(0.0, v.x, graze),
                             Vec3(-std::sqrt(0.75), 0.0, 0.5)}) {
            const Rgb f = evaluate(material, up, v, l);
            REQUIRE(finite(f));
            REQUIRE(f.x > 0.0);
        }
    }
    // Mirror direction: n.h = 1, so f = s F D(0) 2 / (pi v.h max(n.l, n.v)) until G reaches 1.
    const CookTorrance mirror = one_lobe(0.2);
    const double c = 1e-3;
    const Vec3 v(std::sqrt(1.0 - c * c), 0.0, c);
    const double f = evaluate(mirror, up, v, Vec3(-v.x, 0.0, c)).x;
    const double expected = fresnel(c, 0.04) / (0.2 * 0.2) / (exact::pi * c * c);
    CHECK(f == Approx(expected).epsilon(1e-9));
}

TEST_CASE("S02 The lighting sum stays finite at grazing", "[brdf][S02]") {
    const DistantLights sky = constant_environment(Rgb(1.0), 2048);
    for (double graze = 0.1; graze > 1e-16; graze /= 10.0) {
        const Vec3 v(std::sqrt(1.0 - graze * graze), 0.0, graze);
        REQUIRE(finite(outgoing_radiance(glossy(), sky, {up, v})));
    }
    CHECK(outgoing_radiance(glossy(), sky, {up, Vec3(1.0, 0.0, 0.0)}) == Rgb(0.0));
    CHECK(outgoing_radiance(glossy(), sky, {up, Vec3(0.0, 0.0, -1.0)}) == Rgb(0.0));
}

TEST_CASE("S04 Beckmann's distribution is finite in logarithms where it underflows",
          "[brdf][S04]") {
    // -tan^2(0.05) / m^2 - ln(m^2 cos^4(0.05)) to 20 digits; with D / pi it is the -2491.4968 of
    // S04.
    const double cosine = exact::cos(0.05), tangent = exact::sin(0.05) / cosine;
    const double log_d = log_beckmann(cosine, tangent * tangent, 1e-3);
    CHECK(std::fabs(log_d + 2490.3520644997815989) < 4 * 4.5e-13);  // 4 ulp
    CHECK(exact::exp(log_d) == 0.0);
}

TEST_CASE("S04 A lobe far narrower than its distance to the light stays finite", "[brdf][S04]") {
    const CookTorrance narrow = one_lobe(1e-3);
    DistantLights lamp;
    lamp.push_back(at_angle(0.1, 0.0), Rgb(1.0));
    const Rgb radiance = outgoing_radiance(narrow, lamp, {up, up});
    CHECK(finite(radiance));
    CHECK(radiance.x >= 0.0);
    CHECK(radiance.x < 1e-200);
}

TEST_CASE("Modified Phong reflects all of its k_s at normal incidence", "[brdf]") {
    // (N + 2) / (2 pi) times the integral of cos^(N+1) over the hemisphere is 1.
    const DistantLights sky = constant_environment(Rgb(1.0), 32768);
    for (const double exponent : {0.0, 1.0, 2.5, 20.0, 50.0}) {
        const ModifiedPhong lobe{Rgb(0.0), Rgb(1.0), exponent};
        CHECK(outgoing_radiance(lobe, sky, {up, up}).x == Approx(1.0).epsilon(2e-3));
    }
}

TEST_CASE("Neither material gives back more than it received", "[brdf]") {
    const DistantLights sky = constant_environment(Rgb(1.0), 8192);
    CookTorrance metal = one_lobe(0.3);
    metal.f0 = Rgb(0.95);
    metal.constant = CookTorranceConstant::modern4;
    for (const SurfaceView& at : surface_views(200, 0)) {
        CHECK(outgoing_radiance(ModifiedPhong{}, sky, at).x <= 1.01);
        if (dot(at.n, at.v) > 0.3) {
            CHECK(outgoing_radiance(metal, sky, at).x <= 1.0);
        }
    }
}

TEST_CASE("The two Cook-Torrance constants differ by four", "[brdf]") {
    const CookTorrance old = one_lobe(0.2);
    CookTorrance modern = old;
    modern.constant = CookTorranceConstant::modern4;
    const Vec3 v = at_angle(0.5, 0.0), l = at_angle(0.7, 2.0);
    CHECK(evaluate(old, up, v, l).x == 4.0 * evaluate(modern, up, v, l).x);
}

TEST_CASE("A material without a value is refused with field and value", "[brdf]") {
    CookTorrance mirror = one_lobe(0.2);
    mirror.f0 = Rgb(0.5, 1.0, 0.5);
    CHECK_THROWS_WITH(check(mirror), Catch::Contains("f0 = 1"));
    CHECK_THROWS_WITH(check(one_lobe(0.0)), Catch::Contains("m = 0"));
    CHECK_THROWS_AS(check(ModifiedPhong{Rgb(0.5), Rgb(0.5), -1.0}), Error);
    CHECK_NOTHROW(check(ModifiedPhong{}));
}
