#include "scenes/scene_json.hpp"
#include "scenes/scene_names.hpp"

/// Explicit passes as JSON.
namespace twofold::scene_io {
namespace {

/// A name alone where it says all.
Json texgen_of(const TexGenState& texgen) {
    for (const auto& entry : texgen_names)
        if (texgen == texgen_all(entry.value)) return entry.name;
    const auto mode = [&](std::size_t i) { return name_in(texgen_names, texgen.mode[i]); };
    return {{"s", mode(0)},
            {"t", mode(1)},
            {"r", mode(2)},
            {"q", mode(3)},
            {"object_planes", list_of(texgen.object_plane)},
            {"eye_planes", list_of(texgen.eye_plane)}};
}

Json arguments_of(const std::array<CombineArgument, 3>& arguments) {
    Json list = Json::array();
    for (const CombineArgument& argument : arguments)
        list.push_back({{"source", name_in(combine_source_names, argument.source)},
                        {"operand", name_in(operand_rgb_names, argument.operand)}});
    return list;
}

Json env_of(const TexEnv& env) {
    return {{"mode", name_in(env_mode_names, env.mode)},
            {"color", json_of(env.color)},
            {"combine_rgb", name_in(combine_rgb_names, env.combine_rgb)},
            {"combine_alpha", name_in(combine_alpha_names, env.combine_alpha)},
            {"rgb", arguments_of(env.rgb)},
            {"alpha", arguments_of(env.alpha)},
            {"rgb_scale", env.rgb_scale},
            {"alpha_scale", env.alpha_scale}};
}

Json unit_of(const TextureUnitState& unit, const std::string& texture) {
    return {{"texture", texture.empty() ? Json(nullptr) : Json(texture)},
            {"target", name_in(target_names, unit.target)},
            {"texgen", texgen_of(unit.texgen)},
            {"matrix", json_of(unit.matrix)},
            {"divide_by_q", unit.divide_by_q},
            {"wrap_s", name_in(wrap_names, unit.wrap_s)},
            {"wrap_t", name_in(wrap_names, unit.wrap_t)},
            {"min_filter", name_in(filter_names, unit.min_filter)},
            {"mag_filter", name_in(filter_names, unit.mag_filter)},
            {"mip_filter", name_in(mip_filter_names, unit.mip_filter)},
            {"lod_bias", unit.lod_bias},
            {"border_color", json_of(unit.border_color)},
            {"env", env_of(unit.env)}};
}

Json units_of(const ScenePass& pass) {
    Json units = Json::array();
    for (std::size_t i = 0; i < pass.state.units.size(); ++i) {
        const auto& unit = pass.state.units[i];
        units.push_back(unit ? unit_of(*unit, pass.textures[i]) : Json(nullptr));
    }
    return units;
}

}  // namespace

Json json_of(const Viewport& viewport) {
    return {{"scale", json_of(viewport.scale)}, {"offset", json_of(viewport.offset)}};
}

Json json_of(const Fog& fog) {
    return {{"mode", name_in(fog_mode_names, fog.mode)},
            {"density", fog.density},
            {"start", fog.start},
            {"end", fog.end},
            {"color", json_of(fog.color)}};
}

Json json_of(const Scissor& scissor) {
    return {
        {"x", scissor.x}, {"y", scissor.y}, {"width", scissor.width}, {"height", scissor.height}};
}

Json json_of(const AlphaTest& test) {
    return {{"func", name_in(compare_names, test.func)}, {"reference", test.reference}};
}

Json json_of(const DepthTest& test) {
    return {{"func", name_in(compare_names, test.func)}, {"write", test.write}};
}

Json json_of(const Blend& blend) {
    return {{"source", name_in(blend_names, blend.source)},
            {"destination", name_in(blend_names, blend.destination)},
            {"equation", name_in(equation_names, blend.equation)},
            {"color", json_of(blend.color)}};
}

Json json_of(const ScenePass& pass) {
    const PassState& state = pass.state;
    return {{"mesh", pass.mesh},
            {"modelview", pass.own_matrices ? json_of(state.modelview) : Json(nullptr)},
            {"projection", pass.own_matrices ? json_of(state.projection) : Json(nullptr)},
            {"viewport", optional_of(state.viewport)},
            {"window_space", state.window_space},
            {"color", json_of(state.color)},
            {"normalize", state.normalize},
            {"cull", name_in(cull_names, state.cull)},
            {"shade_model", name_in(shade_model_names, state.shade_model)},
            {"provoking_vertex", name_in(provoking_names, state.provoking_vertex)},
            {"perspective_correction", state.perspective_correction},
            {"units", units_of(pass)},
            {"combiners", optional_of(state.combiners)},
            {"color_sum", state.color_sum},
            {"fog", optional_of(state.fog)},
            {"scissor", optional_of(state.scissor)},
            {"alpha_test", optional_of(state.alpha_test)},
            {"depth_test", optional_of(state.depth_test)},
            {"blend", optional_of(state.blend)},
            {"color_mask", Json(state.color_mask)},
            {"dither", state.dither}};
}

}  // namespace twofold::scene_io
