#include <catch2/catch.hpp>

#include "raster/fast.hpp"
#include "tests/raster/builders.hpp"
#include "tests/raster/random/mismatch.hpp"

/// The hard cases of drawing (R) that are about tiles, threads and fused passes.
namespace {
using namespace twofold;
using namespace twofold::test;

constexpr std::array every_preset{Preset::ideal64, Preset::float32, Preset::gl13,  Preset::nv2x,
                                  Preset::nv17,    Preset::coarse8, Preset::custom};

/// The passes of `other` after those of `frame`, in the same picture.
void append(Frame& frame, const Frame& other) {
    for (Pass pass : other.passes) {
        pass.mesh += frame.meshes.size();
        for (auto& unit : pass.state.units)
            if (unit && unit->texture) *unit->texture += frame.textures.size();
        frame.passes.push_back(pass);
    }
    frame.meshes.insert(frame.meshes.end(), other.meshes.begin(), other.meshes.end());
    frame.textures.insert(frame.textures.end(), other.textures.begin(), other.textures.end());
}

/// A chequered floor to the horizon, the sphere in four passes on it, a coloured fan and glass:
/// triangles of every size, over all tiles and over the borders of the picture.
Frame busy_frame(int width, int height) {
    Frame frame = floor_frame();
    append(frame, sphere_frame(6, width));
    append(frame, fan_frame());
    frame.width = width;
    frame.height = height;
    return frame;
}

std::string first_mismatch(const Framebuffer& expected, const Framebuffer& found) {
    const auto mismatch = mismatch_of(expected, found);
    return mismatch ? std::to_string(mismatch->x) + " " + std::to_string(mismatch->y) + ": " +
                          mismatch->text
                    : "";
}

}  // namespace

TEST_CASE("R23 tiles, threads and the order of work leave no trace", "[hard][R23][long]") {
    const Preset preset = GENERATE(from_range(every_preset));
    const auto [width, height] =
        GENERATE(table<int, int>({{257, 131}, {1, 1000}, {1000, 1}, {63, 65}, {8, 128}}));
    const Frame frame = busy_frame(width, height);
    const Framebuffer expected = render_reference(frame, preset);
    REQUIRE(expected.counters.written > 0);
    for (const int threads : {1, 2, 3, 8})
        for (const bool fuse : {true, false}) {
            INFO(name_of(preset) << ' ' << width << 'x' << height << ", threads " << threads
                                 << ", fuse " << fuse);
            CHECK(first_mismatch(expected, render_fast(frame, preset, {}, {threads, fuse})) == "");
        }
}

TEST_CASE("R23 a prepared frame draws the same picture every time", "[hard][R23]") {
    const Frame frame = busy_frame(131, 70);
    const FastFrame fast = prepare_fast(frame, Preset::nv17, {}, {2, true});
    const Framebuffer expected = render_reference(frame, Preset::nv17);
    for (int i = 0; i < 3; ++i) {
        fast.draw();
        CHECK(first_mismatch(expected, fast.picture()) == "");
    }
}

namespace {

constexpr int edge = 24;

/// Two triangles of one depth that overlap in a square's upper left half and differ in colour.
/// @param slope how the depth changes across the square; both are of one plane
Mesh tied_triangles(bool red_first, double slope) {
    Mesh mesh;
    for (const Vec4& color : {Vec4{1, 0, 0, 1}, Vec4{0, 1, 0, 1}})
        for (const Vec2& at : {Vec2{0, 0}, Vec2{0, 1}, Vec2{1, 0}}) {
            mesh.positions.push_back({edge * at.x, edge * at.y, 0.5 + slope * at.x});
            mesh.texcoords[0].push_back({at.x, at.y, 0.0, 1.0});
            mesh.colors.push_back(color);
        }
    mesh.indices = red_first ? std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}
                             : std::vector<std::uint32_t>{3, 4, 5, 0, 1, 2};
    return mesh;
}

/// Pass k's texture: one grey; alpha is 1 in all columns but the k-th of four.
Texture pass_texture(std::size_t k) {
    const auto grey = static_cast<std::uint8_t>(255 - 50 * k);
    std::vector<Rgba8> texels(4, Rgba8{grey, grey, grey, 255});
    texels[k].a = 0;
    return {4, 1, texels};
}

/// Four alpha-tested passes over the triangles.
Frame tied_frame(CompareFunc func, bool write, bool red_first, double slope) {
    PassState state;
    state.alpha_test = AlphaTest{};
    state.depth_test = DepthTest{func, write};
    Frame frame = pixel_frame(edge, edge, tied_triangles(red_first, slope), state);
    frame.clear_depth = 0.75;
    state = frame.passes[0].state;
    frame.passes.clear();
    for (std::size_t k = 0; k < 4; ++k) {
        frame.textures.push_back(pass_texture(k));
        state.units[0] = TextureUnitState{};
        state.units[0]->texture = k;
        state.units[0]->min_filter = state.units[0]->mag_filter = Filter::nearest;
        frame.passes.push_back({state, 0});
    }
    return frame;
}

/// Adds the triangles' colours where the depth buffer holds their depth: shows it in the picture.
Pass depth_pass(const Frame& frame) {
    PassState state;
    state.projection = frame.passes.front().state.projection;
    state.depth_test = DepthTest{CompareFunc::equal, false};
    state.blend = Blend{BlendFactor::one, BlendFactor::one};
    return {state, 0};
}

/// Of the pixel in the middle of column 1 of the four, near the top.
Rgba8 tied_pixel(const Framebuffer& picture) {
    return picture.bytes[static_cast<std::size_t>(2 * edge + 3 * edge / 8)];
}

}  // namespace

TEST_CASE("R24 fused passes tie in depth as passes one by one do", "[hard][R24]") {
    const Preset preset = GENERATE(from_range(every_preset));
    const auto func = GENERATE(CompareFunc::less, CompareFunc::lequal, CompareFunc::equal,
                               CompareFunc::gequal, CompareFunc::always, CompareFunc::notequal);
    const bool write = GENERATE(true, false), red_first = GENERATE(true, false);
    const double slope = GENERATE(0.0, 0.125, 0.25);
    Frame frame = tied_frame(func, write, red_first, slope);
    frame.passes.push_back(depth_pass(frame));
    const Framebuffer expected = render_reference(frame, preset);
    for (const bool fuse : {true, false})
        CHECK(first_mismatch(expected, render_fast(frame, preset, {}, {1, fuse})) == "");
}

TEST_CASE("R24 the order is pass first, triangle second", "[hard][R24]") {
    const bool red_first = GENERATE(true, false), fuse = GENERATE(true, false);
    const auto drawn = [&](CompareFunc func) {
        return tied_pixel(
            render_fast(tied_frame(func, true, red_first, 0.0), Preset::nv17, {}, {1, fuse}));
    };
    // LESS keeps the first triangle of the first pass, LEQUAL takes the last of the last.
    const std::uint8_t first = 255, last = 255 - 50 * 3;
    CHECK(drawn(CompareFunc::less) ==
          (red_first ? Rgba8{first, 0, 0, 255} : Rgba8{0, first, 0, 255}));
    CHECK(drawn(CompareFunc::lequal) ==
          (red_first ? Rgba8{0, last, 0, 255} : Rgba8{last, 0, 0, 255}));
}
