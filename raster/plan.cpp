#include "raster/plan.hpp"

#include <fmt/format.h>

#include "raster/transform.hpp"

namespace twofold {
namespace {

/// Texels that one lookup reads at most.
int fetches_of(const TextureUnitState& unit) {
    const bool linear = unit.min_filter == Filter::linear || unit.mag_filter == Filter::linear;
    return (linear ? 4 : 1) * (unit.mip_filter == MipFilter::linear ? 2 : 1);
}

PlannedStage texgen_stage(const TextureUnitState& unit, std::size_t u) {
    const std::string stage = fmt::format("texgen {}", u);
    if (unit.texgen.mode == TexGenState{}.mode)
        return {stage, false, "the mesh's own texture coordinates", ""};
    if (uses_reflection(unit.texgen))
        return {stage, true, "reflection_map or sphere_map",
                "9 dot products, a reciprocal and a reciprocal root a vertex"};
    if (uses_normal(unit.texgen)) return {stage, true, "normal_map", "3 dot products a vertex"};
    return {stage, true, "object_linear or eye_linear", "a dot product a coordinate and vertex"};
}

void plan_environment(const TextureUnitState& unit, std::size_t u,
                      std::vector<PlannedStage>& stages) {
    stages.push_back({fmt::format("environment {}", u), true,
                      unit.env.mode == TexEnvMode::modulate ? "modulate" : "declared",
                      "4 products a fragment"});
    const bool scaled = unit.env.rgb_scale != 1 || unit.env.alpha_scale != 1;
    stages.push_back(
        {fmt::format("scale {}", u), scaled,
         fmt::format("rgb_scale {}, alpha_scale {}", unit.env.rgb_scale, unit.env.alpha_scale),
         scaled ? "clamped shifts, a fragment" : ""});
}

void plan_unit(const PassState& state, std::size_t u, std::vector<PlannedStage>& stages) {
    const std::string name = fmt::format("texture unit {}", u);
    if (!state.units[u]) {
        stages.push_back({name, false, "not declared", ""});
        return;
    }
    const TextureUnitState& unit = *state.units[u];
    stages.push_back(texgen_stage(unit, u));
    stages.push_back({fmt::format("texture matrix {}", u), true, "every enabled unit has one",
                      "4 dot products a vertex"});
    stages.push_back({name, true, unit.texture ? "declared" : "declared without a texture: white",
                      fmt::format("2 divisions, up to {} texel fetches and {} blends of 4 channels "
                                  "a fragment",
                                  fetches_of(unit), fetches_of(unit) - 1)});
    if (!state.combiners) plan_environment(unit, u, stages);
}

PlannedStage declared(const char* stage, bool runs, const char* cost) {
    return {stage, runs, runs ? "declared" : "not declared, or without effect", runs ? cost : ""};
}

void plan_vertices(const PassState& state, std::vector<PlannedStage>& stages) {
    stages.push_back({"vertex transform", !state.window_space,
                      state.window_space ? "positions are window coordinates" : "always",
                      state.window_space ? "" : "4 dot products and a reciprocal a vertex"});
    stages.push_back(
        declared("normalize", state.normalize, "a dot product and a reciprocal root a vertex"));
    stages.push_back({"clip and set-up", true, "always", "3 edge functions a triangle"});
    stages.push_back(declared("cull", state.cull != CullFace::none, "1 comparison a triangle"));
    stages.push_back(declared("scissor", state.scissor.has_value(), "4 comparisons a triangle"));
    stages.push_back({"coverage", true, "always", "3 edge functions a pixel of the bounding box"});
}

void plan_fragment_operations(const PassState& state, std::vector<PlannedStage>& stages) {
    stages.push_back(
        declared("alpha test", state.alpha_test.has_value(), "1 comparison a fragment"));
    stages.push_back(declared("depth test", state.depth_test.has_value(),
                              "1 interpolation, 1 comparison a fragment"));
    stages.push_back(declared("blend", state.blend.has_value(), "1 read, 8 products a fragment"));
    stages.push_back(declared("dither", state.dither, "3 sums a fragment"));
    stages.push_back(declared("colour mask", state.color_mask != PassState{}.color_mask,
                              "a fragment's masked channels"));
    stages.push_back({"colour write", true, "always", "1 write a fragment that passes"});
}

}  // namespace

int texel_fetches(const PassState& state) {
    int fetches = 0;
    for (const auto& unit : state.units)
        if (unit) fetches += fetches_of(*unit);
    return fetches;
}

std::vector<PlannedStage> plan(const PassState& given) {
    const PassState state = normalized(given);
    std::vector<PlannedStage> stages;
    plan_vertices(state, stages);
    stages.push_back({"colour iterator", true, "always", "4 channels a fragment"});
    for (std::size_t u = 0; u < max_units; ++u) plan_unit(state, u, stages);
    const std::size_t general = state.combiners ? state.combiners->stages.size() : 0;
    stages.push_back(
        {"register combiners", general > 0,
         general > 0 ? fmt::format("{} general stages and the final one", general) : "not declared",
         general > 0 ? "up to 8 products a stage and fragment" : ""});
    stages.push_back(declared("colour sum", state.color_sum, "3 sums a fragment"));
    stages.push_back(
        declared("fog", state.fog.has_value(), "an exponential a vertex, 3 blends a fragment"));
    plan_fragment_operations(state, stages);
    return stages;
}

}  // namespace twofold
