#include <catch2/catch.hpp>
#include <cmath>

#include "factor/first_guess.hpp"
#include "factor/lighting.hpp"
#include "factor/vector_arithmetic.hpp"
#include "factorize_fixtures.hpp"

using namespace twofold;
using namespace twofold::cases;

namespace {

bool finite_everywhere(const FactoredLighting& result) {
    for (const ProductTerm& term : result.terms)
        for (std::size_t c = 0; c < 3; ++c) {
            if (!all_finite(texels_of(term.t1, c)) || !all_finite(texels_of(term.t2, c)))
                return false;
            if (!std::isfinite(result.fit[c].relative_rms)) return false;
        }
    return true;
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

TEST_CASE("F13 channels with different support are factored as if each were alone",
          "[hard][F13][long]") {
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

TEST_CASE("F20 Q02 without a regulariser 8 bits lose the picture, and the report says so",
          "[hard][F20][Q02][long]") {
    const auto radiance = [](const SurfaceView& at) { return Rgb(cases::sky_and_lamps(at)); };
    const LightingSamples fit = cases::samples_of_function(40000, 1, radiance);
    const LightingSamples held_out = cases::samples_of_function(10000, 2, radiance);
    const double white = white_of(held_out);

    FactorSettings plain = cases::unregularised(32, 0.875);
    plain.column_scaling = false;
    plain.solver = Solver::lsmr;
    plain.tolerance = 0.0;
    const FactoredLighting bare = factorize(fit, {}, plain, white, 2);
    CAPTURE(bare.fit[0].relative_rms, bare.fit[0].byte_rms, bare.terms[0].t1.loss[0].zero_share,
            bare.terms[0].t2.loss[0].zero_share, name_of(bare.fit[0].solver.status));
    for (const std::string& warning : bare.warnings) UNSCOPED_INFO(warning);
    CHECK(bare.fit[0].byte_rms > 1.3 * bare.fit[0].relative_rms);
    CHECK(any_contains(bare.warnings, "stored as 0"));
    CHECK(any_contains(bare.warnings, "touched by no sample"));
    CHECK(bare.fit[0].untouched_share == Approx(0.294).margin(0.01));

    // These rows take the mean of four neighbours and count the texels of one map; as the table of
    // F20 counts, its 0.01, 0.1 and 1 are 4 / sqrt(2) times that here.
    for (const double smoothness : {0.01, 0.1, 1.0}) {
        plain.smoothness = smoothness * 4.0 / std::sqrt(2.0);
        const FactoredLighting smooth = factorize(fit, held_out, plain, white, 2);
        CAPTURE(smoothness);
        CHECK(smooth.fit[0].byte_rms < 1.01 * smooth.fit[0].relative_rms);
        CHECK(smooth.terms[0].t1.loss[0].zero_share < 0.01);
        CHECK(smooth.terms[0].t2.loss[0].zero_share < 0.01);
        CHECK_FALSE(any_contains(smooth.warnings, "stored as 0"));
    }
}

TEST_CASE("F20 the method to the letter warns that its factors are of no use in 8 bits",
          "[hard][F20][long]") {
    const FactoredLighting result = factored_phong(method_preset(Method::letter), 30000);
    CHECK(result.fit[0].solver.status == SolverStatus::limit);
    CHECK(result.fit[0].byte_rms > 1.3 * result.fit[0].relative_rms);
    CHECK(any_contains(result.warnings, "ended with limit after 200 iterations"));
    CHECK(any_contains(result.warnings, "touched by no sample"));
    CHECK(any_contains(result.warnings, "stored as 0"));
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
          "[hard][S03][S04][S06][long]") {
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
