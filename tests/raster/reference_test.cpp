#include "raster/reference.hpp"

#include <catch2/catch.hpp>

#include "tests/raster/builders.hpp"
#include "texunit/error.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

std::string message_of(const Frame& frame) {
    try {
        render_reference(frame, Preset::gl13);
    } catch (const Error& e) {
        CHECK(e.code() == ExitCode::failure);
        return e.what();
    }
    return "";
}

/// A square picture filled by one textured rectangle.
Frame textured_frame(int size, const Texture& texture, const TextureUnitState& unit) {
    PassState state;
    state.units[0] = unit;
    state.units[0]->texture = 0;
    Frame frame = pixel_frame(size, size, rectangle(0, 0, size, size), state);
    frame.textures = {texture};
    return frame;
}

Texture grey_texture(int width, int height, const std::vector<std::uint8_t>& greys) {
    std::vector<Rgba8> texels;
    for (const std::uint8_t g : greys) texels.push_back({g, g, g, 255});
    return {width, height, texels};
}

std::vector<int> reds_of_row(const Framebuffer& picture, int y) {
    std::vector<int> row;
    for (int x = 0; x < picture.width; ++x) row.push_back(red(picture, x, y));
    return row;
}
}  // namespace

TEST_CASE("a 2 x 2 texture magnified to 8 x 8 has the values computed by hand", "[reference]") {
    // Bottom row 0 255, top row 101 38. Columns 2..5 stand at fractions 1/8, 3/8, 5/8, 7/8.
    const Frame frame = textured_frame(8, grey_texture(2, 2, {0, 255, 101, 38}), {});
    for (const Preset preset : faithful_presets) {
        CAPTURE(name_of(preset));
        const auto picture = render_reference(frame, preset);
        const bool chip = is_chip(preset);
        CHECK(reds_of_row(picture, 7) == std::vector<int>{0, 0, 32, 96, 159, 223, 255, 255});
        CHECK(reds_of_row(picture, 6) == reds_of_row(picture, 7));
        CHECK(reds_of_row(picture, 0) == std::vector<int>{101, 101, 93, 77, 62, 46, 38, 38});
        CHECK(reds_of_row(picture, 4) == std::vector<int>{38, 38, 55, 89, 123, 157, 174, 174});
        // 1/8 of the way up, column 3: 93.34; in bytes (96 x 224 + 77 x 32 + 128) >> 8 = 94.
        CHECK(reds_of_row(picture, 5) ==
              std::vector<int>{13, 13, 40, chip ? 94 : 93, 147, 201, 228, 228});
    }
}

TEST_CASE("nearest magnification repeats texels, rows bottom up", "[reference]") {
    TextureUnitState unit;
    unit.min_filter = unit.mag_filter = Filter::nearest;
    for (const Preset preset : faithful_presets) {
        const auto picture =
            render_reference(textured_frame(4, grey_texture(2, 2, {1, 2, 3, 4}), unit), preset);
        CHECK(reds_of_row(picture, 0) == std::vector<int>{3, 3, 4, 4});
        CHECK(reds_of_row(picture, 3) == std::vector<int>{1, 1, 2, 2});
    }
}

TEST_CASE("texture coordinates are perspective-correct against the closed form", "[reference]") {
    // The plane z = -2 - x/2, s from 0 at x = -1.5 to 1 at x = 1.5; the texture is the ramp s.
    Mesh mesh;
    const auto z = [](double x) { return -2.0 - 0.5 * x; };
    for (const auto& [x, y] : {std::pair{-1.5, -9.0}, {1.5, -9.0}, {1.5, 9.0}, {-1.5, 9.0}}) {
        mesh.positions.push_back({x, y, z(x)});
        mesh.texcoords[0].push_back({(x + 1.5) / 3.0, 0.0, 0.0, 1.0});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    PassState state;
    state.projection = frustum(1.0, 10.0);
    state.units[0] = TextureUnitState{};
    state.units[0]->texture = 0;
    Frame frame;
    frame.width = frame.height = 64;
    frame.meshes = {mesh};
    frame.textures = {{2, 1, std::vector<Rgba32f>{{0, 0, 0, 1}, {1, 0, 0, 1}}}};
    frame.passes = {{state, 0}};
    for (const Preset preset : faithful_presets) {
        CAPTURE(name_of(preset));
        const auto picture = render_reference(frame, preset);
        double worst = 0.0;
        int compared = 0;
        for (int px = 0; px < 64; ++px) {
            const double slope = (px + 0.5 - 32) / 64;           // x / -z of the ray
            const double x = 2.0 * slope / (1.0 - 0.5 * slope);  // where it meets the plane
            const double ramp = 2.0 * (x + 1.5) / 3.0 - 0.5;     // linear between texel centres
            if (ramp < 0.0 || ramp > 1.0) continue;
            ++compared;
            worst = std::max(
                worst, std::fabs(picture.values[static_cast<std::size_t>(64 * 40 + px)][0] - ramp));
        }
        CHECK(compared > 20);
        const bool bytes = preset == Preset::gl13 || is_chip(preset);
        const double snap = preset == Preset::ideal64 ? 1e-4 : 3e-3;  // of the vertices, magnified
        CHECK(worst < snap + (bytes ? 0.5 / 255 : 0.0) + (is_chip(preset) ? 1.0 / 255 : 0));
    }
}

TEST_CASE("a fragment that fails the alpha test writes neither colour nor depth", "[reference]") {
    PassState state;
    state.color = {1, 0, 0, 0.25};
    state.alpha_test = AlphaTest{CompareFunc::gequal, 0.5};
    state.depth_test = DepthTest{CompareFunc::less, true};
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4, 0.25), state);
    frame.meshes.push_back(rectangle(0, 0, 4, 4, 0.5));
    PassState behind = frame.passes[0].state;
    behind.color = {0, 1, 0, 1};
    frame.passes.push_back({behind, 1});
    for (const Preset preset : all_presets) {
        const auto picture = render_reference(frame, preset);
        CHECK(picture.bytes[5] == Rgba8{0, 255, 0, 255});
        CHECK(picture.counters.alpha_failed == 16);
        CHECK(picture.counters.depth_failed == 0);
        CHECK(picture.counters.written == 16);
    }
}

TEST_CASE("the depth test keeps the nearest, and its mask keeps the buffer", "[reference]") {
    PassState state;
    state.color = {1, 0, 0, 1};
    state.depth_test = DepthTest{CompareFunc::less, true};
    Frame frame = pixel_frame(4, 4, rectangle(0, 0, 4, 4, 0.25), state);
    frame.meshes.push_back(rectangle(0, 0, 4, 4, 0.5));
    PassState behind = frame.passes[0].state;
    behind.color = {0, 1, 0, 1};
    frame.passes.push_back({behind, 1});
    for (const Preset preset : all_presets) {
        frame.passes[0].state.depth_test->write = true;
        const auto kept = render_reference(frame, preset);
        CHECK(kept.bytes[5] == Rgba8{255, 0, 0, 255});
        CHECK(kept.counters.depth_failed == 16);
        frame.passes[0].state.depth_test->write = false;
        CHECK(render_reference(frame, preset).bytes[5] == Rgba8{0, 255, 0, 255});
        frame.passes[0].state.depth_test.reset();  // without a test the buffer is not written
        CHECK(render_reference(frame, preset).bytes[5] == Rgba8{0, 255, 0, 255});
        frame.passes[0].state.depth_test = DepthTest{CompareFunc::less, true};
    }
}

TEST_CASE("front is counter-clockwise on the screen with y up", "[reference]") {
    PassState state;
    state.cull = CullFace::back;
    for (const Preset preset : all_presets) {
        Frame frame;
        frame.width = frame.height = 8;
        frame.meshes = {triangles({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}})};  // clip space: y up
        frame.passes = {{state, 0}};
        CHECK(render_reference(frame, preset).counters.culled == 0);
        std::swap(frame.meshes[0].indices[1], frame.meshes[0].indices[2]);
        CHECK(render_reference(frame, preset).counters.culled == 1);
    }
}

TEST_CASE("the colour mask guards each channel alone", "[reference]") {
    for (unsigned bits = 0; bits < 16; ++bits) {
        PassState state;
        for (unsigned c = 0; c < 4; ++c) state.color_mask[c] = (bits >> c & 1) != 0;
        Frame frame = pixel_frame(2, 2, rectangle(0, 0, 2, 2), state);
        frame.clear_color = Vec4{0.2};
        for (const Preset preset : all_presets) {
            const Rgba8 p = render_reference(frame, preset).bytes[3];
            CHECK(p.r == (bits & 1 ? 255 : 51));
            CHECK(p.g == (bits & 2 ? 255 : 51));
            CHECK(p.b == (bits & 4 ? 255 : 51));
            CHECK(p.a == (bits & 8 ? 255 : 51));
        }
    }
}

TEST_CASE("two units multiply their textures and the colour, and scale works on colour only",
          "[reference]") {
    PassState state;
    state.color = Vec4{Vec3{100 / 255.0}, 200 / 255.0};
    state.units = {TextureUnitState{}, TextureUnitState{}};
    state.units[0]->texture = 0;
    state.units[1]->texture = 1;
    state.units[1]->env.rgb_scale = 4;
    Frame frame = pixel_frame(2, 2, rectangle(0, 0, 2, 2), state);
    frame.textures = {{1, 1, std::vector<Rgba8>{{200, 200, 200, 100}}},
                      {1, 1, std::vector<Rgba8>{{90, 90, 90, 255}}}};
    // 100 x 200 x 90 / 255^2 x 4 = 110.7; in bytes 78, 28 (27.5), 112.
    for (const Preset preset : faithful_presets) {
        const Rgba8 p = render_reference(frame, preset).bytes[0];
        CHECK(p.r == (is_chip(preset) ? 112 : 111));
        CHECK(p.a == 78);  // 200 x 100 / 255 = 78.4
    }
}

TEST_CASE("an empty list of passes gives the clear colour", "[reference]") {
    Frame frame;
    frame.width = 3;
    frame.height = 2;
    frame.clear_color = {0.25, 0.5, 1.5, -1.0};
    for (const Preset preset : all_presets) {
        const auto picture = render_reference(frame, preset);
        CHECK(picture.bytes ==
              std::vector<Rgba8>(
                  6, preset == Preset::coarse8 ? Rgba8{63, 127, 255, 0} : Rgba8{64, 128, 255, 0}));
        CHECK(picture.counters == DrawCounters{});
        CHECK(picture.values.size() == 6);
    }
}

TEST_CASE("counters add up", "[reference]") {
    for (const Preset preset : all_presets) {
        const auto picture = render_reference(sphere_frame(5, 64), preset);
        const DrawCounters& c = picture.counters;
        CHECK(c.triangles == 4 * 300);
        CHECK(c.rejected + c.not_finite + c.clipped == 0);
        CHECK(c.triangles == c.culled + c.zero_area + c.set_up);
        CHECK(c.fragments == c.alpha_failed + c.depth_failed + c.written);
        CHECK(c.alpha_failed > 0);
    }
}

TEST_CASE("what cannot be drawn is refused with its name and number", "[reference]") {
    const Frame good = sphere_frame(1, 4);
    CHECK(message_of(good).empty());
    Frame f = good;
    f.width = -1;
    CHECK(message_of(f) == "picture: size -1 x 4 is out of range");
    f = good;
    f.height = 16385;
    CHECK(message_of(f) == "picture: size 4 x 16385 is out of range");
    f = good;
    f.meshes[0].indices[4] = 24;
    CHECK(message_of(f) == "mesh 0: index 24 names none of 24 vertices");
    f = good;
    f.meshes[0].indices.pop_back();
    CHECK(message_of(f) == "mesh 0: 35 indices are not triangles");
    f = good;
    f.meshes[0].normals.pop_back();
    CHECK(message_of(f) == "mesh 0: 23 normals for 24 positions");
    f = good;
    f.meshes[0].colors = {Vec4{1.0}};
    CHECK(message_of(f) == "mesh 0: 1 colors for 24 positions");
    f = good;
    f.meshes[0].texcoords[0] = {Vec4{1.0}};
    CHECK(message_of(f) == "mesh 0: 1 texcoords for 24 positions");
    f = good;
    f.textures[3].width = 0;
    CHECK(message_of(f) == "texture 3: size 0 x 64 is out of range");
    f = good;
    f.textures[3].height = 63;
    CHECK(message_of(f) == "texture 3: 4096 texels for 64 x 63");
    f = good;
    f.passes[1].mesh = 7;
    CHECK(message_of(f) == "pass 1: no mesh 7");
    f = good;
    f.passes[1].state.units[1]->texture = 4;
    CHECK(message_of(f) == "pass 1: no texture 4");
    f = good;
    f.passes[1].state.units[1]->env.rgb_scale = 3;
    CHECK(message_of(f) == "pass 1: scale 3 is not 1, 2 or 4");
}

TEST_CASE("drawing twice gives the same picture", "[reference]") {
    for (const Preset preset : all_presets) {
        const Frame frame = sphere_frame(3, 32);
        CHECK(hash_of(render_reference(frame, preset)) == hash_of(render_reference(frame, preset)));
    }
}

TEST_CASE("reference pictures have their pinned bytes", "[reference][pinned]") {
    struct Pinned {
        Preset preset;
        std::uint64_t sphere, floor, fan;
    };
    for (const auto& [preset, sphere_hash, floor_hash, fan_hash] :
         {Pinned{Preset::ideal64, 0x48b4eceff215108a, 0x250a4628f46aabc3, 0xdfe213e17724892a},
          Pinned{Preset::float32, 0xd99cc98780ccbc56, 0x0f0f3b6e87e56d95, 0x92953e2b3d484a65},
          Pinned{Preset::gl13, 0x5d75fa2d42667d5c, 0x54cb54960cde338f, 0x05d2c84132a48207},
          Pinned{Preset::nv17, 0xb2b921d9485d1c1e, 0xbf758121c5529c1a, 0x1ffd56b01a999cd5}}) {
        CAPTURE(name_of(preset));
        CHECK(hash_of(render_reference(sphere_frame(5, 64), preset)) == sphere_hash);
        CHECK(hash_of(render_reference(floor_frame(), preset)) == floor_hash);
        CHECK(hash_of(render_reference(fan_frame(), preset)) == fan_hash);
    }
}
