#include "factor/environment.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

using namespace twofold;

namespace {

constexpr double four_pi = 4.0 * exact::pi;

FloatImage even_map(int width, int height, int channels, float value) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                       static_cast<std::size_t>(channels);
    return {width, height, channels, std::vector<float>(count, value)};
}

FloatImage with_value(FloatImage image, int x, int y, int channel, float value) {
    image.samples[static_cast<std::size_t>((y * image.width + x) * image.channels + channel)] =
        value;
    return image;
}

double total_weight(const DistantLights& lights) {
    double sum = 0.0;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        sum += lights.g[k];
    }
    return sum;
}

std::size_t brightest_light(const DistantLights& lights) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < lights.size(); ++k) {
        best = lights.g[k] > lights.g[best] ? k : best;
    }
    return best;
}

Environment read(const FloatImage& image, EnvironmentSettings settings = {}) {
    return latitude_longitude(image, settings, "test.hdr");
}

}  // namespace

TEST_CASE("S05 Solid angles sum to 4 pi at every size", "[environment][S05]") {
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {1000, 500}, {512, 256}, {7, 3}}) {
        const Environment sky = read(even_map(width, height, 3, 1.0F));
        CHECK(sky.report.solid_angle == Approx(four_pi).epsilon(1e-14));
        CHECK(total_weight(sky.lights) == Approx(four_pi).epsilon(1e-13));
        CHECK(sky.report.cells == static_cast<int>(sky.lights.size()));
        CHECK(sky.lights.size() <= 8192);
    }
}

TEST_CASE("The box is the smallest that leaves few enough cells", "[environment]") {
    CHECK(read(even_map(1024, 512, 3, 1.0F)).report.box == 8);
    CHECK(read(even_map(1024, 512, 3, 1.0F)).lights.size() == 8192);
    CHECK(read(even_map(1000, 500, 3, 1.0F)).report.box ==
          8);  // 125 x 63 cells, the last row partial
    CHECK(read(even_map(1000, 500, 3, 1.0F)).lights.size() == 125 * 63);
    CHECK(read(even_map(128, 64, 3, 1.0F)).report.box == 1);
    CHECK(read(even_map(128, 64, 3, 1.0F), {1, false}).lights.size() == 1);
}

TEST_CASE("S08 A picture of few texels is cut finer, each texel constant", "[environment][S08]") {
    const Environment sky = read(even_map(1, 1, 1, 3.0F));
    CHECK(sky.report.split == 90);
    const ModifiedPhong chalk{Rgb(0.5), Rgb(0.0), 1.0};
    for (const SurfaceView& at : surface_views(50, 0)) {
        REQUIRE(outgoing_radiance(chalk, sky.lights, at).x == Approx(1.5).epsilon(5e-3));
    }
}

TEST_CASE("S05 Under a constant map radiance is constant, poles and seam included",
          "[environment][S05]") {
    const ModifiedPhong chalk{Rgb(1.0), Rgb(0.0), 1.0};
    for (const auto& [width, height] : {std::pair(2, 1), {1000, 500}}) {
        const Environment sky = read(even_map(width, height, 3, 1.0F));
        for (const Vec3 n : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1),
                             normalized(Vec3(1e-3, 1, 1e-3)), normalized(Vec3(1e-3, 0, 1))}) {
            CHECK(outgoing_radiance(chalk, sky.lights, {n, n}).x == Approx(1.0).epsilon(2e-3));
        }
    }
}

TEST_CASE("Averaging keeps the energy", "[environment]") {
    FloatImage image = even_map(200, 100, 3, 0.5F);
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        image.samples[i] = static_cast<float>((i * 7919) % 1000) * 0.01F;
    }
    const double full = total_weight(read(image, {20000, false}).lights);
    for (const int cells : {1, 7, 100, 2048, 8192}) {
        CHECK(total_weight(read(image, {cells, false}).lights) == Approx(full).epsilon(1e-13));
    }
}

TEST_CASE("D07 A bright texel is found in its direction", "[environment][D07]") {
    // Width 64: column 32 begins at forward (-z), 48 at right (+x), 16 at left (-x), 0 at back
    // (+z).
    struct Axis {
        int x, y;
        Vec3 direction;
    };
    for (const Axis& axis :
         {Axis{32, 16, Vec3(0, 0, -1)}, Axis{48, 16, Vec3(1, 0, 0)}, Axis{16, 16, Vec3(-1, 0, 0)},
          Axis{0, 16, Vec3(0, 0, 1)}, Axis{5, 0, Vec3(0, 1, 0)}, Axis{5, 31, Vec3(0, -1, 0)}}) {
        const FloatImage image = with_value(even_map(64, 32, 3, 0.0F), axis.x, axis.y, 1, 1e6F);
        const DistantLights lights = read(image, {2048, false}).lights;
        const Vec3 found = lights.direction(brightest_light(lights));
        CHECK(dot(found, axis.direction) > 0.99);
        CHECK(std::fabs(length(found) - 1.0) < 1e-15);
    }
}

TEST_CASE("D07 A painted disc is found where it was painted", "[environment][D07]") {
    for (const Vec3 d : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, -2, -3)}) {
        const FloatImage image = paint({Rgb(0.0), {{d, 8.0, Rgb(1.0)}}}, 256, 128);
        const DistantLights lights = read(image).lights;
        Vec3 sum(0.0);
        for (std::size_t k = 0; k < lights.size(); ++k) {
            sum += lights.weight(k).y * lights.direction(k);
        }
        CHECK(dot(normalized(sum), normalized(d)) > 0.9995);
    }
}

TEST_CASE("D01 F02 Negative radiance is raised to zero and counted", "[environment][D01][F02]") {
    FloatImage ring = with_value(even_map(64, 32, 3, 0.0F), 10, 9, 0, 30000.0F);
    ring = with_value(std::move(ring), 11, 9, 0, -3894.0F);
    ring = with_value(std::move(ring), 9, 9, 2, -1e-30F);
    ring = with_value(std::move(ring), 8, 9, 2, -0.0F);
    const Environment sky = read(ring);
    CHECK(sky.report.negative == 2);
    CHECK(sky.report.least_value == -3894.0);
    CHECK(sky.report.negative_share == 2.0 / (64.0 * 32.0 * 3.0));
    for (std::size_t k = 0; k < sky.lights.size(); ++k) {
        REQUIRE(sky.lights.r[k] >= 0.0);
        REQUIRE(!std::signbit(sky.lights.b[k]));
    }
}

TEST_CASE("F03 A value that is not finite is an error naming file, texel and channel",
          "[environment][F03]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const FloatImage good = even_map(8, 4, 3, 1.0F);
    CHECK_THROWS_WITH(read(with_value(good, 0, 0, 0, nan)),
                      Catch::Contains("test.hdr") && Catch::Contains("(0, 0), red"));
    CHECK_THROWS_WITH(read(with_value(good, 3, 2, 1, infinity)), Catch::Contains("(3, 2), green"));
    CHECK_THROWS_WITH(read(with_value(good, 7, 3, 2, -infinity)), Catch::Contains("(7, 3), blue"));
    try {
        read(with_value(good, 7, 3, 2, nan));
        FAIL("no error");
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::bad_file);
    }
}

TEST_CASE("F03 Repair reads what is not finite as zero and counts it", "[environment][F03]") {
    FloatImage image =
        with_value(even_map(8, 4, 3, 1.0F), 3, 2, 1, std::numeric_limits<float>::quiet_NaN());
    image = with_value(std::move(image), 4, 2, 0, std::numeric_limits<float>::infinity());
    const Environment sky = read(image, {8192, true});
    CHECK(sky.report.non_finite == 2);
    CHECK(sky.report.negative == 0);
    CHECK(total_weight(sky.lights) < four_pi);
    CHECK(total_weight(sky.lights) > 0.9 * four_pi);
}

TEST_CASE(
    "D08 Alpha is ignored, also where it is not finite, and grey is read as three equal channels",
    "[environment][D08]") {
    const FloatImage rgba =
        with_value(even_map(8, 4, 4, 1.0F), 2, 2, 3, std::numeric_limits<float>::quiet_NaN());
    CHECK(read(rgba).report.ignored_channels == 1);
    const DistantLights grey = read(even_map(8, 4, 1, 1.0F)).lights;
    CHECK(grey.r == grey.g);
    CHECK(grey.r == read(rgba).lights.b);
}

TEST_CASE("Pictures of impossible size are refused", "[environment]") {
    CHECK_THROWS_AS(read(FloatImage{}), Error);
    CHECK_THROWS_AS(read(even_map(4, 2, 2, 1.0F)), Error);
    CHECK_THROWS_AS(read(FloatImage{4, 2, 3, std::vector<float>(23)}), Error);
    CHECK_THROWS_AS(read(even_map(4, 2, 3, 1.0F), {0, false}), Error);
}

TEST_CASE("S06 S07 The sun is kept and its share is reported", "[environment][S06][S07]") {
    const Environment sky = read(with_value(even_map(512, 256, 1, 1.0F), 100, 64, 0, 1e6F));
    CHECK(sky.report.brightest == std::array<int, 2>{100, 64});
    const double texel = 2.0 * exact::pi / 512.0 *
                         (exact::cos(exact::pi * 64 / 256) - exact::cos(exact::pi * 65 / 256));
    const double sun = 1e6 * texel;
    CHECK(sky.report.brightest_share == Approx(sun / (sun + four_pi - texel)).epsilon(1e-12));
    CHECK(total_weight(sky.lights) == Approx(sun + four_pi - texel).epsilon(1e-12));
}

TEST_CASE("S09 A black environment is no error", "[environment][S09]") {
    const Environment night = read(even_map(64, 32, 3, 0.0F));
    CHECK(night.report.brightest_share == 0.0);
    CHECK(total_weight(night.lights) == 0.0);
    CHECK(averaging_cost(ModifiedPhong{}, even_map(64, 32, 3, 0.0F), {}, surface_views(4, 0), 1) ==
          0.0);
}

TEST_CASE("What averaging costs falls with the number of cells", "[environment]") {
    const PaintedEnvironment room{
        Rgb(0.1),
        {{Vec3(1, 2, -1), 15.0, Rgb(20.0)}, {Vec3(-2, 1, 0), 10.0, Rgb(5.0, 10.0, 20.0)}}};
    const FloatImage image = paint(room, 256, 128);
    const auto views = surface_views(32, 0);
    const ModifiedPhong matt{Rgb(1.0), Rgb(0.0), 1.0}, shiny{};
    const double coarse = averaging_cost(matt, image, {512, false}, views, 2);
    const double fine = averaging_cost(matt, image, {8192, false}, views, 2);
    CHECK(fine < coarse);
    CHECK(fine < 2e-3);
    CHECK(averaging_cost(shiny, image, {8192, false}, views, 2) < 2e-2);
    CHECK(averaging_cost(shiny, image, {32768, false}, views, 2) == 0.0);
}

TEST_CASE("A disc that no texel sees, and lights without direction, are refused", "[environment]") {
    CHECK_THROWS_WITH(paint({Rgb(0.0), {{Vec3(1, 1, 1), 0.01, Rgb(1.0)}}}, 16, 8),
                      Catch::Contains("disc 0"));
    CHECK_THROWS_AS(paint({Rgb(0.0), {{Vec3(0.0), 10.0, Rgb(1.0)}}}, 16, 8), Error);
    CHECK_THROWS_AS(paint({Rgb(-1.0), {}}, 16, 8), Error);
    const DirectionalLight nowhere{Vec3(0.0), Rgb(1.0)}, dark{Vec3(1.0, 0.0, 0.0), Rgb(-1.0)};
    CHECK_THROWS_AS(directional_lights(std::span(&nowhere, 1)), Error);
    CHECK_THROWS_AS(directional_lights(std::span(&dark, 1)), Error);
}

TEST_CASE("A disc of 180 degrees is the whole sphere, and a later disc covers an earlier one",
          "[environment]") {
    const FloatImage image = paint(
        {Rgb(0.0), {{Vec3(1, 0, 0), 180.0, Rgb(1.0)}, {Vec3(1, 0, 0), 180.0, Rgb(2.0)}}}, 16, 8);
    for (const float value : image.samples) {
        REQUIRE(value == 2.0F);
    }
}
