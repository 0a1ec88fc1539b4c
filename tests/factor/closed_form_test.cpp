#include "factor/closed_form.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"

using namespace twofold;

namespace {

LightingSamples held_out(const Brdf& brdf, const DistantLights& lights) {
    LightingSamples samples{surface_views(5000, 1), {}};
    samples.radiance = outgoing_radiance(brdf, lights, samples.at, 2);
    return samples;
}

DistantLights one_light() {
    DistantLights lights;
    lights.push_back(normalized(Vec3{1.0, 2.0, 2.0}), Rgb(3.0, 2.0, 0.0));
    lights.push_back(Vec3{0.0, 1.0, 0.0}, Rgb(0.0));  // does not shine
    return lights;
}

/// An even sky, brighter above.
DistantLights sky() {
    DistantLights lights;
    for (int i = 0; i < 400; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / 400.0, r = std::sqrt(1.0 - y * y);
        lights.push_back({r * std::cos(2.4 * i), y, r * std::sin(2.4 * i)}, Rgb(1.0 + 0.5 * y));
    }
    return lights;
}

FactorSettings settings_of(int size) {
    FactorSettings settings = method_preset(Method::best);
    settings.map_size = size;
    return settings;
}

}  // namespace

TEST_CASE("a diffuse material needs no second map") {
    const Brdf matt = ModifiedPhong{Rgb(0.8, 0.5, 0.2), Rgb(0.0), 1.0};
    const auto known = closed_form(matt, sky(), held_out(matt, sky()), settings_of(32), 100.0, 2);
    REQUIRE(known);
    CHECK(known->closed_form == "diffuse");
    CHECK(known->terms[0].constant_t2);
    for (const ChannelFit& fit : known->fit) CHECK(fit.relative_rms < 0.002);
    const Brdf rough = CookTorrance{Rgb(0.5), Rgb(0.0)};
    CHECK(closed_form(rough, sky(), held_out(rough, sky()), settings_of(16), 100.0, 2));
}

TEST_CASE("one Phong lobe under one light is written down, the black channel too") {
    const Brdf phong = ModifiedPhong{Rgb(0.5), Rgb(0.5), 20.0};
    const auto known =
        closed_form(phong, one_light(), held_out(phong, one_light()), settings_of(64), 5.0, 2);
    REQUIRE(known);
    CHECK(known->closed_form == "one Phong lobe");
    CHECK(known->fit[0].relative_rms < 0.01);
    CHECK(known->fit[1].relative_rms < 0.01);
    CHECK(known->terms[0].c.z == 0.0);
    CHECK(known->terms[0].scale_color.z == 0.0);
}

TEST_CASE("what is no product has no closed form") {
    const Brdf phong = ModifiedPhong{};
    const Brdf metal = CookTorrance{};
    CHECK_FALSE(closed_form(phong, sky(), held_out(phong, sky()), settings_of(16), 1.0, 1));
    CHECK_FALSE(
        closed_form(metal, one_light(), held_out(metal, one_light()), settings_of(16), 1.0, 1));
}
