#include "factor/environment_form.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factor/environment.hpp"
#include "texunit/cube_map.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/paraboloid.hpp"

using namespace twofold;

namespace {

constexpr std::array square_forms{EnvironmentForm::probe, EnvironmentForm::cube_cross,
                                  EnvironmentForm::cube_strip, EnvironmentForm::cube_openexr,
                                  EnvironmentForm::dual_paraboloid};

/// Width and height of a form's picture; `upright` is its other layout.
std::pair<int, int> size_of(EnvironmentForm form, int edge, bool upright) {
    const auto turned = [&](int w, int h) {
        return upright ? std::pair(h * edge, w * edge) : std::pair(w * edge, h * edge);
    };
    if (form == EnvironmentForm::latlong) return {4 * edge, 2 * edge};
    if (form == EnvironmentForm::probe) return {2 * edge, 2 * edge};
    if (form == EnvironmentForm::cube_cross) return turned(4, 3);
    if (form == EnvironmentForm::dual_paraboloid) return turned(2, 1);
    return turned(6, 1);
}

/// The orientation test map: red +x, dark red -x, green +y, dark green -y, blue +z, dark blue -z.
Rgb six_axes(Vec3 d) {
    const Vec3 a(std::fabs(d.x), std::fabs(d.y), std::fabs(d.z));
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    Rgb colour(0.0);
    colour[axis] = d[axis] > 0.0 ? 1.0 : 0.25;
    return colour;
}

/// The map in a form, by the formulas of docs/method.md written out once more, from texel to
/// direction.
FloatImage picture_of(EnvironmentForm form, int edge, bool upright, double guard, float outside) {
    const auto [width, height] = size_of(form, edge, upright);
    FloatImage image{width, height, 3,
                     std::vector<float>(static_cast<std::size_t>(3 * width * height), outside)};
    for (const SquareMap& map : maps_of(form, guard, width, height, "test"))
        for (int y = 0; y < map.size; ++y)
            for (int x = 0; x < map.size; ++x) {
                const MapPoint p =
                    map.at((2 * x + 1.0) / map.size - 1.0, (2 * y + 1.0) / map.size - 1.0);
                if (p.density == 0.0) continue;
                const auto at =
                    static_cast<std::size_t>(3 * ((map.top + y) * width + map.left + x));
                for (int c = 0; c < 3; ++c)
                    image.samples[at + static_cast<std::size_t>(c)] =
                        static_cast<float>(six_axes(p.direction)[c]);
            }
    return image;
}

Rgb total(const DistantLights& lights) {
    Rgb sum(0.0);
    for (std::size_t k = 0; k < lights.size(); ++k) sum += lights.weight(k);
    return sum;
}

MapPoint point_of(EnvironmentForm form, int width, int height, std::size_t map, double a,
                  double b) {
    return maps_of(form, 1.0, width, height, "test")[map].at(a, b);
}

}  // namespace

TEST_CASE("D07 six coloured axes lie in the world where they belong, in every form of map",
          "[hard][D07]") {
    for (const EnvironmentForm form : square_forms)
        for (const bool upright : {false, true}) {
            const EnvironmentSettings settings{4096, false, form, 0.875};
            const FloatImage image = picture_of(form, 32, upright, 0.875, 0.0F);
            const DistantLights lights = environment_of(image, settings, "test").lights;
            REQUIRE(lights.size() > 500);
            std::size_t wrong = 0;
            for (std::size_t k = 0; k < lights.size(); ++k) {
                const Rgb wanted = six_axes(lights.direction(k));
                const Rgb found = lights.weight(k);
                for (int c = 0; c < 3; ++c)
                    wrong += wanted[c] == 0.0 && found[c] > 0.5 * max_component(found) ? 1U : 0U;
            }
            INFO(static_cast<int>(form));
            CHECK(wrong < lights.size() / 50);  // cells on an edge between two colours
            // A sixth of the sphere in each: 4 pi / 6 (1 + 1/4) a channel.
            for (int c = 0; c < 3; ++c)
                CHECK(total(lights)[c] == Approx(4.0 * exact::pi / 6.0 * 1.25).epsilon(0.05));
        }
}

TEST_CASE("D07 forms look where their definitions say", "[hard][D07]") {
    using F = EnvironmentForm;
    const auto is = [](const MapPoint& p, Vec3 d) {
        return length(p.direction - normalized(d)) < 1e-9;
    };
    CHECK(is(point_of(F::probe, 8, 8, 0, 0.0, 0.0), Vec3(0, 0, -1)));
    CHECK(is(point_of(F::probe, 8, 8, 0, 0.5, 0.0), Vec3(1, 0, 0)));
    CHECK(is(point_of(F::probe, 8, 8, 0, 0.0, -0.5), Vec3(0, 1, 0)));
    CHECK(length(point_of(F::probe, 8, 8, 0, 1.0, 0.0).direction - Vec3(0, 0, 1)) < 1e-9);
    CHECK(is(point_of(F::dual_paraboloid, 8, 4, 0, 0.0, 0.0), Vec3(0, 0, 1)));
    CHECK(is(point_of(F::dual_paraboloid, 8, 4, 1, 0.0, 0.0), Vec3(0, 0, -1)));
    CHECK(is(point_of(F::dual_paraboloid, 8, 4, 1, 1.0, 0.0), Vec3(1, 0, 0)));
    CHECK(is(point_of(F::dual_paraboloid, 8, 4, 0, 0.0, -1.0), Vec3(0, 1, 0)));
    // A cross is one sheet: neighbours meet at their common edge.
    for (const bool upright : {false, true}) {
        const int w = upright ? 12 : 16, h = upright ? 16 : 12;
        const auto at = [&](std::size_t map, double a, double b) {
            return point_of(F::cube_cross, w, h, map, a, b);
        };
        CHECK(is(at(2, 0.0, 0.0), Vec3(0, 0, -1)));
        CHECK(is(at(3, 0.0, 0.0), Vec3(1, 0, 0)));
        CHECK(is(at(0, 0.3, 1.0), at(2, 0.3, -1.0).direction));
        CHECK(is(at(4, 0.3, -1.0), at(2, 0.3, 1.0).direction));
        CHECK(is(at(1, 1.0, 0.3), at(2, -1.0, 0.3).direction));
        CHECK(is(at(3, -1.0, 0.3), at(2, 1.0, 0.3).direction));
        if (upright)
            CHECK(is(at(5, 0.3, -1.0), at(4, 0.3, 1.0).direction));
        else
            CHECK(is(at(5, -1.0, 0.3), at(3, 1.0, 0.3).direction));
    }
    // A strip is OpenGL's cube map: the same face and the same place on it as texunit finds.
    for (std::size_t face = 0; face < 6; ++face) {
        const Vec3 d = point_of(F::cube_strip, 24, 4, face, 0.3, -0.6).direction;
        const ProjectiveCoordinates<double> st{d.x, d.y, d.z, 1.0};
        CHECK(static_cast<std::size_t>(cube_face(st)) == face);
        const auto on = on_face(cube_face(st), st);
        CHECK(on.s / on.q == Approx(0.65));
        CHECK(on.t / on.q == Approx(0.2));
    }
}

TEST_CASE("D06 what lies outside the disc of a probe or a paraboloid is not looked at",
          "[hard][D06]") {
    for (const EnvironmentForm form : {EnvironmentForm::probe, EnvironmentForm::dual_paraboloid})
        for (const float outside : {1e6F, -1.0F, std::numeric_limits<float>::quiet_NaN()})
            for (const int cells : {20, 300, 100000}) {
                const auto [width, height] = size_of(form, 24, false);
                FloatImage image{
                    width, height, 1,
                    std::vector<float>(static_cast<std::size_t>(width * height), outside)};
                for (const SquareMap& map : maps_of(form, 0.75, width, height, "test"))
                    for (int y = 0; y < map.size; ++y)
                        for (int x = 0; x < map.size; ++x)
                            if (map.at((2 * x + 1.0) / map.size - 1.0,
                                       (2 * y + 1.0) / map.size - 1.0)
                                    .density > 0.0)
                                image.samples[static_cast<std::size_t>((map.top + y) * width +
                                                                       map.left + x)] = 1.0F;
                const Environment e = environment_of(image, {cells, false, form, 0.75}, "test");
                CHECK(total(e.lights).x == Approx(4.0 * exact::pi).epsilon(1e-12));
                CHECK(e.report.solid_angle == Approx(4.0 * exact::pi).epsilon(1e-12));
                CHECK(e.report.negative == 0);
                CHECK(e.report.non_finite == 0);
            }
}

TEST_CASE("a picture that is not of its form is refused by its size") {
    const auto refusal = [](EnvironmentForm form, int width, int height) {
        const FloatImage image{width, height, 1,
                               std::vector<float>(static_cast<std::size_t>(width * height), 1.0F)};
        try {
            environment_of(image, {64, false, form, 1.0}, "e.exr");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    CHECK(refusal(EnvironmentForm::probe, 8, 7) ==
          "e.exr: 8 x 7 texels are not the square of an angular probe");
    CHECK(refusal(EnvironmentForm::cube_cross, 16, 16).find("cross of 4 x 3") != std::string::npos);
    CHECK(refusal(EnvironmentForm::cube_strip, 13, 2).find("strip of six") != std::string::npos);
    CHECK(refusal(EnvironmentForm::dual_paraboloid, 9, 4).find("pair of square") !=
          std::string::npos);
    CHECK(refusal(EnvironmentForm::cube_cross, 12, 16) == "accepted");
    CHECK(refusal(EnvironmentForm::cube_openexr, 1, 6) == "accepted");
}

TEST_CASE("lights are turned as the placement says, mirrored and scaled") {
    DistantLights lights;
    lights.push_back(Vec3(0.0, 0.0, -1.0), Rgb(1.0));  // the picture's forward
    lights.push_back(Vec3(0.0, 1.0, 0.0), Rgb(2.0));   // up
    lights.push_back(Vec3(1.0, 0.0, 0.0), Rgb(3.0));   // right
    EnvironmentPlacement placement{Vec3(2.0, 0.0, 0.0), Vec3(0.5, 0.0, 3.0), false, 10.0};
    const DistantLights turned = placed(lights, placement);
    CHECK(length(turned.direction(0) - Vec3(1.0, 0.0, 0.0)) < 1e-12);
    CHECK(length(turned.direction(1) - Vec3(0.0, 0.0, 1.0)) < 1e-12);
    CHECK(length(turned.direction(2) - Vec3(0.0, -1.0, 0.0)) < 1e-12);
    CHECK(turned.weight(2) == Rgb(30.0));
    placement.mirror = true;
    CHECK(length(placed(lights, placement).direction(2) - Vec3(0.0, 1.0, 0.0)) < 1e-12);
    CHECK(placed(lights, {}).x == lights.x);
    placement.up = Vec3(-1.0, 0.0, 0.0);
    CHECK_THROWS_WITH(placed(lights, placement), Catch::Contains("span no plane"));
}
