#include <catch2/catch.hpp>

#include "scenes/lighting.hpp"
#include "tests/data_folder.hpp"
#include "tests/scenes/scene_text.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"

using namespace twofold;
using namespace twofold::scene_text;

namespace {

DistantLights lights_of(const std::string& environment, const std::filesystem::path& folder) {
    const std::string text =
        R"({"environment": )" + environment + R"(, "meshes": {"q": {"quad": {}}},
                                 "passes": [{"mesh": "q"}]})";
    return make_lights(parse_scene(text, "x.json", folder)).lights;
}

Rgb irradiance(const DistantLights& lights, Vec3 n) {
    Rgb sum(0.0);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const double cosine = dot(n, lights.direction(k));
        if (cosine > 0.0) sum += cosine * lights.weight(k);
    }
    return sum;
}

}  // namespace

TEST_CASE("D07 a scene's environment is turned, mirrored and scaled as it says", "[hard][D07]") {
    const TemporaryFolder folder;
    // A probe: bright to the right of the centre.
    FloatImage image{16, 16, 3, std::vector<float>(3 * 256, 0.0F)};
    for (std::size_t c = 0; c < 3; ++c) image.samples[3 * (16 * 8 + 12) + c] = 1.0F;
    write_file_atomically(folder / "p.exr", encode_exr(image));
    const auto brightest = [&](const std::string& more) {
        const DistantLights lights = lights_of(R"({"probe": "p.exr")" + more + "}", folder.path());
        std::size_t best = 0;
        for (std::size_t k = 0; k < lights.size(); ++k)
            if (lights.g[k] > lights.g[best]) best = k;
        return std::pair(lights.direction(best), lights.g[best]);
    };
    const auto plain = brightest("");
    CHECK(plain.first.x > 0.95);
    const auto turned =
        brightest(R"(, "scale": 4, "orientation": {"forward": [0, 1, 0], "up": [0, 0, 1]})");
    CHECK(turned.first.x > 0.95);
    CHECK(turned.second == Approx(4.0 * plain.second));
    CHECK(brightest(R"(, "orientation": {"forward": [1, 0, 0]})").first.z > 0.95);
    CHECK(brightest(R"(, "orientation": {"mirror": true})").first.x < -0.95);
}

TEST_CASE("D08 OpenEXR's cube, whose data window is not its display window, is refused by name",
          "[hard][D08]") {
    const auto data = data_folder();
    if (!data) return;
    CHECK_THROWS_WITH(
        lights_of(R"({"cube_openexr": "OrientationCube.exr"})", *data / "env/openexr-images"),
        Catch::Contains("data window and display window differ"));
}

TEST_CASE("D07 OpenEXR's orientation pattern turns with its orientation", "[hard][D07]") {
    const auto data = data_folder();
    if (!data) return;
    const auto folder = *data / "env/openexr-images";
    const DistantLights plain = lights_of(R"({"latlong": "OrientationLatLong.exr"})", folder);
    const DistantLights turned = lights_of(
        R"({"latlong": "OrientationLatLong.exr", "orientation": {"forward": [0, 0, 1]}})", folder);
    for (const Vec3 n : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        for (int c = 0; c < 3; ++c)
            CHECK(irradiance(turned, Vec3(-n.x, n.y, -n.z))[c] ==
                  Approx(irradiance(plain, n)[c]).epsilon(1e-9));
}
