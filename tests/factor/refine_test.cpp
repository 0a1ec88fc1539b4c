#include "factor/refine.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/factorize.hpp"
#include "factor/vector_arithmetic.hpp"
#include "factor_cases.hpp"

using namespace twofold;

namespace {

FactorSettings refined_settings(int terms, int steps) {
    FactorSettings settings;
    settings.map_size = 16;
    settings.smoothness = 0.3;
    settings.terms = terms;
    settings.refinement = steps;
    return settings;
}

/// Three lights, each of which makes a product of its own.
LightingSamples three_lights(int count, std::uint64_t sequence) {
    const cases::Phong phong{0.5,
                             0.5,
                             10.0,
                             {normalized(Vec3{0.3, 0.5, 0.8}), normalized(Vec3{-0.8, 0.1, 0.4}),
                              normalized(Vec3{0.2, -0.9, -0.1})}};
    return cases::samples_of(phong, count, sequence);
}

double error_of(const LightingSamples& fit, const LightingSamples& held_out,
                const FactorSettings& settings) {
    return factorize(fit, held_out, settings, 2.0, 2).fit[0].relative_rms;
}

std::vector<float> reds_of(const FactorMap& map, std::size_t face) {
    std::vector<float> reds;
    for (const Rgba32f& texel : std::get<std::vector<Rgba32f>>(map.real[face].texels))
        reds.push_back(texel[0]);
    return reds;
}

}  // namespace

TEST_CASE("every step of the refinement lowers its objective, and the held-out error falls") {
    const LightingSamples fit = cases::samples_of({}, 20000, 1),
                          held = cases::samples_of({}, 5000, 2);
    const double before = error_of(fit, held, refined_settings(1, 0));
    const double after = error_of(fit, held, refined_settings(1, 4));
    CHECK(after < 0.75 * before);

    const FactorSettings settings = refined_settings(1, 4);
    const LogRows left = log_rows(fit.at, settings);
    std::vector<double> radiance;
    for (const Rgb& rgb : fit.radiance) radiance.push_back(rgb.x);
    const ChannelRows right = channel_rows(left, radiance, settings, 2.0);
    const Refined refined = refine(product_rows(left), product_target(right, left.samples, 0.75),
                                   Vector(left.matrix.columns(), -0.5), 5, 1);
    REQUIRE(refined.objective.size() > 2);
    for (std::size_t n = 1; n < refined.objective.size(); ++n)
        CHECK(refined.objective[n] < refined.objective[n - 1]);
}

TEST_CASE("the parts of a divided product add up to it at every texel") {
    const MapShape shape{8, 0.875};
    Vector x(2 * shape.texels());
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = std::sin(0.7 * static_cast<double>(j));
    const Vector parts = divided_terms(x, 3, shape);
    REQUIRE(parts.size() == 3 * x.size());
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(parts[k * x.size() + j] == x[j]);
            sum += std::exp(parts[k * x.size() + shape.texels() + j]);
        }
        CHECK(sum == Approx(std::exp(x[shape.texels() + j])).epsilon(1e-12));
    }
}

TEST_CASE("three positive products hold three lights that one cannot", "[long]") {
    const LightingSamples fit = three_lights(20000, 1), held = three_lights(5000, 2);
    const double one = error_of(fit, held, refined_settings(1, 8));
    const double three = error_of(fit, held, refined_settings(3, 8));
    CHECK(one > 0.1);
    CHECK(three < 0.4 * one);
}

TEST_CASE("sums of products have the same bits at 1 and 7 threads", "[long]") {
    FactorSettings settings = refined_settings(2, 2);
    settings.view_knots = 24;
    const LightingSamples fit = three_lights(6000, 1);
    const FactoredLighting one = factorize(fit, {}, settings, 2.0, 1);
    const FactoredLighting many = factorize(fit, {}, settings, 2.0, 7);
    REQUIRE(one.terms.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t face = 0; face < 2; ++face) {
            CHECK(reds_of(one.terms[k].t1, face) == reds_of(many.terms[k].t1, face));
            CHECK(reds_of(one.terms[k].t2, face) == reds_of(many.terms[k].t2, face));
        }
        CHECK(one.terms[k].view == many.terms[k].view);
        CHECK(one.terms[k].c == many.terms[k].c);
    }
    CHECK(one.fit[0].relative_rms == many.fit[0].relative_rms);
}

TEST_CASE("several products without a refinement are refused by name") {
    CHECK_THROWS_WITH(error_of(three_lights(100, 1), {}, refined_settings(2, 0)),
                      Catch::Matchers::Contains("terms is 2 but refinement is 0"));
}
