#include "factor/lighting.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"

using namespace twofold;

namespace {

const Vec3 up(0.0, 0.0, 1.0);

/// The defaults with the lobes given. (Default construction inlined into a test makes g++ 12 see an
/// uninitialised initializer list.)
CookTorrance cook_torrance(std::size_t lobes) {
    return CookTorrance{.lobes = std::vector<BeckmannLobe>(lobes)};
}

CookTorrance copper() {
    CookTorrance material = cook_torrance(2);
    material.diffuse = Rgb(0.1, 0.2, 0.3);
    material.specular = Rgb(0.7, 0.6, 0.5);
    material.f0 = Rgb(0.95, 0.64, 0.54);
    material.lobes[0] = {0.4, 0.4};
    material.lobes[1] = {0.2, 0.6};
    return material;
}

std::vector<Brdf> materials() {
    CookTorrance plastic = cook_torrance(1);
    plastic.diffuse = Rgb(0.3);
    plastic.constant = CookTorranceConstant::modern4;
    CookTorrance matt = cook_torrance(0);
    matt.diffuse = Rgb(0.5);
    return {copper(),
            plastic,
            matt,
            ModifiedPhong{},
            ModifiedPhong{Rgb(0.0), Rgb(1.0), 1000.0},
            ModifiedPhong{Rgb(0.1), Rgb(0.9), 12.5},
            ModifiedPhong{Rgb(0.1), Rgb(0.9), 0.0}};
}

/// A sky with structure and a number of lights that is no multiple of 256.
DistantLights uneven_sky() {
    PaintedEnvironment sky{Rgb(0.2, 0.3, 0.5), {}};
    sky.discs.push_back({Vec3(1.0, 2.0, 0.5), 20.0, Rgb(8.0, 7.0, 5.0)});
    sky.discs.push_back({Vec3(-1.0, 0.2, -0.5), 35.0, Rgb(0.0, 0.0, 0.0)});
    return latitude_longitude(paint(sky, 100, 50), {}, "sky").lights;
}

/// Equation 1 as it is written, one light after the other.
Rgb plain_sum(const Brdf& brdf, const DistantLights& lights, const SurfaceView& at) {
    Rgb sum;
    for (int c = 0; c < 3; ++c) {
        sum[c] = ordered_sum(lights.size(), [&](std::size_t k) {
            const Vec3 l = lights.direction(k);
            const double cosine = dot(at.n, l) > 0.0 ? dot(at.n, l) : 0.0;
            return evaluate(brdf, at.n, at.v, l)[c] * cosine * lights.weight(k)[c];
        });
    }
    return sum;
}

bool same_bits(Rgb a, Rgb b) {
    bool same = true;
    for (int c = 0; c < 3; ++c) {
        same = same && std::bit_cast<std::uint64_t>(a[c]) == std::bit_cast<std::uint64_t>(b[c]);
    }
    return same;
}

double relative_difference(Rgb a, Rgb b) {
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double d = a[c] == b[c] ? 0.0 : std::fabs(a[c] - b[c]) / std::fabs(b[c]);
        worst = d > worst ? d : worst;
    }
    return worst;
}

}  // namespace

TEST_CASE("The block kernels equal the plain sum to 1e-13", "[lighting]") {
    const DistantLights sky = uneven_sky();
    for (const Brdf& material : materials()) {
        for (const SurfaceView& at : surface_views(25, 2)) {
            const Rgb fast = outgoing_radiance(material, sky, at);
            REQUIRE(relative_difference(fast, plain_sum(material, sky, at)) < 1e-13);
        }
    }
}

TEST_CASE("Leaving out patches below the horizon and black ones changes no bit", "[lighting]") {
    const DistantLights bounded = uneven_sky();
    DistantLights unbounded = bounded;
    unbounded.cones.clear();
    REQUIRE(bounded.cones.size() == (bounded.size() + light_patch - 1) / light_patch);
    for (const Brdf& material : materials()) {
        for (const SurfaceView& at : surface_views(100, 5)) {
            REQUIRE(same_bits(outgoing_radiance(material, bounded, at),
                              outgoing_radiance(material, unbounded, at)));
        }
    }
}

TEST_CASE("A quarter of an even sky and more is left out", "[lighting]") {
    const DistantLights sky = constant_environment(Rgb(1.0), 8192);
    for (const Vec3 n : {Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
        std::size_t below = 0;
        for (const LightCone& cone : sky.cones) {
            below += dot(n, cone.axis) <= -cone.sine ? 1U : 0U;
        }
        CHECK(below * 4 >= sky.cones.size());
        CHECK(below * 2 <= sky.cones.size());
    }
}

TEST_CASE("A view from below or along the surface sees nothing", "[lighting]") {
    const DistantLights sky = uneven_sky();
    for (const Brdf& brdf : materials())
        for (const Vec3& v : {Vec3(0.0, 0.6, -0.8), Vec3(1.0, 0.0, 0.0)})
            CHECK(outgoing_radiance(brdf, sky, SurfaceView{up, v}) == Rgb(0.0));
}

TEST_CASE("A light below the horizon adds exactly nothing", "[lighting]") {
    for (const Brdf& material : materials()) {
        DistantLights lights;
        lights.push_back(normalized(Vec3(0.3, 0.2, -0.5)), Rgb(1e6));
        lights.push_back(Vec3(1.0, 0.0, 0.0), Rgb(1e6));
        CHECK(same_bits(outgoing_radiance(material, lights, {up, normalized(Vec3(1, 0, 1))}),
                        Rgb(0.0)));
    }
}

TEST_CASE("One, two and seven threads give the same bits", "[lighting]") {
    const DistantLights sky = uneven_sky();
    const auto views = surface_views(333, 1);
    for (const Brdf& material : materials()) {
        const auto one = outgoing_radiance(material, sky, views, 1);
        const auto two = outgoing_radiance(material, sky, views, 2);
        const auto seven = outgoing_radiance(material, sky, views, 7);
        for (std::size_t i = 0; i < views.size(); ++i) {
            REQUIRE(same_bits(one[i], outgoing_radiance(material, sky, views[i])));
            REQUIRE(same_bits(one[i], two[i]));
            REQUIRE(same_bits(one[i], seven[i]));
        }
    }
}

TEST_CASE("One directional light gives f times cosine times its irradiance", "[lighting]") {
    const Vec3 l = normalized(Vec3(0.3, -0.4, 0.8)), v = normalized(Vec3(-0.5, 0.1, 0.6));
    const DirectionalLight sun{l, Rgb(3.0, 2.0, 1.0)};
    const DistantLights lights = directional_lights(std::span(&sun, 1));
    for (const Brdf& material : materials()) {
        const Rgb expected = evaluate(material, up, v, l) * dot(up, l) * sun.irradiance;
        // The exponent 1000 multiplies the rounding of r_v.l by as much.
        CHECK(relative_difference(outgoing_radiance(material, lights, {up, v}), expected) < 1e-12);
    }
}

TEST_CASE("S05 S08 Under constant light a diffuse surface shows its albedo",
          "[lighting][S05][S08]") {
    const ModifiedPhong chalk{Rgb(0.8, 0.5, 0.2), Rgb(0.0), 1.0};
    const DistantLights sky = constant_environment(Rgb(2.0, 1.0, 0.5), 8192);
    for (const SurfaceView& at : surface_views(100, 0)) {
        const Rgb radiance = outgoing_radiance(chalk, sky, at);
        REQUIRE(relative_difference(radiance, Rgb(1.6, 0.5, 0.1)) < 2e-3);
    }
}

TEST_CASE("A disc of light about the normal gives pi sin^2 of its half angle", "[lighting]") {
    const ModifiedPhong white{Rgb(1.0), Rgb(0.0), 1.0};
    for (const double degrees : {20.0, 45.0, 90.0}) {
        const Vec3 centre = normalized(Vec3(0.2, 0.5, -0.9));
        const PaintedEnvironment lamp{Rgb(0.0), {{centre, degrees, Rgb(1.0)}}};
        const auto lights = latitude_longitude(paint(lamp, 512, 256), {}, "lamp").lights;
        const double sine = exact::sin(degrees * exact::pi / 180.0);
        const double radiance = outgoing_radiance(white, lights, {centre, centre}).x;
        CHECK(radiance == Approx(sine * sine).epsilon(0.01));
    }
}

TEST_CASE("S09 Without lights, or with black ones, there is no radiance", "[lighting][S09]") {
    CHECK(same_bits(outgoing_radiance(copper(), DistantLights{}, {up, up}), Rgb(0.0)));
    const DistantLights night = constant_environment(Rgb(0.0), 8192);
    for (const Brdf& material : materials()) {
        CHECK(same_bits(outgoing_radiance(material, night, {up, up}), Rgb(0.0)));
    }
}

TEST_CASE("Turning surface and lights together changes nothing but rounding", "[lighting]") {
    const DistantLights sky = uneven_sky();
    DistantLights turned;  // a quarter turn about z, exact in binary
    for (std::size_t k = 0; k < sky.size(); ++k) {
        const Vec3 l = sky.direction(k);
        turned.push_back(Vec3(-l.y, l.x, l.z), sky.weight(k));
    }
    for (const SurfaceView& at : surface_views(50, 0)) {
        const SurfaceView other{Vec3(-at.n.y, at.n.x, at.n.z), Vec3(-at.v.y, at.v.x, at.v.z)};
        REQUIRE(relative_difference(outgoing_radiance(copper(), sky, at),
                                    outgoing_radiance(copper(), turned, other)) < 1e-13);
    }
}
