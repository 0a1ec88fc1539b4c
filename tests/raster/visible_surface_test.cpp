#include "raster/visible_surface.hpp"

#include <catch2/catch.hpp>

#include "tests/raster/builders.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

const SurfacePoint* point_at(const VisibleSurface& s, int x, int y) {
    const auto i = s.point_of_pixel[static_cast<std::size_t>(y * s.width + x)];
    return i < 0 ? nullptr : &s.points[static_cast<std::size_t>(i)];
}
}  // namespace

TEST_CASE("the visible surface is where ideal64 draws", "[visible]") {
    const Frame frame = pixel_frame(32, 32, triangles({{1, 30, 0}, {31, 17, 0}, {5, 2, 0}}));
    const VisibleSurface surface = visible_surface(frame);
    const Framebuffer picture = render_reference(frame, Preset::ideal64);
    REQUIRE(surface.point_of_pixel.size() == picture.bytes.size());
    for (std::size_t i = 0; i < picture.bytes.size(); ++i)
        CHECK((surface.point_of_pixel[i] >= 0) == (picture.bytes[i].r == 255));
    CHECK(surface.points.size() == picture.counters.fragments);
}

TEST_CASE("weights lead back to the pixel's centre", "[visible]") {
    const std::vector<Vec3> corners{{1, 30, 0}, {31, 17, 0}, {5, 2, 0}};
    const VisibleSurface surface = visible_surface(pixel_frame(32, 32, triangles(corners)));
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const SurfacePoint* p = point_at(surface, x, y);
            if (!p) continue;
            const Vec3 at = p->weights[0] * corners[0] + p->weights[1] * corners[1] +
                            p->weights[2] * corners[2];
            CHECK(at.x == Approx(x + 0.5));
            CHECK(at.y == Approx(y + 0.5));
            CHECK(p->weights[0] + p->weights[1] + p->weights[2] == Approx(1.0));
        }
}

TEST_CASE("weights are correct in perspective, on clipped triangles too", "[visible]") {
    // A floor at y = -1 from behind the eye to z = -9.
    const std::vector<Vec3> corners{{-40, -1, 5}, {40, -1, 5}, {0, -1, -9}};
    Frame frame;
    frame.width = frame.height = 64;
    PassState state;
    state.projection = frustum(0.125, 100.0);
    frame.meshes = {triangles(corners)};
    frame.passes = {{state, 0}};
    const VisibleSurface surface = visible_surface(frame);
    REQUIRE(surface.points.size() > 500);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const SurfacePoint* p = point_at(surface, x, y);
            if (!p) continue;
            const Vec3 at = p->weights[0] * corners[0] + p->weights[1] * corners[1] +
                            p->weights[2] * corners[2];
            const double scale = 0.5 * 2.0 * 64 / -at.z;  // pixels a unit at that distance
            // Clipping makes new vertices, and those are snapped to 1/4096 pixel.
            CHECK(32 + at.x * scale == Approx(x + 0.5).margin(0.01));
            CHECK(32 - at.y * scale == Approx(y + 0.5).margin(0.01));
        }
}

TEST_CASE("the nearest triangle is seen, and of equal ones the last", "[visible]") {
    Frame frame = pixel_frame(8, 8, rectangle(0, 0, 8, 8, 0.5));
    frame.meshes.push_back(rectangle(0, 0, 4, 8, 0.25));
    frame.passes.push_back({frame.passes[0].state, 1});
    frame.passes.push_back(frame.passes[0]);
    const VisibleSurface surface = visible_surface(frame);
    CHECK(point_at(surface, 1, 1)->pass == 1);
    CHECK(point_at(surface, 6, 6)->pass == 2);
    CHECK(point_at(surface, 4, 0)->vertex == std::array<std::uint32_t, 3>{0, 2, 3});
}

TEST_CASE("culling is kept and tests are not", "[visible]") {
    PassState state;
    state.cull = CullFace::front;
    CHECK(visible_surface(pixel_frame(8, 8, rectangle(0, 0, 8, 8), state)).points.empty());
    state.cull = CullFace::back;
    state.alpha_test = AlphaTest{CompareFunc::never, 0.0};
    state.depth_test = DepthTest{CompareFunc::never, true};
    CHECK(visible_surface(pixel_frame(8, 8, rectangle(0, 0, 8, 8), state)).points.size() == 64);
}

TEST_CASE("an empty picture has an empty surface", "[visible]") {
    CHECK(visible_surface({}).point_of_pixel.empty());
    Frame frame;
    frame.width = frame.height = 3;
    CHECK(visible_surface(frame).point_of_pixel == std::vector<std::int32_t>(9, -1));
}
