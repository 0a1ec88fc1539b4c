#include "factor/scale.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/factorize.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

FactorSettings settings_of(ScaleRule rule) {
    FactorSettings settings;
    settings.map_size = 16;
    settings.scale = rule;
    return settings;
}

FactoredLighting factored(const FactorSettings& settings, double white) {
    const cases::Phong phong{0.3, 0.7, 20.0, cases::many_lights()};
    return factorize(cases::samples_of(phong, 20000, 1), cases::samples_of(phong, 4000, 2),
                     settings, white, 2);
}

/// The constant that is drawn.
double drawn(const FactoredLighting& f) {
    const ProductTerm& term = f.terms[0];
    return term.scale_color.x * term.combiner_scale * std::exp2(f.doubling_passes);
}

}  // namespace

TEST_CASE("whatever the rule, units and constant multiply to the same product") {
    const FactoredLighting maximum = factored(settings_of(ScaleRule::maximum), 4.0);
    for (const ScaleRule rule :
         {ScaleRule::maximum, ScaleRule::percentile, ScaleRule::best_split}) {
        const FactoredLighting f = factored(settings_of(rule), 4.0);
        const ProductTerm& term = f.terms[0];
        CAPTURE(static_cast<int>(rule));
        CHECK(drawn(f) == Approx(term.max1.x * term.max2.x / f.white).epsilon(1e-12));
        CHECK(term.c.x == Approx(maximum.terms[0].c.x).epsilon(1e-12));
        CHECK(term.scale_color.x <= 1.0);
    }
}

TEST_CASE("a percentile takes the brightest texels down and says how many") {
    FactorSettings settings = settings_of(ScaleRule::percentile);
    settings.scale_percentile = 95.0;
    const FactoredLighting f = factored(settings, 4.0);
    CHECK(f.terms[0].t1.loss[0].clipped_share == Approx(0.05).margin(0.01));
    CHECK(f.terms[0].t2.loss[0].clipped_share == Approx(0.05).margin(0.01));
    CHECK(drawn(f) < f.terms[0].c.x);
    CHECK(factored(settings_of(ScaleRule::maximum), 4.0).terms[0].t1.loss[0].clipped_share == 0.0);
}

TEST_CASE("Q03 the best split needs no doubling pass where the maxima alone do", "[hard][Q03]") {
    // Most of the product is below white; only the maxima of the two maps together exceed it.
    for (const double white : {0.6, 1.0, 4.0}) {
        const FactoredLighting maximum = factored(settings_of(ScaleRule::maximum), white);
        const FactoredLighting best = factored(settings_of(ScaleRule::best_split), white);
        CAPTURE(white, maximum.terms[0].c.x, drawn(maximum), drawn(best));
        CHECK(best.terms[0].combiner_scale * std::exp2(best.doubling_passes) <=
              maximum.terms[0].combiner_scale * std::exp2(maximum.doubling_passes));
        CHECK(best.fit[0].byte_rms < 0.5);
    }
}

TEST_CASE("F11 a black channel leaves the best split of the others alone", "[hard][F11]") {
    LightingSamples samples = cases::samples_of({}, 8000, 1);
    const FactorSettings settings = settings_of(ScaleRule::best_split);
    const FactoredLighting grey = factorize(samples, {}, settings, 1.0, 2);
    for (Rgb& rgb : samples.radiance) rgb.x = 0.0;
    const FactoredLighting no_red = factorize(samples, {}, settings, 1.0, 2);
    CHECK(no_red.terms[0].scale_color.x == 0.0);
    CHECK(no_red.terms[0].scale_color.y == grey.terms[0].scale_color.y);
    CHECK(no_red.terms[0].combiner_scale == grey.terms[0].combiner_scale);
    CHECK(no_red.terms[0].max1.y == grey.terms[0].max1.y);
}

TEST_CASE("doubling that one term needs is shared by the others") {
    ScaleSplit split = split_scale(Rgb(3.0, 1.0, 0.5));
    REQUIRE(split.combiner_scale == 4);
    split = with_doubling(split, 1);
    CHECK(split.combiner_scale == 2);
    CHECK(split.color.x == 0.75);
    split = with_doubling(split, 3);
    CHECK(split.combiner_scale == 1);
    CHECK(split.color.x == 0.375);
    CHECK(split.doubling_passes == 3);
}

TEST_CASE("what a combiner may not scale by goes into doubling passes") {
    for (const int largest : {1, 2, 4}) {
        CAPTURE(largest);
        const ScaleSplit split = split_scale(Rgb(3.0, 1.0, 0.5), largest);
        CHECK(split.combiner_scale == largest);
        CHECK(split.combiner_scale << split.doubling_passes == 4);
        CHECK(split.color.x == 0.75);
        CHECK(split.warnings.empty() == (largest == 4));
        CHECK(split_scale(Rgb(0.5), largest).combiner_scale == 1);
    }
}

TEST_CASE("no rule scales by more than the combiner may, and the product stays") {
    for (const ScaleRule rule :
         {ScaleRule::maximum, ScaleRule::percentile, ScaleRule::best_split}) {
        CAPTURE(static_cast<int>(rule));
        FactorSettings settings = settings_of(rule);
        const FactoredLighting free = factored(settings, 1.0);
        settings.combiner_scale = 1;
        const FactoredLighting held = factored(settings, 1.0);
        CHECK(held.terms[0].combiner_scale == 1);
        const ProductTerm& term = held.terms[0];
        CHECK(drawn(held) == Approx(term.max1.x * term.max2.x / held.white).epsilon(1e-12));
        CHECK(free.terms[0].combiner_scale > 1);
    }
    FactorSettings settings;
    settings.combiner_scale = 3;
    CHECK_THROWS_WITH(factored(settings, 4.0), Catch::Contains("combiner_scale is 3"));
}
