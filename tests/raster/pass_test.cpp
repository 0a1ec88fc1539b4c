#include "raster/pass.hpp"

#include <catch2/catch.hpp>

#include "tests/raster/builders.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;
}  // namespace

TEST_CASE("a state without what cannot change a pixel equals the plain state", "[pass]") {
    PassState state;
    state.alpha_test = AlphaTest{CompareFunc::always, 0.3};
    state.blend = Blend{BlendFactor::one, BlendFactor::zero};
    state.depth_test = DepthTest{CompareFunc::always, false};
    state.normalize = true;
    CHECK(normalized(state) == PassState{});
}

TEST_CASE("what can change a pixel stays", "[pass]") {
    PassState state;
    state.alpha_test = AlphaTest{CompareFunc::greater, 0.0};
    state.blend = Blend{BlendFactor::one, BlendFactor::one};
    state.depth_test = DepthTest{CompareFunc::always, true};
    state.units[1] = TextureUnitState{};
    state.units[1]->texgen = texgen_all(TexGen::normal_map);
    state.normalize = true;
    CHECK(normalized(state) == state);
    state.depth_test = DepthTest{CompareFunc::never, false};
    CHECK(normalized(state) == state);
}

TEST_CASE("normalising twice changes nothing more", "[pass]") {
    PassState state;
    state.alpha_test = AlphaTest{CompareFunc::always, 0.3};
    state.depth_test = DepthTest{CompareFunc::always, true};
    CHECK(normalized(normalized(state)) == normalized(state));
}

TEST_CASE("a state draws as its normal form does", "[pass]") {
    PassState idle;
    idle.color = {0.2, 0.4, 0.6, 0.8};
    const Frame plain = pixel_frame(16, 16, rectangle(1, 2, 12, 15), idle);
    idle.alpha_test = AlphaTest{CompareFunc::always, 0.9};
    idle.blend = Blend{};
    idle.depth_test = DepthTest{CompareFunc::always, false};
    idle.normalize = true;
    const Frame wordy = pixel_frame(16, 16, rectangle(1, 2, 12, 15), idle);
    for (const Preset preset : all_presets)
        CHECK(render_reference(wordy, preset).bytes == render_reference(plain, preset).bytes);
}

TEST_CASE(
    "a scissor around the picture and dither of 8-bit channels cannot change a pixel of a frame",
    "[pass]") {
    PassState state;
    state.scissor = Scissor{-3, 0, 11, 8};
    state.dither = true;
    Frame frame;
    frame.width = frame.height = 8;
    frame.color_format = ColorFormat::xrgb8888_o;
    CHECK(normalized(frame, {state, 0}) == PassState{});
    frame.width = 9;
    frame.color_format = ColorFormat::rgb565;
    CHECK(normalized(frame, {state, 0}) == state);
}
