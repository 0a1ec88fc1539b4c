#include <fmt/format.h>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Register combiners of explicit passes.
namespace twofold::scene_io {
namespace {

constexpr std::size_t most_stages = 8;

/// What is not written reads the register's RGB in an RGB portion, its alpha in an alpha portion:
/// the first of the names.
template <std::size_t Registers>
CombinerInput read_input(const JsonObject& fields,
                         const std::array<Named<CombinerRegister>, Registers>& registers,
                         const std::array<Named<CombinerComponent>, 2>& components) {
    const CombinerInput absent;
    return {.source = fields.enumerator("source", registers, absent.source),
            .component = fields.enumerator("component", components, components[0].value),
            .mapping = absent.mapping};
}

/// A, B, C, D; inputs that are not written read zero.
void read_inputs(const JsonObject& fields,
                 const std::array<Named<CombinerComponent>, 2>& components,
                 CombinerPortion& portion) {
    for (CombinerInput& input : portion.input) input.component = components[0].value;
    const auto list = fields.find("inputs");
    if (!list) return;
    const auto elements = list->elements(0, portion.input.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const JsonObject input(elements[i], {"source", "component", "mapping"});
        portion.input[i] = read_input(input, register_names, components);
        portion.input[i].mapping =
            input.enumerator("mapping", mapping_names, portion.input[i].mapping);
    }
}

std::optional<CombinerRegister> read_output(const JsonObject& fields, std::string_view name) {
    const auto output = fields.enabled(name);
    return output ? std::optional(output->enumerator(output_names)) : std::nullopt;
}

/// What NV_register_combiners answers with INVALID_OPERATION.
void check_portion(const JsonObject& fields, const CombinerPortion& p) {
    const auto same = [](const auto& a, const auto& b) { return a && a == b; };
    if (same(p.ab_output, p.cd_output) || same(p.ab_output, p.sum_output) ||
        same(p.cd_output, p.sum_output))
        fields.value().fail("two outputs go to one register");
    if (p.sum_output && (p.ab_dot_product || p.cd_dot_product))
        fields.at("sum_output").fail("a dot product leaves no sum: needs null");
    if (p.bias_by_negative_one_half &&
        (p.scale == CombinerScale::four || p.scale == CombinerScale::one_half))
        fields.at("bias_by_negative_one_half").fail("goes with the scales one and two only");
}

void read_outputs(const JsonObject& fields, CombinerPortion& portion) {
    portion.ab_output = read_output(fields, "ab_output");
    portion.cd_output = read_output(fields, "cd_output");
    portion.sum_output = read_output(fields, "sum_output");
    portion.mux = fields.boolean("mux", portion.mux);
    portion.mux_by_lowest_bit = fields.boolean("mux_by_lowest_bit", portion.mux_by_lowest_bit);
    portion.scale = fields.enumerator("scale", combiner_scale_names, portion.scale);
    portion.bias_by_negative_one_half =
        fields.boolean("bias_by_negative_one_half", portion.bias_by_negative_one_half);
}

CombinerPortion read_rgb_portion(const JsonValue& value) {
    const JsonObject fields(
        value, {"inputs", "ab_output", "cd_output", "sum_output", "ab_dot_product",
                "cd_dot_product", "mux", "mux_by_lowest_bit", "scale", "bias_by_negative_one_half",
                "ab_blue_to_alpha", "cd_blue_to_alpha"});
    CombinerPortion portion;
    read_inputs(fields, rgb_component_names, portion);
    read_outputs(fields, portion);
    portion.ab_dot_product = fields.boolean("ab_dot_product", portion.ab_dot_product);
    portion.cd_dot_product = fields.boolean("cd_dot_product", portion.cd_dot_product);
    portion.ab_blue_to_alpha = fields.boolean("ab_blue_to_alpha", portion.ab_blue_to_alpha);
    portion.cd_blue_to_alpha = fields.boolean("cd_blue_to_alpha", portion.cd_blue_to_alpha);
    check_portion(fields, portion);
    return portion;
}

CombinerPortion read_alpha_portion(const JsonValue& value) {
    const JsonObject fields(value, {"inputs", "ab_output", "cd_output", "sum_output", "mux",
                                    "mux_by_lowest_bit", "scale", "bias_by_negative_one_half"});
    CombinerPortion portion;
    read_inputs(fields, alpha_component_names, portion);
    read_outputs(fields, portion);
    check_portion(fields, portion);
    return portion;
}

/// An alpha portion that nobody wrote still reads alphas.
CombinerPortion empty_alpha_portion() {
    CombinerPortion portion;
    for (CombinerInput& input : portion.input) input.component = CombinerComponent::alpha;
    return portion;
}

CombinerStage read_stage(const JsonValue& value) {
    const JsonObject fields(value, {"constant_color0", "constant_color1", "rgb", "alpha"});
    CombinerStage stage;
    stage.constant_color0 = fields.vec4("constant_color0", unit_interval, stage.constant_color0);
    stage.constant_color1 = fields.vec4("constant_color1", unit_interval, stage.constant_color1);
    if (const auto rgb = fields.find("rgb")) stage.rgb = read_rgb_portion(*rgb);
    const auto alpha = fields.find("alpha");
    stage.alpha = alpha ? read_alpha_portion(*alpha) : empty_alpha_portion();
    return stage;
}

template <std::size_t Registers>
CombinerInput read_final_input(const JsonObject& final_fields, std::string_view name,
                               const std::array<Named<CombinerRegister>, Registers>& registers,
                               const std::array<Named<CombinerComponent>, 2>& components) {
    const auto value = final_fields.find(name);
    if (!value) return {.component = components[0].value};
    const JsonObject fields(*value, {"source", "component", "invert"});
    CombinerInput input = read_input(fields, registers, components);
    if (fields.boolean("invert", false)) input.mapping = CombinerMapping::unsigned_invert;
    return input;
}

FinalCombiner read_final(const JsonValue& value) {
    const JsonObject fields(
        value, {"a", "b", "c", "d", "e", "f", "g", "constant_color0", "constant_color1",
                "clamp_sum", "invert_spare0", "invert_secondary"});
    const auto term = [&](std::string_view name) {
        return read_final_input(fields, name, final_register_names, rgb_component_names);
    };
    const auto factor = [&](std::string_view name) {
        return read_final_input(fields, name, register_names, rgb_component_names);
    };
    const FinalCombiner absent;
    return {
        .a = term("a"),
        .b = term("b"),
        .c = term("c"),
        .d = term("d"),
        .e = factor("e"),
        .f = factor("f"),
        .g = read_final_input(fields, "g", register_names, alpha_component_names),
        .constant_color0 = fields.vec4("constant_color0", unit_interval, absent.constant_color0),
        .constant_color1 = fields.vec4("constant_color1", unit_interval, absent.constant_color1),
        .clamp_sum = fields.boolean("clamp_sum", absent.clamp_sum),
        .invert_spare0 = fields.boolean("invert_spare0", absent.invert_spare0),
        .invert_secondary = fields.boolean("invert_secondary", absent.invert_secondary)};
}

}  // namespace

RegisterCombiners read_combiners(const JsonValue& value) {
    const JsonObject fields(value, {"stages", "final"});
    RegisterCombiners combiners;
    for (const JsonValue& stage : fields.at("stages").elements(1, most_stages))
        combiners.stages.push_back(read_stage(stage));
    combiners.final_stage = read_final(fields.at("final"));
    return combiners;
}

}  // namespace twofold::scene_io
