#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "factor/measured_brdf.hpp"
#include "judge.hpp"
#include "tests/data_folder.hpp"

using namespace twofold;
using namespace twofold::quality;

namespace {

/// Pairs of the fit: about 24 an unknown at 32 x 32, 12 at 64, 10 at 128.
int samples_of(int map_size) {
    return map_size == 32 ? 100000 : (map_size == 64 ? 12 : 10) * 4 * map_size * map_size;
}

Judged judged(const char* name, const Brdf& brdf, const char* light,
              const FactorSettings& settings) {
    const Judged j = judge(brdf, lights_named(light), settings, samples_of(settings.map_size));
    std::printf("%-44s %3d: rel %.4f, log rms %.4f, %.2f dB, 8 bits %.2f steps at x%d\n", name,
                settings.map_size, j.relative_rms, j.log_rms, j.psnr, j.byte_steps,
                j.factors.terms[0].combiner_scale << j.factors.doubling_passes);
    CHECK(j.largest_ratio < 1e4);
    return j;
}

FactorSettings with_view(int map_size) {
    FactorSettings settings = settings_of(Method::paper, map_size);
    settings.view_knots = 24;
    return settings;
}

FactorSettings refined(int map_size, int steps, int terms = 1) {
    FactorSettings settings = settings_of(Method::paper, map_size);
    settings.refinement = steps;
    settings.terms = terms;
    return settings;
}

}  // namespace

TEST_CASE("quality: a diffuse material under a sky") {
    const Judged j = judged("diffuse, sky", diffuse(), "sky", settings_of(Method::paper, 32));
    CHECK(j.relative_rms <= 0.002);
    CHECK(j.psnr >= 60.0);
}

TEST_CASE("quality: Phong 50 under one light, by map size", "[long]") {
    for (const auto& [size, least] : {std::pair{32, 39.0}, {64, 50.0}, {128, 60.0}}) {
        const Judged j =
            judged("Phong 50, one light", phong(50), "one", settings_of(Method::paper, size));
        CHECK(j.psnr >= least);
    }
}

TEST_CASE("quality: Phong 50 under one light, refined", "[long]") {
    for (const auto& [size, least] : {std::pair{32, 45.0}, {64, 56.0}}) {
        const Judged j = judged("Phong 50, one light, refined", phong(50), "one", refined(size, 4));
        CHECK(j.psnr >= least);
    }
}

TEST_CASE("quality: Phong 50 under three lights", "[long]") {
    const Judged one =
        judged("Phong 50, three lights", phong(50), "three", settings_of(Method::paper, 32));
    CHECK(one.relative_rms >= 0.20);
    CHECK(one.relative_rms <= 0.32);
    const Judged three =
        judged("Phong 50, three lights, 3 products", phong(50), "three", refined(32, 8, 3));
    CHECK(three.psnr >= 40.0);
}

TEST_CASE("quality: Phong 50 under a sky", "[long]") {
    const Judged j = judged("Phong 50, sky", phong(50), "sky", settings_of(Method::paper, 32));
    CHECK(j.relative_rms >= 0.12);
    CHECK(j.relative_rms <= 0.18);
    const Judged g = judged("Phong 50, sky, with g", phong(50), "sky", with_view(32));
    CHECK(g.relative_rms <= 0.07);
    CHECK(g.psnr >= 28.0);
}

TEST_CASE("quality: Phong 50 under constant light", "[long]") {
    FactorSettings plain = settings_of(Method::paper, 32);
    plain.row_weight = 0.0;
    const Judged j = judged("Phong 50, constant light", phong(50), "constant", plain);
    CHECK(j.log_rms == Approx(0.1487).margin(0.01));
    const Judged g =
        judged("Phong 50, constant light, with g", phong(50), "constant", with_view(32));
    CHECK(g.psnr >= 60.0);
}

TEST_CASE("quality: Cook-Torrance of slope .2 under a sky", "[long]") {
    const Brdf brdf = cook_torrance(0.2);
    const Judged j = judged("Cook-Torrance .2, sky", brdf, "sky", settings_of(Method::paper, 32));
    CHECK(j.relative_rms <= 0.42);
    const Judged g = judged("Cook-Torrance .2, sky, with g", brdf, "sky", with_view(32));
    CHECK(g.relative_rms <= 0.18);
    CHECK(g.psnr >= 25.0);
    FactorSettings two = with_view(32);
    two.terms = 2;
    two.refinement = 8;
    const Judged both = judged("Cook-Torrance .2, sky, 2 products with g", brdf, "sky", two);
    CHECK(both.psnr >= 30.0);
}

TEST_CASE("quality: Cornell's paints under a sky") {
    const auto folder = data_folder();
    if (!folder) return;
    for (const char* name : {"garnet_red", "krylon_blue"}) {
        const auto bytes = bytes_of(*folder / "brdf/cornell" / (std::string(name) + ".brdf"));
        const MeasuredData data = parse_cornell(std::string(bytes.begin(), bytes.end()), name);
        for (const Fill fill : {Fill::homomorphic, Fill::interpolate}) {
            MeasuredBrdf paint;
            paint.model = std::make_shared<MeasuredModel>(make_model(data, fill, 2));
            for (const int knots : {0, 24}) {
                FactorSettings settings = settings_of(Method::paper, 32);
                settings.view_knots = knots;
                const auto fits = channel_fits(paint, grey_sky(), settings, samples_of(32));
                std::printf("%s, %s, %s g: rel %.3f / %.3f / %.3f\n", name,
                            fill == Fill::homomorphic ? "product" : "interpolated",
                            knots > 0 ? "with" : "without", fits[0].relative_rms,
                            fits[1].relative_rms, fits[2].relative_rms);
                for (const ChannelFit& fit : fits) {
                    CAPTURE(name, knots);
                    CHECK(std::isfinite(fit.relative_rms));
                    if (knots > 0) CHECK(fit.relative_rms <= 0.25);
                }
            }
        }
    }
}

TEST_CASE("quality: 8 bits against floats of the same textures", "[long]") {
    for (const Method method : {Method::paper, Method::best}) {
        for (const char* light : {"one", "three", "sky"}) {
            const Judged j = judged(method == Method::paper ? "8 bits, paper" : "8 bits, best",
                                    phong(50), light, settings_of(method, 32));
            const int scale = j.factors.terms[0].combiner_scale << j.factors.doubling_passes;
            CAPTURE(light, scale);
            if (scale <= 2) CHECK(j.byte_steps <= 0.9);
            if (scale <= 4) CHECK(j.byte_steps <= 1.5);
        }
    }
}

TEST_CASE("quality: mottle between two sets of samples", "[long]") {
    const Brdf brdf = cook_torrance(0.2);
    const DistantLights sky = lights_named("sky");
    for (const Method method : {Method::paper, Method::best}) {
        FactorSettings settings = method_preset(method);
        settings.map_size = 32;
        settings.solver = Solver::lsmr;
        const Judged a = judge(brdf, sky, settings, samples_of(32), 0);
        const Judged b = judge(brdf, sky, settings, samples_of(32), 2);
        const double steps = mottle(a, b);
        std::printf("mottle, Cook-Torrance .2, sky, %s: %.2f steps\n", name_of(method), steps);
        if (method == Method::best) CHECK(steps <= 1.0);
    }
}
