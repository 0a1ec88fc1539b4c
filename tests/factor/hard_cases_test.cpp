#include <catch2/catch.hpp>
#include <cmath>

#include "factor/factorize.hpp"
#include "factor/first_guess.hpp"
#include "factor/lighting.hpp"
#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

std::vector<double> texels_of(const FactorMap& map, std::size_t channel) {
    std::vector<double> texels;
    for (const Texture& face : map.real)
        for (const Rgba32f& texel : std::get<std::vector<Rgba32f>>(face.texels))
            texels.push_back(static_cast<double>(texel[channel]));
    return texels;
}

bool finite_everywhere(const FactoredLighting& result) {
    for (const ProductTerm& term : result.terms)
        for (std::size_t c = 0; c < 3; ++c) {
            if (!all_finite(texels_of(term.t1, c)) || !all_finite(texels_of(term.t2, c)))
                return false;
            if (!std::isfinite(result.fit[c].relative_rms)) return false;
        }
    return true;
}

FactorSettings map_of(int size) {
    FactorSettings settings;
    settings.map_size = size;
    return settings;
}

/// log of the largest over the smallest value.
double log_range(std::span<const double> logs) {
    return *std::max_element(logs.begin(), logs.end()) -
           *std::min_element(logs.begin(), logs.end());
}

}  // namespace

TEST_CASE("F04 two samples of 1 and 1e8 are both kept, in the precision of floats", "[hard][F04]") {
    LightingSamples samples;
    const Vec3 up{0.0, 0.0, 1.0}, side{1.0, 0.0, 0.0};
    samples.at = {{up, up}, {side, side}};
    samples.radiance = {Rgb(1.0), Rgb(1e8)};
    FactorSettings settings = cases::unregularised(8, 0.875);
    settings.floor = 1e-12;
    const FactoredLighting result = factorize(samples, {}, settings, 1.0, 1);
    const ProductTerm& term = result.terms[0];
    for (std::size_t i = 0; i < 2; ++i) {
        const double drawn =
            term.max1.x * term.max2.x *
            filtered(texels_of(term.t1, 0), footprint_of(pi_1(samples.at[i]), term.t1.shape)) *
            filtered(texels_of(term.t2, 0), footprint_of(pi_2(samples.at[i]), term.t2.shape));
        CHECK(drawn == Approx(samples.radiance[i].x).epsilon(1e-6));
    }
    CHECK(result.fit[0].counts.floored == 0);
    CHECK(result.fit[0].counts.capped == 0);
}

TEST_CASE("F06 regularised, no factor spans more than the samples do, however long one iterates",
          "[hard][F06]") {
    const LightingSamples samples = cases::samples_of({}, 8000, 1);
    for (const double smoothness : {0.3, 0.0}) {
        FactorSettings settings = map_of(16);
        settings.smoothness = smoothness;
        settings.seam = smoothness;
        const LogRows left = log_rows(samples.at, settings);
        const ChannelRows right =
            channel_rows(left, channel_of(samples.radiance, 0), settings, 1.0);
        const WeightedSystem system(left, right, settings, 1);
        const Vector start = system.scaled_unknowns(first_guess(left, right, 2.0, 1).x);
        const double span = log_range(std::span(right.right_side).first(left.samples));
        for (const int limit : {50, 200, 800}) {
            const Solution s = solve(Solver::lsmr, system.problem(), start,
                                     {.tolerance = 0.0, .iteration_limit = limit, .window = 0});
            const Vector x = system.gauge().balanced(system.unknowns(s.x));
            const std::size_t texels = left.shape.texels();
            const double widest = std::max(log_range(std::span(x).first(texels)),
                                           log_range(std::span(x).last(texels)));
            CAPTURE(smoothness, limit, widest, span);
            if (smoothness > 0.0)
                CHECK(widest <= 1.25 * span);
            else if (limit == 800)
                CHECK(widest > 2.0 * span);
        }
    }
}

TEST_CASE("F13 channels with different support are factored as if each were alone", "[hard][F13]") {
    LightingSamples samples = cases::samples_of({}, 8000, 1);
    for (std::size_t i = 0; i < samples.at.size(); ++i) {
        samples.radiance[i].y *= 0.25;
        if (samples.at[i].n.z < 0.0) samples.radiance[i].z = 0.0;
    }
    for (const Method method : {Method::paper, Method::best}) {
        FactorSettings settings = method_preset(method);
        settings.map_size = 8;
        settings.scale = ScaleRule::maximum;
        const FactoredLighting triple = factorize(samples, {}, settings, 1.0, 2);
        for (std::size_t c = 0; c < 3; ++c) {
            LightingSamples alone = samples;
            for (std::size_t i = 0; i < alone.at.size(); ++i)
                alone.radiance[i] = Rgb(samples.radiance[i][static_cast<int>(c)]);
            const FactoredLighting grey = factorize(alone, {}, settings, 1.0, 2);
            CHECK(texels_of(grey.terms[0].t1, 0) == texels_of(triple.terms[0].t1, c));
            CHECK(texels_of(grey.terms[0].t2, 0) == texels_of(triple.terms[0].t2, c));
            CHECK(grey.fit[0].counts.zero == triple.fit[c].counts.zero);
        }
    }
}

TEST_CASE("Q05 a byte that goes through the logarithm comes back as itself, all 256",
          "[hard][Q05]") {
    const MapShape shape{16, 1.0};
    std::vector<double> logs(shape.texels(), 0.0);
    for (std::size_t b = 1; b < 256; ++b) logs[b] = exact::log(static_cast<double>(b) / 255.0);
    const NormalisedChannel channel = normalised(logs, shape, "t1");
    for (std::size_t b = 1; b < 256; ++b) {
        CHECK(to_byte(channel.texel[b]) == b);
        CHECK(std::fabs(channel.texel[b] * 255.0 - static_cast<double>(b)) < 0.5e-10);
    }
    CHECK(to_byte(0.0) == 0);
}

TEST_CASE("S03 S04 S06 a sun of 1e6, an exponent of 1e5 and a slope of 1e-3 leave finite factors",
          "[hard][S03][S04][S06]") {
    DistantLights lights;
    for (const Vec3 l : cases::many_lights()) lights.push_back(l, Rgb(0.1));
    lights.push_back(normalized(Vec3{0.2, 0.3, 0.9}), Rgb(1e6));
    const DistantLights sun = bound_blocks(std::move(lights));
    const std::vector<Brdf> materials{ModifiedPhong{Rgb(0.5), Rgb(0.5), 1e5},
                                      CookTorrance{Rgb(0.3), Rgb(0.7), Rgb(0.04), {{1e-3, 1.0}}},
                                      ModifiedPhong{Rgb(0.0), Rgb(1.0), 1e5}};
    for (const Brdf& brdf : materials) {
        LightingSamples samples{surface_views(6000, 1), {}};
        samples.radiance = outgoing_radiance(brdf, sun, samples.at, 2);
        for (const Method method : {Method::letter, Method::paper, Method::best}) {
            FactorSettings settings = method_preset(method);
            settings.map_size = 8;
            const FactoredLighting result = factorize(samples, {}, settings, 10.0, 2);
            CAPTURE(name_of(method));
            CHECK(finite_everywhere(result));
        }
    }
}

TEST_CASE("F02 F11 every preset reports that channels without finite or positive samples are that",
          "[hard][F02][F11]") {
    LightingSamples samples = cases::samples_of({}, 6000, 1);
    const double nan = std::nan("");
    for (std::size_t i = 0; i < samples.at.size(); i += 3) {
        samples.radiance[i].x = nan;
        samples.radiance[i].y = -3894.0;
        samples.radiance[i].z = 0.0;
    }
    for (const Method method : {Method::letter, Method::paper, Method::best}) {
        FactorSettings settings = method_preset(method);
        settings.map_size = 8;
        const FactoredLighting result = factorize(samples, {}, settings, 1.0, 2);
        CHECK(result.fit[0].counts.non_finite == 2000);
        CHECK(result.fit[1].counts.negative == 2000);
        CHECK(result.fit[2].counts.zero >= 2000);
        CHECK(finite_everywhere(result));
    }
}
