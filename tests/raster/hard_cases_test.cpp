#include <catch2/catch.hpp>
#include <limits>

#include "raster/clip.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/error.hpp"

/// The hard cases of drawing (R) that need no tiles and no fused passes, but for coverage.
namespace {
using namespace twofold;
using namespace twofold::test;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("R06 both windings cover the same pixels and culling takes one of them", "[hard][R06]") {
    const std::vector<Vec3> front{{3.3, 50.1, 0}, {60.2, 40.7, 0}, {20.9, 4.4, 0}};
    const std::vector<Vec3> back{front[0], front[2], front[1]};
    for (const Preset preset : all_presets) {
        const auto a = counted(front, preset), b = counted(back, preset);
        CHECK(a.bytes == b.bytes);
        CHECK(a.counters.fragments > 1000);
        PassState state;
        state.cull = CullFace::back;
        CHECK(counted(front, preset, state).bytes == a.bytes);
        CHECK(counted(back, preset, state).counters.culled == 1);
        CHECK(counted(back, preset, state).counters.fragments == 0);
        state.cull = CullFace::front;
        CHECK(counted(back, preset, state).bytes == a.bytes);
        CHECK(counted(front, preset, state).counters.fragments == 0);
    }
}

TEST_CASE("R08 two triangles whose shared edge passes behind the eye have no gap and no overlap",
          "[hard][R08]") {
    // A floor at y = -1 from far behind the eye to the horizon's edge, split along its diagonal.
    Mesh floor = triangles({{-900, -1, 700},
                            {900, -1, 700},
                            {900, -1, -300},
                            {-900, -1, 700},
                            {900, -1, -300},
                            {-900, -1, -300}});
    PassState state = counting_state();
    state.projection = frustum(0.25, 1000.0);
    Frame frame;
    frame.width = frame.height = 64;
    frame.meshes = {floor};
    frame.passes = {{state, 0}};
    for (const Preset preset : all_presets) {
        CAPTURE(name_of(preset));
        const auto picture = render_reference(frame, preset);
        CHECK(picture.counters.clipped == 2);
        int wrong = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) wrong += red(picture, x, y) != (y >= 32 ? 1 : 0);
        CHECK(wrong == 0);
    }
}

TEST_CASE("R09 a triangle outside one plane is rejected before set-up", "[hard][R09]") {
    for (const Preset preset : all_presets) {
        const auto c = counted({{70, 3, 0}, {90, 8, 0}, {75, 40, 0}}, preset).counters;
        CHECK(c.triangles == 1);
        CHECK(c.rejected == 1);
        CHECK(c.set_up == 0);
        CHECK(c.fragments == 0);
    }
}

TEST_CASE("R10 the guard band is not visible", "[hard][R10]") {
    // Pixels of the triangle that was cut by hand, in binary64, at x = +-2^15 pixels.
    for (const double beyond : {1.0 / 16, 1.0, 100.0, 1e6}) {
        const double far = guard_band + beyond;
        const Vec3 apex{20, 10, 0}, right{far, 40, 0}, left{-far, 50, 0};
        const auto at_band = [](Vec3 in, Vec3 out) {
            const double t = ((out.x < 0 ? -guard_band : guard_band) - in.x) / (out.x - in.x);
            return Vec3{out.x < 0 ? -guard_band : guard_band, in.y + t * (out.y - in.y), 0};
        };
        const Vec3 r1 = at_band(apex, right), l1 = at_band(apex, left);
        const Vec3 r2 = at_band(left, right), l2 = at_band(right, left);
        const auto whole = counted({apex, left, right}, Preset::ideal64);
        const auto by_hand = counted({apex, l1, l2, apex, l2, r2, apex, r2, r1}, Preset::ideal64);
        CHECK(whole.counters.clipped == 1);
        CHECK(whole.bytes == by_hand.bytes);
        CHECK(whole.counters.fragments > 1000);
    }
    for (const Preset preset : all_presets) {
        const double in = guard_band - 1.0 / 16;
        const auto c = counted({{20, 10, 0}, {-in, 50, 0}, {in, 40, 0}}, preset).counters;
        CHECK(c.clipped == 0);
        CHECK(c.fragments > 1000);
    }
}

TEST_CASE("R13 R14 R15 a vertex that is huge, NaN or infinite costs its triangle only",
          "[hard][R13][R14][R15]") {
    const std::vector<Vec3> good{{3, 50, 0.5}, {60, 40, 0.5}, {20, 4, 0.5}};
    for (const Preset preset : all_presets) {
        const auto expected = counted(good, preset);
        for (const double bad : {1e30, -1e30, infinity, -infinity, not_a_number, -not_a_number})
            for (int component = 0; component < 3; ++component) {
                std::vector<Vec3> with_bad{{1, 1, 0}, {60, 2, 0}, {30, 60, 0}};
                with_bad[1][component] = bad;
                with_bad.insert(with_bad.end(), good.begin(), good.end());
                const auto picture = counted(with_bad, preset);
                CAPTURE(name_of(preset), bad, component);
                CHECK(picture.bytes == expected.bytes);
                CHECK(picture.counters.not_finite == 1);
            }
    }
}

TEST_CASE("R18 a singular modelview is refused by name where normals are needed", "[hard][R18]") {
    Frame frame = sphere_frame(1, 8);
    frame.passes[2].state.modelview[1] = frame.passes[2].state.modelview[0];
    try {
        render_reference(frame, Preset::nv17);
        FAIL("drawn");
    } catch (const Error& e) {
        CHECK(e.code() == ExitCode::failure);
        CHECK(std::string(e.what()) ==
              "pass 2: modelview is singular, so it transforms no normals");
    }
    frame.passes[2].state.modelview = Mat4{0.0};
    CHECK_THROWS_AS(render_reference(frame, Preset::nv17), Error);
    for (auto& unit : frame.passes[2].state.units) unit.reset();
    CHECK_NOTHROW(render_reference(frame, Preset::nv17));
}

TEST_CASE("R19 a second pass with depth EQUAL hits every pixel of the first, in any state",
          "[hard][R19]") {
    for (const Preset preset : all_presets) {
        std::uint64_t missed = 0, pixels = 0;
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const auto draw = [i](std::uint64_t k) { return random_unit(1900 + i, k); };
            Frame frame;
            frame.width = frame.height = 24;
            std::vector<Vec3> positions;
            for (std::uint64_t k = 0; k < 9; ++k)
                positions.push_back(
                    {6 * draw(3 * k) - 3, 6 * draw(3 * k + 1) - 3, -0.5 - 5 * draw(3 * k + 2)});
            frame.meshes = {triangles(positions)};
            frame.meshes[0].normals.assign(9, Vec3{0, 0, 1});
            frame.textures = {face_texture({200, 100, 50, 255}, 4, 1.0)};
            PassState first;
            first.projection = frustum(1.0, 6.0);
            first.color_mask = {true, false, false, false};
            first.depth_test = DepthTest{CompareFunc::less, true};
            PassState second = first;
            second.color_mask = {false, true, false, false};
            second.depth_test = DepthTest{CompareFunc::equal, draw(40) < 0.5};
            second.normalize = draw(41) < 0.5;
            if (draw(42) < 0.5) second.alpha_test = AlphaTest{CompareFunc::gequal, 0.0};
            if (draw(43) < 0.5) second.blend = Blend{BlendFactor::one, BlendFactor::one};
            for (std::size_t u = 0; u < 2; ++u)
                if (draw(44 + u) < 0.5) {
                    second.units[u] = TextureUnitState{};
                    if (draw(46 + u) < 0.5)
                        second.units[u]->texgen = texgen_all(TexGen::reflection_map);
                }
            frame.passes = {{first, 0}, {second, 0}};
            for (const Rgba8& p : render_reference(frame, preset).bytes) {
                pixels += p.r == 255;
                missed += (p.r != 0) != (p.g != 0);
            }
        }
        CHECK(missed == 0);
        CHECK(pixels > 50000);
    }
}

TEST_CASE("R20 depth 1 passes against a cleared buffer only where equality does", "[hard][R20]") {
    for (const Preset preset : all_presets)
        for (const auto& [z, func, drawn] : {std::tuple{1.0, CompareFunc::less, false},
                                             {1.0, CompareFunc::lequal, true},
                                             {0.0, CompareFunc::less, true},
                                             {-0.0, CompareFunc::less, true},
                                             {0.5, CompareFunc::greater, false}}) {
            PassState state;
            state.depth_test = DepthTest{func, true};
            const Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4, z), state);
            CHECK((render_reference(frame, preset).counters.written == 16) == drawn);
        }
}

TEST_CASE("R21 a polygon larger than the target covers it, once", "[hard][R21]") {
    for (const Preset preset : all_presets)
        for (const double reach : {10.0, 3000.0, 30000.0, 1e7, 1e12}) {
            CAPTURE(name_of(preset), reach);
            const auto picture = render_reference(
                pixel_frame(64, 64, rectangle(-reach, -reach, reach + 64, reach + 64),
                            counting_state()),
                preset);
            CHECK(red_histogram(picture) == std::map<int, int>{{1, 64 * 64}});
            CHECK(picture.counters.fragments == 64 * 64);
        }
}

TEST_CASE("R22 pictures without pixels succeed and pictures of one pixel follow the sample rule",
          "[hard][R22]") {
    for (const Preset preset : all_presets) {
        for (const auto& [w, h] : {std::pair{0, 0}, {0, 5}, {5, 0}}) {
            Frame frame = pixel_frame(1, 1, rectangle(0, 0, 1, 1));
            frame.width = w;
            frame.height = h;
            const auto picture = render_reference(frame, preset);
            CHECK(picture.bytes.empty());
            CHECK(picture.values.empty());
        }
        const auto one = [&](double x0, double x1) {
            const auto mesh = rectangle(x0, 0, x1, 1);
            return red(render_reference(pixel_frame(1, 1, mesh), preset), 0, 0);
        };
        CHECK(one(0.0, 1.0) == 255);
        CHECK(one(0.5, 1.0) == 255);  // a left edge holds the centre
        CHECK(one(0.0, 0.5) == 0);    // a right edge does not
        const auto column = render_reference(pixel_frame(1, 64, rectangle(0, 16, 1, 48)), preset);
        CHECK(red_histogram(column) == std::map<int, int>{{0, 32}, {255, 32}});
    }
}

TEST_CASE("C06 adding saturates in each pass, so order matters only beyond 255", "[hard][C06]") {
    const auto added = [](int a, int b, int minus, Preset preset) {
        Frame frame = pixel_frame(2, 2, rectangle(0, 0, 2, 2));
        const auto pass = [&](double steps, BlendFactor source, BlendFactor destination) {
            PassState state = frame.passes[0].state;
            state.color = Vec4{steps / 255, steps / 255, steps / 255, 1.0};
            state.blend = Blend{source, destination};
            return Pass{state, 0};
        };
        using enum BlendFactor;
        const Pass dim = pass(minus, zero, src_color);
        const std::vector<Pass> sum{pass(a, one, one), pass(b, one, one)};
        frame.passes = {sum[0], sum[1], dim};
        const int dim_last = red(render_reference(frame, preset), 0, 0);
        frame.passes = {sum[0], dim, sum[1]};
        return std::pair{dim_last, red(render_reference(frame, preset), 0, 0)};
    };
    for (const Preset preset : all_presets) {
        CHECK(added(200, 100, 255, preset) == std::pair{255, 255});
        CHECK(added(100, 200, 255, preset) == std::pair{255, 255});
        CHECK(added(200, 100, 51, preset) == std::pair{51, 140});  // (255) / 5; 200 / 5 + 100
        CHECK(added(20, 10, 255, preset) == std::pair{30, 30});
    }
}

TEST_CASE("T11 a unit without a texture is white", "[hard][T11]") {
    for (const Preset preset : all_presets) {
        PassState state;
        state.color = {0.1, 0.5, 0.9, 0.7};
        state.units[1] = TextureUnitState{};
        Frame frame = pixel_frame(8, 8, rectangle(0, 0, 8, 8), state);
        const auto without = render_reference(frame, preset);
        frame.textures = {{1, 1, std::vector<Rgba8>{{255, 255, 255, 255}}}};
        frame.passes[0].state.units[1]->texture = 0;
        CHECK(render_reference(frame, preset).bytes == without.bytes);
        frame.passes[0].state.units[1].reset();
        if (preset != Preset::coarse8)
            CHECK(render_reference(frame, preset).bytes == without.bytes);
    }
}
