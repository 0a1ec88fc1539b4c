#include "raster/fast_plan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "raster/effects.hpp"
#include "raster/renderer.hpp"
#include "tests/raster/builders.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

/// Why the fragments of a pass are not shaded on vectors.
std::string why_scalar(const PassState& state, Preset preset = Preset::nv17,
                       const CustomSettings& custom = {}) {
    return fast_routes(pixel_frame(8, 8, rectangle(0, 0, 8, 8), state), preset, custom)[0]
        .scalar_fragments;
}

bool names(const std::vector<Effect>& effects, const std::string& name) {
    return std::any_of(effects.begin(), effects.end(),
                       [&](const Effect& e) { return e.name == name; });
}
}  // namespace

TEST_CASE("the paper's four passes run on vectors and share their geometry", "[fast]") {
    const auto routes = fast_routes(sphere_frame(4, 32), Preset::nv17);
    REQUIRE(routes.size() == 4);
    for (const FastRoute& route : routes) {
        CHECK(route.scalar_vertices == "");
        CHECK(route.scalar_fragments == "");
        CHECK(route.apart == "");
        CHECK(route.group == 0);
    }
    CHECK(fast_routes(sphere_frame(4, 32), Preset::nv17, {}, false)[1].apart == "fusing is off");
}

TEST_CASE("what vectors do not know is named", "[fast]") {
    PassState state;
    CHECK(why_scalar(state) == "");
    for (const Preset preset : all_presets) CHECK(why_scalar(state, preset) == "");
    CustomSettings wide;
    wide.filter_rounding = FilterRounding::once;
    wide.filter_weight_bits = 16;
    wide.register_bits = 22;
    CHECK(why_scalar(state, Preset::custom, wide) == "");
    wide.register_bits = 23;
    CHECK(why_scalar(state, Preset::custom, wide) ==
          "filter_rounding once with weights and registers wider than binary64");
    state.color_sum = true;
    CHECK(why_scalar(state) == "colour sum");
    state = {};
    state.fog = Fog{};
    CHECK(why_scalar(state) == "fog");
    state = {};
    state.units[1] = TextureUnitState{};
    state.units[1]->target = TextureTarget::cube_map;
    CHECK(why_scalar(state) == "texture unit 1: a cube map");
    for (auto& unit : state.units) unit = TextureUnitState{};
    CHECK(why_scalar(state) == "more than 2 texture units");
}

TEST_CASE("passes that are not fused say why", "[fast]") {
    Frame frame = sphere_frame(4, 32);
    frame.passes[1].state.cull = CullFace::front;
    for (auto& unit : frame.passes[3].state.units) {
        unit = TextureUnitState{};
        unit->matrix[0][0] = static_cast<double>(&unit - frame.passes[3].state.units.data() + 2);
    }
    const auto routes = fast_routes(frame, Preset::nv17);
    CHECK(routes[1].apart == "other matrices, viewport or culling");
    CHECK(routes[2].apart == "other matrices, viewport or culling");
    CHECK(routes[3].apart == "more different texture coordinates than there are units");
    CHECK(routes[3].group == 3);
}

TEST_CASE("the effects of a frame are those that are on, each left out of all passes", "[fast]") {
    const auto effects = effects_of(sphere_frame(4, 32));
    for (const char* name : {"cull", "alpha test", "depth test", "texture unit 0", "texgen 1"})
        CHECK(names(effects, name));
    for (const char* name : {"blend", "fog", "texture unit 2", "scissor", "normalize"})
        CHECK_FALSE(names(effects, name));
    for (const Effect& effect : effects)
        if (effect.name == "alpha test")
            for (const Pass& pass : effect.without.passes) CHECK_FALSE(pass.state.alpha_test);
}

TEST_CASE("both pipelines draw the same bytes and only the reference counts", "[fast]") {
    const Frame frame = sphere_frame(4, 32);
    const Framebuffer fast = render(frame, Preset::nv17);
    const Framebuffer reference = render(frame, Preset::nv17, {}, {Pipeline::reference});
    CHECK(fast.bytes == reference.bytes);
    CHECK(fast.counters.fragments == 0);
    CHECK(reference.counters.fragments > 0);
}
