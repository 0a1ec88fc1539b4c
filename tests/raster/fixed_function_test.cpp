#include <catch2/catch.hpp>

#include "tests/raster/builders.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/presets.hpp"

using namespace twofold;
using namespace twofold::test;

namespace {

Rgba8 pixel(const Framebuffer& f, int x, int y) {
    return f.bytes[static_cast<std::size_t>(y * f.width + x)];
}

bool near(Rgba8 a, Rgba8 b, int steps) {
    const auto close = [steps](int x, int y) { return x - y <= steps && y - x <= steps; };
    return close(a.r, b.r) && close(a.g, b.g) && close(a.b, b.b) && close(a.a, b.a);
}

/// A rectangle that covers the whole 8 x 8 picture, with a colour of its own at each corner.
Mesh coloured_square() {
    Mesh mesh = rectangle(0, 0, 8, 8);
    mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    return mesh;
}

Framebuffer drawn(const Mesh& mesh, const PassState& state, Preset preset) {
    return render_reference(pixel_frame(8, 8, mesh, state), preset);
}

}  // namespace

TEST_CASE("flat shading takes the provoking vertex's colour in every preset") {
    PassState state;
    state.shade_model = ShadeModel::flat;
    for (const Preset preset : all_presets) {
        const Framebuffer last = drawn(coloured_square(), state, preset);
        CHECK(pixel(last, 7, 6) == Rgba8{0, 0, 255, 255});      // triangle 0, 1, 2
        CHECK(pixel(last, 0, 0) == Rgba8{255, 255, 255, 255});  // triangle 0, 2, 3
        state.provoking_vertex = ProvokingVertex::first;
        const Framebuffer first = drawn(coloured_square(), state, preset);
        CHECK(pixel(first, 7, 6) == Rgba8{255, 0, 0, 255});
        CHECK(pixel(first, 0, 0) == Rgba8{255, 0, 0, 255});
        state.provoking_vertex = ProvokingVertex::last;
    }
}

TEST_CASE("window-space vertices land where the projection would put them") {
    for (const Preset preset : all_presets) {
        PassState state;
        Frame projected = pixel_frame(16, 16, rectangle(2, 3, 11, 9, 0.5), state);
        Frame placed = projected;
        placed.passes[0].state.window_space = true;
        placed.passes[0].state.projection = Mat4{1.0};
        CHECK(render_reference(projected, preset).bytes == render_reference(placed, preset).bytes);
    }
}

TEST_CASE(
    "window-space triangles that are not finite or beyond the guard band are dropped and counted") {
    for (const double bad : {40000.0, -40000.0, 1e30, double(INFINITY), double(NAN)}) {
        Mesh mesh = triangles({{0, 0, 0}, {8, 0, 0}, {bad, 8, 0}});
        PassState state;
        state.window_space = true;
        const Framebuffer f = drawn(mesh, state, Preset::gl13);
        CHECK(f.counters.not_finite == 1);
        CHECK(f.counters.fragments == 0);
    }
}

TEST_CASE("the secondary colour is added after the units and clamped") {
    Mesh mesh = rectangle(0, 0, 8, 8);
    mesh.secondary_colors.assign(4, Vec4{0.2, 0.4, 0.8, 0.0});
    PassState state;
    state.color = Vec4{0.4, 0.4, 0.4, 1.0};
    state.color_sum = true;
    for (const Preset preset : all_presets)
        CHECK(near(pixel(drawn(mesh, state, preset), 4, 4), {153, 204, 255, 255}, 1));
    state.color_sum = false;
    for (const Preset preset : all_presets)
        CHECK(near(pixel(drawn(mesh, state, preset), 4, 4), {102, 102, 102, 255}, 1));
}

TEST_CASE("fog blends toward its colour by the eye distance") {
    Frame frame = pixel_frame(8, 8, rectangle(-1, -1, 1, 1, -2.0));
    PassState& state = frame.passes[0].state;
    state.projection = frustum(1.0, 10.0);
    state.color = Vec4{1.0, 0.0, 0.0, 1.0};
    const auto expect = [&](const Fog& fog, double f) {
        state.fog = fog;
        const auto byte = [](double x) { return static_cast<std::uint8_t>(255.0 * x + 0.5); };
        const Rgba8 wanted{byte(f), 0, byte(1.0 - f), 255};
        for (const Preset preset : faithful_presets) {
            CAPTURE(name_of(preset), f);
            CHECK(near(pixel(render_reference(frame, preset), 4, 4), wanted, 1));
        }
    };
    Fog fog;
    fog.color = Rgb{0.0, 0.0, 1.0};
    fog.mode = FogMode::linear;
    fog.start = 1.0;
    fog.end = 5.0;
    expect(fog, 0.75);
    fog.end = 2.0;
    expect(fog, 0.0);
    fog.mode = FogMode::exp;
    fog.density = 0.25;
    expect(fog, exact::exp(-0.5));
    fog.mode = FogMode::exp2;
    expect(fog, exact::exp(-0.25));
}

TEST_CASE("the scissor keeps pixels outside it untouched") {
    PassState state;
    for (const Scissor s : {Scissor{2, 3, 4, 2}, Scissor{-5, -5, 8, 8}, Scissor{6, 6, 100, 100},
                            Scissor{3, 3, 0, 4}, Scissor{0, 0, 2147483647, 1}}) {
        state.scissor = s;
        const Framebuffer f = drawn(rectangle(0, 0, 8, 8), state, Preset::nv17);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const bool inside = x >= s.x && y >= s.y && x < std::int64_t{s.x} + s.width &&
                                    y < std::int64_t{s.y} + s.height;
                CHECK(pixel(f, x, y) == (inside ? Rgba8{255, 255, 255, 255} : Rgba8{}));
            }
    }
}

TEST_CASE("blend equations and constants give the defined value in every preset") {
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4));
    frame.clear_color = Vec4{0.6, 0.2, 0.4, 1.0};  // 153, 51, 102
    PassState& state = frame.passes[0].state;
    state.color = Vec4{0.2, 0.6, 0.4, 1.0};  // 51, 153, 102
    const auto expect = [&](BlendEquation equation, Rgba8 wanted) {
        state.blend = Blend{BlendFactor::one, BlendFactor::one, equation, Vec4{0.0}};
        for (const Preset preset : all_presets) {
            CAPTURE(name_of(preset), static_cast<int>(equation));
            CHECK(near(pixel(render_reference(frame, preset), 1, 1), wanted, 1));
        }
    };
    expect(BlendEquation::add, {204, 204, 204, 255});
    expect(BlendEquation::subtract, {0, 102, 0, 0});
    expect(BlendEquation::reverse_subtract, {102, 0, 0, 0});
    expect(BlendEquation::min, {51, 51, 102, 255});
    expect(BlendEquation::max, {153, 153, 102, 255});
    state.blend = Blend{BlendFactor::constant_color, BlendFactor::one_minus_constant_alpha,
                        BlendEquation::add, Vec4{0.2, 0.4, 1.0, 0.6}};
    for (const Preset preset :
         all_presets)  // 51*.2+153*.4, 153*.4+51*.4, 102+102*.4, 255*.6+255*.4
        CHECK(near(pixel(render_reference(frame, preset), 1, 1), {71, 82, 143, 255}, 2));
}

TEST_CASE("a 16-bit target cuts source and result and reads its missing alpha as 1") {
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4));
    frame.color_format = ColorFormat::rgb565;
    frame.passes[0].state.color = Vec4{0.5, 0.5, 0.5, 0.25};  // 128 or 127: 16 << 3, 32 << 2
    for (const Preset preset : {Preset::gl13, Preset::nv17, Preset::nv2x}) {
        const Rgba8 plain = pixel(render_reference(frame, preset), 1, 1);
        CHECK(plain == Rgba8{128, 128, 128, 255});
    }
    frame.clear_color = Vec4{1.0, 1.0, 1.0, 0.0};
    frame.passes[0].state.blend = Blend{BlendFactor::zero, BlendFactor::dst_alpha};
    CHECK(pixel(render_reference(frame, Preset::nv2x), 1, 1) == Rgba8{248, 252, 248, 255});
    frame.color_format = ColorFormat::xrgb1555_z;
    CHECK(pixel(render_reference(frame, Preset::nv2x), 1, 1) == Rgba8{248, 248, 248, 0});
}

TEST_CASE("dither keeps the mean of a flat colour and only ever gives its two neighbours") {
    Frame frame = pixel_frame(16, 16, rectangle(0, 0, 16, 16));
    frame.color_format = ColorFormat::rgb565;
    frame.passes[0].state.color = Vec4{Vec3{100.0 / 255.0}, 1.0};  // 96 + 4 of 8, 100 of 4
    frame.passes[0].state.dither = true;
    const Framebuffer f = render_reference(frame, Preset::nv17);
    int high = 0;
    for (const Rgba8 p : f.bytes) {
        REQUIRE((p.r == 96 || p.r == 104));
        CHECK(p.g == 100);
        high += p.r == 104 ? 1 : 0;
    }
    CHECK(high == 128);
}

TEST_CASE("a picture can go on from what was drawn before") {
    Frame whole = pixel_frame(8, 8, rectangle(0, 0, 8, 8), counting_state(3));
    whole.passes.push_back(whole.passes[0]);
    Frame first = pixel_frame(8, 8, rectangle(0, 0, 8, 8), counting_state(3));
    Frame second = first;
    const Framebuffer half = render_reference(first, Preset::nv17);
    second.initial_color = ByteImage{8, 8, half.bytes};
    CHECK(render_reference(second, Preset::nv17).bytes ==
          render_reference(whole, Preset::nv17).bytes);
}

TEST_CASE("depth of 16 and 24 bits is compared as stored") {
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4, 0.5));
    frame.passes[0].state.depth_test = DepthTest{CompareFunc::less, true};
    frame.passes.push_back(frame.passes[0]);
    frame.passes[1].state.depth_test = DepthTest{CompareFunc::equal, false};
    frame.meshes.push_back(rectangle(0, 0, 4, 4, 0.5 + 1.0 / (1 << 20)));
    frame.passes[1].mesh = 1;
    for (const Preset preset : {Preset::gl13, Preset::nv17, Preset::nv2x}) {
        frame.depth_bits = 24;
        CHECK(render_reference(frame, preset).counters.depth_failed == 16);
        frame.depth_bits = 16;
        CHECK(render_reference(frame, preset).counters.depth_failed == 0);
    }
}
