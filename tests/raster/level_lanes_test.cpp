#include <catch2/catch.hpp>

#include "raster/coverage.hpp"
#include "raster/fast_plan.hpp"
#include "raster/interpolate.hpp"
#include "raster/level_bounds.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/presets.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

/// Noise in every level, so that no level looks like another.
Texture noise_with_mipmaps(int width, int height) {
    Texture texture{width, height, noise(width, height)};
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        texture.mipmaps.push_back({width, height, noise(width, height)});
    }
    return texture;
}

/// Level k is white if k is odd, else black: a pixel shows the share of one of them.
Texture black_and_white_levels(int edge) {
    const auto image = [](int side, int level) {
        const auto c = static_cast<std::uint8_t>(level % 2 == 0 ? 0 : 255);
        return std::vector<Rgba8>(static_cast<std::size_t>(side * side), Rgba8{c, c, c, 255});
    };
    Texture texture{edge, edge, image(edge, 0)};
    int level = 1;
    for (int side = edge / 2; side > 0; side /= 2, ++level)
        texture.mipmaps.push_back({side, side, image(side, level)});
    return texture;
}

/// A square of two triangles that fills the picture, deeper at its right and upper sides; `times`
/// copies of the texture.
Frame receding(int size, double times, Texture texture, const TextureUnitState& unit) {
    Mesh mesh = rectangle(0, 0, size, size);
    for (Vec4& c : mesh.texcoords[0]) c = {times * c.x, times * c.y, 0.0, 1.0 + 1.5 * c.x + c.y};
    PassState state;
    state.units[0] = unit;
    state.units[0]->texture = 0;
    Frame frame = pixel_frame(size, size, mesh, state);
    frame.textures = {std::move(texture)};
    return frame;
}

std::vector<TextureUnitState> units_of_all_filters() {
    std::vector<TextureUnitState> units;
    for (const Filter min : {Filter::nearest, Filter::linear})
        for (const Filter mag : {Filter::nearest, Filter::linear})
            for (const MipFilter mip : {MipFilter::off, MipFilter::nearest, MipFilter::linear})
                for (const double bias : {-33.0, -1.0, 0.0, 0.5, 1.3, 4.0}) {
                    TextureUnitState unit;
                    unit.min_filter = min;
                    unit.mag_filter = mag;
                    unit.mip_filter = mip;
                    unit.lod_bias = bias;
                    units.push_back(unit);
                }
    return units;
}

struct Corner {
    WindowPoint point;
    std::array<double, 4> coords;
};

/// Three corners within 16 pixels in snap units of 1/16, far from one q to the other now and then.
std::array<Corner, 3> random_corners(std::uint64_t number) {
    std::array<Corner, 3> corners;
    std::uint64_t k = 0;
    const auto real = [&](double low, double high) {
        return low + (high - low) * random_unit(number, k++);
    };
    for (Corner& c : corners) {
        c.point.x = static_cast<std::int64_t>(real(0, 256));
        c.point.y = static_cast<std::int64_t>(real(0, 256));
        for (double& x : c.coords) x = real(-2, 2);
        c.coords[3] = real(0.2, number % 2 == 0 ? 0.3 : 4.0);
    }
    return corners;
}

/// squared_scale() at a pixel, as the reference finds it.
double scale_at(const std::array<Corner, 3>& corners, const TriangleSetup& setup,
                const EdgeValues& edge) {
    std::array<WindowVertex<Ideal64>, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
        v[k].inverse_w = 1.0;
        v[k].coords[0] = corners[k].coords;
    }
    const auto point = [&](int dx, int dy) {
        const auto at = interpolate_coords<Ideal64>(moved(edge, setup, 4, dx, dy), v, 0);
        return texel_point(Addressing{Wrap::repeat, Wrap::repeat}, at, 64, 32);
    };
    return squared_scale(point(0, 0), point(1, 0), point(0, 1));
}

/// The bound, from the same corners.
double bound_of(const std::array<Corner, 3>& corners, const TriangleSetup& setup) {
    CoordinateSteps steps{static_cast<double>(setup.doubled_area), {}, {}, {1.0, 1.0, 1.0}};
    for (std::size_t k = 0; k < 3; ++k) {
        steps.dx[k] = 16.0 * static_cast<double>(setup.edge[k].a);
        steps.dy[k] = 16.0 * static_cast<double>(setup.edge[k].b);
    }
    return squared_scale_bound<double>(
        steps, {&corners[0].coords, &corners[1].coords, &corners[2].coords}, {64.0, 32.0});
}
}  // namespace

TEST_CASE("Vectors choose levels by every filter as the reference does", "[fast]") {
    for (const TextureUnitState& unit : units_of_all_filters())
        for (const Preset preset : all_presets) {
            const Frame frame = receding(20, 6.0, noise_with_mipmaps(16, 8), unit);
            CAPTURE(name_of(preset), unit.lod_bias, static_cast<int>(unit.mip_filter));
            CHECK(fast_routes(frame, preset)[0].scalar_fragments == "");
            CHECK(same_pictures(frame, preset));
        }
}

TEST_CASE("Levels of other sizes than halves are addressed in their own texels", "[fast]") {
    Texture texture = noise_with_mipmaps(4, 4);
    texture.mipmaps = {{4, 1, noise(4, 1)}, {8, 8, noise(8, 8)}};
    TextureUnitState unit;
    unit.mip_filter = MipFilter::linear;
    for (const Preset preset : all_presets)
        CHECK(same_pictures(receding(32, 8.0, texture, unit), preset));
}

TEST_CASE("Where a level's share is in doubt it is found as the reference does", "[fast]") {
    TextureUnitState unit;
    unit.mip_filter = MipFilter::linear;
    for (const double times : {1.0, 3.0, 7.0, 20.0})
        CHECK(same_pictures(receding(384, times, black_and_white_levels(256), unit), Preset::nv17));
}

TEST_CASE("Where a pixel shows the border of two texels of a level it reads the right one",
          "[fast]") {
    TextureUnitState unit;
    unit.texture = 0;
    unit.min_filter = unit.mag_filter = Filter::nearest;
    unit.mip_filter = MipFilter::nearest;
    unit.lod_bias = -0.8;  // the picture shows 4 texels of the base a pixel, 2 of level 1
    PassState state;
    state.units[0] = unit;
    for (const double q : {1.0, 3.0, 5.0, 7.0, 11.0, 0.1}) {
        Mesh mesh = rectangle(0, 0, 16, 16);
        for (Vec4& c : mesh.texcoords[0]) c = {q * c.x, q * c.y, 0.0, q};
        Frame frame = pixel_frame(16, 16, mesh, state);
        frame.textures = {noise_with_mipmaps(64, 64)};
        for (const Preset preset : all_presets) CHECK(same_pictures(frame, preset));
    }
}

TEST_CASE("No pixel of a triangle has a larger scale than its bound", "[fast]") {
    int bounded = 0, near = 0;
    for (std::uint64_t number = 0; number < 4000; ++number) {
        const auto corners = random_corners(number);
        const TriangleSetup setup = set_up({corners[0].point, corners[1].point, corners[2].point});
        if (setup.doubled_area == 0) continue;
        const double bound = bound_of(corners, setup);
        double largest = 0.0;
        for_each_covered_pixel(setup, 4, {0, 0, 16, 16}, [&](int, int, const EdgeValues& edge) {
            largest = std::max(largest, scale_at(corners, setup, edge));
        });
        CHECK(largest <= bound);
        if (std::isfinite(bound)) ++bounded;
        if (bound <= 4.0 * largest) ++near;
    }
    CHECK(bounded > 1000);
    CHECK(near > 500);
}

TEST_CASE("Below the scale of a level of detail there is none larger", "[fast]") {
    for (const double bias : {-16.0, -1.0, 0.0, 0.3, 2.25, 16.0})
        for (const double lambda : {0.0, 0.5, 1.0, 2.0, 7.0}) {
            const double scale = squared_scale_of(lambda, bias);
            CHECK(level_of_detail(scale, bias) <= lambda);
            CHECK(level_of_detail(1.01 * scale, bias) > lambda);
        }
}
