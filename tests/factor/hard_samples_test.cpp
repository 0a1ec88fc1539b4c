#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factorize_fixtures.hpp"
#include "texunit/error.hpp"

using namespace twofold;
using namespace twofold::cases;

/// Sets of samples that are few, black, constant, contradictory or not numbers.

namespace {

using Catch::Matchers::Contains;

/// The product as drawn, before clamping, in units of radiance.
double drawn(const FactoredLighting& result, const SurfaceView& at, std::size_t channel) {
    const auto i = static_cast<int>(channel);
    return result.terms[0].max1[i] * result.terms[0].max2[i] *
           filtered(texels_of(result.terms[0].t1, channel),
                    footprint_of(pi_1(at), result.terms[0].t1.shape)) *
           filtered(texels_of(result.terms[0].t2, channel),
                    footprint_of(pi_2(at), result.terms[0].t2.shape));
}

}  // namespace

TEST_CASE("F09 one sample is reproduced and fills both maps", "[hard][F09]") {
    LightingSamples one = cases::samples_of({}, 1, 1);
    one.radiance[0] = Rgb(3.0, 0.25, 1.0);
    const FactoredLighting result = factorize(one, {}, map_of(8), 1.0, 1);
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected = one.radiance[0][static_cast<int>(c)];
        CHECK(drawn(result, one.at[0], c) == Approx(expected).epsilon(1e-14));
        for (const double texel : texels_of(result.terms[0].t1, c)) CHECK(texel == Approx(1.0));
    }
    CHECK(any_contains(result.warnings, "fewer than 10"));
}

TEST_CASE("F10 an empty set of samples is refused", "[hard][F10]") {
    CHECK_THROWS_WITH(factorize({}, {}, map_of(8), 1.0, 1), Contains("no samples"));
    LightingSamples uneven = cases::samples_of({}, 10, 1);
    uneven.radiance.pop_back();
    CHECK_THROWS_AS(factorize(uneven, {}, map_of(8), 1.0, 1), Error);
}

TEST_CASE("F11 Q01 a black channel is 0 and leaves the others alone, byte for byte",
          "[hard][F11][Q01]") {
    LightingSamples samples = cases::samples_of({}, 10000, 1);
    const FactoredLighting grey = factorize(samples, {}, map_of(8), 1.0, 2);
    for (Rgb& rgb : samples.radiance) rgb.x = 0.0;
    const FactoredLighting no_red = factorize(samples, {}, map_of(8), 1.0, 2);
    CHECK(no_red.terms[0].c.x == 0.0);
    CHECK(no_red.terms[0].scale_color.x == 0.0);
    CHECK(no_red.terms[0].max1.x == 0.0);
    for (const double texel : texels_of(no_red.terms[0].t1, 0)) CHECK(texel == 0.0);
    for (const double texel : texels_of(no_red.terms[0].t2, 0)) CHECK(texel == 0.0);
    for (const std::size_t c : {1U, 2U}) {
        CHECK(texels_of(no_red.terms[0].t1, c) == texels_of(grey.terms[0].t1, c));
        CHECK(texels_of(no_red.terms[0].t2, c) == texels_of(grey.terms[0].t2, c));
    }
    CHECK(no_red.fit[0].solver.iterations == 0);
    CHECK(no_red.fit[0].relative_rms == 0.0);

    for (Rgb& rgb : samples.radiance) rgb = Rgb(0.0);
    const FactoredLighting black = factorize(samples, {}, map_of(8), 0.0, 2);
    CHECK(black.terms[0].scale_color == Rgb(0.0));
}

TEST_CASE("F12 contradictory samples of one pair meet at their mean in the logarithm",
          "[hard][F12]") {
    LightingSamples samples = cases::samples_of({}, 1, 1);
    samples.at.push_back(samples.at[0]);
    samples.radiance = {Rgb(1.0), Rgb(4.0)};
    FactorSettings settings = map_of(8);
    settings.row_weight = 0.0;
    settings.cap = 0.0;
    const FactoredLighting result = factorize(samples, {}, settings, 1.0, 1);
    CHECK(drawn(result, samples.at[0], 0) == Approx(2.0).epsilon(1e-14));
}

TEST_CASE("F23 constant radiance converges at the start with constant factors", "[hard][F23]") {
    for (const double value : {1.0, std::exp(3.0)}) {
        for (const Solver solver : {Solver::qmr, Solver::lsmr}) {
            FactorSettings settings = map_of(8);
            settings.solver = solver;
            const FactoredLighting result = factorize(
                cases::samples_of_function(3000, 1, [&](const SurfaceView&) { return Rgb(value); }),
                {}, settings, 100.0, 1);
            CHECK(result.fit[0].solver.status == SolverStatus::converged);
            CHECK(result.fit[0].solver.iterations == 0);
            CHECK(result.fit[0].relative_rms < 1e-14);
            for (const double texel : texels_of(result.terms[0].t1, 0)) CHECK(texel == Approx(1.0));
        }
    }
}

TEST_CASE("F02 non-finite samples are left out and counted, channel by channel", "[hard][F02]") {
    LightingSamples samples = cases::samples_of({}, 5000, 1);
    samples.radiance[7].y = std::numeric_limits<double>::quiet_NaN();
    samples.radiance[8].y = -5.0;
    const FactoredLighting result = factorize(samples, {}, map_of(8), 1.0, 1);
    CHECK(result.fit[0].counts.non_finite == 0);
    CHECK(result.fit[1].counts.non_finite == 1);
    CHECK(result.fit[1].counts.negative == 1);
    CHECK(result.fit[1].counts.used == 4999);
    for (const double texel : texels_of(result.terms[0].t1, 1)) CHECK(std::isfinite(texel));
}
