#include "raster/plan.hpp"

#include <fmt/format.h>

#include "raster/transform.hpp"

namespace twofold {
namespace {

int fetches_of(const TextureUnitState& unit) { return unit.filter == Filter::linear ? 4 : 1; }

PlannedStage texgen_stage(const TextureUnitState& unit, std::size_t u) {
    const std::string stage = fmt::format("texgen {}", u);
    switch (unit.texgen) {
        case TexGen::none:
            return {stage, false, "the mesh's own texture coordinates", ""};
        case TexGen::normal_map:
            return {stage, true, "normal_map", "3 dot products a vertex"};
        case TexGen::reflection_map:
            break;
    }
    return {stage, true, "reflection_map",
            "9 dot products, a reciprocal and a reciprocal root a vertex"};
}

void plan_unit(const std::optional<TextureUnitState>& unit, std::size_t u,
               std::vector<PlannedStage>& stages) {
    const std::string name = fmt::format("texture unit {}", u);
    if (!unit) {
        stages.push_back({name, false, "not declared", ""});
        return;
    }
    stages.push_back(texgen_stage(*unit, u));
    stages.push_back({fmt::format("texture matrix {}", u), true, "every enabled unit has one",
                      "4 dot products a vertex"});
    stages.push_back(
        {name, true, unit->texture ? "declared" : "declared without a texture: white",
         fmt::format("2 divisions, {} texel fetches, {} blends of 4 channels a fragment",
                     fetches_of(*unit), unit->filter == Filter::linear ? 3 : 0)});
    stages.push_back({fmt::format("modulate {}", u), true, "environment of an enabled unit",
                      "4 products a fragment"});
    stages.push_back({fmt::format("rgb_scale {}", u), unit->rgb_scale != 1,
                      fmt::format("rgb_scale {}", unit->rgb_scale),
                      unit->rgb_scale != 1 ? "3 clamped shifts a fragment" : ""});
}

PlannedStage declared(const char* stage, bool runs, const char* cost) {
    return {stage, runs, runs ? "declared" : "not declared, or without effect", runs ? cost : ""};
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
    stages.push_back(
        {"vertex transform", true, "always", "4 dot products and a reciprocal a vertex"});
    stages.push_back(
        declared("normalize", state.normalize, "a dot product and a reciprocal root a vertex"));
    stages.push_back({"clip and set-up", true, "always", "3 edge functions a triangle"});
    stages.push_back(declared("cull", state.cull != CullFace::none, "1 comparison a triangle"));
    stages.push_back({"coverage", true, "always", "3 edge functions a pixel of the bounding box"});
    stages.push_back({"colour iterator", true, "always", "4 channels a fragment"});
    for (std::size_t u = 0; u < 2; ++u) plan_unit(state.units[u], u, stages);
    stages.push_back(
        declared("alpha test", state.alpha_test.has_value(), "1 comparison a fragment"));
    stages.push_back(declared("depth test", state.depth_test.has_value(),
                              "1 interpolation, 1 comparison a fragment"));
    stages.push_back(declared("blend", state.blend.has_value(), "1 read, 8 products a fragment"));
    stages.push_back(declared("colour mask", state.color_mask != PassState{}.color_mask,
                              "a fragment's masked channels"));
    stages.push_back({"colour write", true, "always", "1 write a fragment that passes"});
    return stages;
}

}  // namespace twofold
