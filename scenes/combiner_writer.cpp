#include "scenes/scene_json.hpp"
#include "scenes/scene_names.hpp"

/// Register combiners as JSON.
namespace twofold::scene_io {
namespace {

using Components = std::array<Named<CombinerComponent>, 2>;

/// The alpha half reads blue where the state says RGB: one bit tells the two from alpha.
std::string_view component_of(const CombinerInput& input, const Components& components) {
    const std::string_view name = name_in(components, input.component);
    return name.empty() ? components[1].name : name;
}

Json inputs_of(const CombinerPortion& portion, const Components& components) {
    Json list = Json::array();
    for (const CombinerInput& input : portion.input)
        list.push_back({{"source", name_in(register_names, input.source)},
                        {"component", component_of(input, components)},
                        {"mapping", name_in(mapping_names, input.mapping)}});
    return list;
}

/// Null is discarded.
Json output_of(const std::optional<CombinerRegister>& output) {
    return output ? Json(name_in(output_names, *output)) : Json(nullptr);
}

Json portion_of(const CombinerPortion& portion, const Components& components) {
    return {{"inputs", inputs_of(portion, components)},
            {"ab_output", output_of(portion.ab_output)},
            {"cd_output", output_of(portion.cd_output)},
            {"sum_output", output_of(portion.sum_output)},
            {"mux", portion.mux},
            {"mux_by_lowest_bit", portion.mux_by_lowest_bit},
            {"scale", name_in(combiner_scale_names, portion.scale)},
            {"bias_by_negative_one_half", portion.bias_by_negative_one_half}};
}

Json rgb_portion_of(const CombinerPortion& portion) {
    Json json = portion_of(portion, rgb_component_names);
    json["ab_dot_product"] = portion.ab_dot_product;
    json["cd_dot_product"] = portion.cd_dot_product;
    json["ab_blue_to_alpha"] = portion.ab_blue_to_alpha;
    json["cd_blue_to_alpha"] = portion.cd_blue_to_alpha;
    return json;
}

Json final_input_of(const CombinerInput& input, const Components& components) {
    return {{"source", name_in(final_register_names, input.source)},
            {"component", component_of(input, components)},
            {"invert", input.mapping == CombinerMapping::unsigned_invert}};
}

Json final_of(const FinalCombiner& last) {
    const auto rgb = [](const CombinerInput& input) {
        return final_input_of(input, rgb_component_names);
    };
    return {{"a", rgb(last.a)},
            {"b", rgb(last.b)},
            {"c", rgb(last.c)},
            {"d", rgb(last.d)},
            {"e", rgb(last.e)},
            {"f", rgb(last.f)},
            {"g", final_input_of(last.g, alpha_component_names)},
            {"constant_color0", json_of(last.constant_color0)},
            {"constant_color1", json_of(last.constant_color1)},
            {"clamp_sum", last.clamp_sum},
            {"invert_spare0", last.invert_spare0},
            {"invert_secondary", last.invert_secondary}};
}

}  // namespace

Json json_of(const CombinerStage& stage) {
    return {{"constant_color0", json_of(stage.constant_color0)},
            {"constant_color1", json_of(stage.constant_color1)},
            {"rgb", rgb_portion_of(stage.rgb)},
            {"alpha", portion_of(stage.alpha, alpha_component_names)}};
}

Json json_of(const RegisterCombiners& combiners) {
    return {{"stages", list_of(combiners.stages)}, {"final", final_of(combiners.final_stage)}};
}

}  // namespace twofold::scene_io
