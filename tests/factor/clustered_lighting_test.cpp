#include "factor/clustered_lighting.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "factor/light_tree.hpp"
#include "factor/lighting.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

const ModifiedPhong diffuse{Rgb(0.8), Rgb(0.0), 1.0};
const ModifiedPhong phong50{Rgb(0.3), Rgb(0.7), 50.0};

CookTorrance metal(double m) { return {Rgb(0.3), Rgb(0.7), Rgb(0.04), {{m, 1.0}}}; }

/// A sky of uneven brightness over 96 x 48 texels with, at one of them, a sun.
Environment sky(float sun) {
    FloatImage image{96, 48, 3, std::vector<float>(std::size_t{96} * 48 * 3)};
    for (std::size_t i = 0; i < image.samples.size(); ++i)
        image.samples[i] = static_cast<float>(0.2 + random_unit(11, i / 30));
    if (sun > 0.0F)
        for (std::size_t c = 0; c < 3; ++c) image.samples[3 * (12 * 96 + 30) + c] = sun;
    return latitude_longitude(image, {.cells = 96 * 48}, "sky");
}

/// Root mean square of the difference over that of the full sum, over pairs that no setting saw.
double relative_difference(const Brdf& brdf, const DistantLights& lights,
                           const ClusteredLighting& clustered) {
    const auto at = surface_views(500, 21);
    const auto full = outgoing_radiance(brdf, lights, at, 2);
    const auto merged = clustered.radiance(at, 2);
    double square = 0.0, all = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        square += dot(merged[i] - full[i], merged[i] - full[i]);
        all += dot(full[i], full[i]);
    }
    return std::sqrt(square / all);
}

}  // namespace

TEST_CASE("a light tree keeps energy, centroid and second moment, and ends in the lights") {
    const DistantLights lights = sky(1e6F).lights;
    const LightTree tree = light_tree(lights);
    std::size_t leaves = 0;
    Rgb total(0.0), in_roots(0.0);
    for (std::size_t k = 0; k < lights.size(); ++k) total += lights.weight(k);
    for (std::uint32_t k = 0; k < tree.roots; ++k) in_roots += tree.nodes[k].weight;
    CHECK(in_roots.x == Approx(total.x).epsilon(1e-12));
    for (const LightNode& node : tree.nodes) {
        if (node.children == 0) {
            ++leaves;
            CHECK(node.radius == 0.0);
            continue;
        }
        Rgb sum(0.0);
        for (std::uint32_t k = 0; k < node.children; ++k) sum += tree.nodes[node.child + k].weight;
        REQUIRE(sum.y == Approx(node.weight.y).epsilon(1e-12));
        // Equal channels have one centroid: no first moment is left.
        REQUIRE(node.first <= 1e-9 * node.weight.x);
        REQUIRE(node.second <= node.weight.x * node.radius * node.radius * (1.0 + 1e-12));
    }
    CHECK(leaves == lights.size());
}

TEST_CASE("the clustered sum stays within its tolerance, and the bound above its error") {
    for (const float sun : {0.0F, 1e6F}) {
        const DistantLights lights = sky(sun).lights;
        for (const Brdf& brdf :
             {Brdf(diffuse), Brdf(phong50), Brdf(metal(0.2)), Brdf(metal(0.05))}) {
            const ClusteredLighting clustered(brdf, lights, 2e-3, 2);
            const ClusterReport& report = clustered.report();
            const double error = relative_difference(brdf, lights, clustered);
            CAPTURE(sun, brdf.index(), report.lights, report.bound, report.relative_rms);
            CHECK(error <= 2e-3);
            CHECK(error <= report.bound);
            CHECK(report.relative_rms <= report.bound);
            CHECK(report.lights < 0.25 * static_cast<double>(lights.size()));
        }
    }
}

TEST_CASE("fewer lights than a tolerance needs are summed one by one") {
    DistantLights three;
    three.push_back(normalized(Vec3(0.1, 0.2, 0.9)), Rgb(1.0, 0.5, 0.25));
    three.push_back(normalized(Vec3(-0.9, 0.2, 0.1)), Rgb(0.0));
    three.push_back(normalized(Vec3(0.5, -0.8, 0.3)), Rgb(0.0, 2.0, 1.0));
    const ClusteredLighting clustered(phong50, three, 1e-6, 1);
    CHECK(clustered.report().lights <= 2.0);  // the black one is none
    CHECK(clustered.report().bound == 0.0);
    CHECK(relative_difference(phong50, three, clustered) < 1e-15);
    const ClusteredLighting black(phong50, DistantLights{}, 1e-3, 1);
    CHECK(black.radiance(surface_views(3, 1), 1) == std::vector<Rgb>(3, Rgb(0.0)));
}

TEST_CASE("a smaller tolerance gives a smaller bound and error") {
    const DistantLights lights = sky(0.0F).lights;
    const ClusteredLighting coarse(metal(0.2), lights, 1e-2, 2), fine(metal(0.2), lights, 1e-4, 2);
    CHECK(fine.report().bound < 0.1 * coarse.report().bound);
    CHECK(fine.report().relative_rms < 0.1 * coarse.report().relative_rms);
    CHECK(fine.report().lights > coarse.report().lights);
}

TEST_CASE("the clustered sum of an even environment is that of its lights") {
    const DistantLights lights = constant_environment(Rgb(1.0), 2048);
    const ClusteredLighting clustered(diffuse, lights, 2e-3, 1);
    CHECK(relative_difference(diffuse, lights, clustered) < 2e-3);
    // One cell after another holds lights of one radiance: n.l alone varies, and is nearly linear.
    for (const Rgb& radiance : clustered.radiance(surface_views(200, 3), 1))
        CHECK(radiance.x == Approx(0.8).epsilon(1e-2));
}

TEST_CASE("the clustered sum has the same bits at 1, 2 and 7 threads") {
    const DistantLights lights = sky(1e3F).lights;
    const auto at = surface_views(300, 5);
    const auto one = ClusteredLighting(metal(0.2), lights, 2e-3, 1).radiance(at, 1);
    for (const int threads : {2, 7})
        CHECK(ClusteredLighting(metal(0.2), lights, 2e-3, threads).radiance(at, threads) == one);
}
