#include "tests/evidence/reading.hpp"

/// The register combiners of a state.
namespace twofold::evidence {
namespace {

using Register = CombinerRegister;

constexpr std::array general_sources{
    Named{"zero", Register::zero},          Named{"c0", Register::constant_color0},
    Named{"c1", Register::constant_color1}, Named{"v0", Register::primary_color},
    Named{"v1", Register::secondary_color}, Named{"tex0", Register::texture0},
    Named{"tex1", Register::texture1},      Named{"tex2", Register::texture2},
    Named{"tex3", Register::texture3},      Named{"r0", Register::spare0},
    Named{"r1", Register::spare1}};

/// What the final combiner's A to D read beside the registers.
constexpr std::array sum_and_product{Named{"v1_plus_r0", Register::spare0_plus_secondary_color},
                                     Named{"ef", Register::e_times_f}};

constexpr std::array outputs{
    Named{"v0", Register::primary_color}, Named{"v1", Register::secondary_color},
    Named{"tex0", Register::texture0},    Named{"tex1", Register::texture1},
    Named{"tex2", Register::texture2},    Named{"tex3", Register::texture3},
    Named{"r0", Register::spare0},        Named{"r1", Register::spare1}};

constexpr std::array components{Named{"rgb", CombinerComponent::rgb},
                                Named{"alpha", CombinerComponent::alpha},
                                Named{"blue", CombinerComponent::blue}};

constexpr std::array mappings{Named{"unsigned", CombinerMapping::unsigned_identity},
                              Named{"invert", CombinerMapping::unsigned_invert},
                              Named{"expand", CombinerMapping::expand_normal},
                              Named{"expand_negate", CombinerMapping::expand_negate},
                              Named{"half_bias", CombinerMapping::half_bias_normal},
                              Named{"half_bias_negate", CombinerMapping::half_bias_negate},
                              Named{"signed", CombinerMapping::signed_identity},
                              Named{"signed_negate", CombinerMapping::signed_negate}};

struct OutputOperation {
    CombinerScale scale;
    bool bias;
};

constexpr std::array operations{Named{"identity", OutputOperation{CombinerScale::one, false}},
                                Named{"bias", OutputOperation{CombinerScale::one, true}},
                                Named{"x2", OutputOperation{CombinerScale::two, false}},
                                Named{"x2_bias", OutputOperation{CombinerScale::two, true}},
                                Named{"x4", OutputOperation{CombinerScale::four, false}},
                                Named{"half", OutputOperation{CombinerScale::one_half, false}}};

enum class Half { rgb, alpha };

/// Where one alpha is wanted the chip has no RGB to offer: the same bit of its input word selects
/// blue there.
CombinerComponent read_component(const JsonValue& value, Half half) {
    const CombinerComponent component = value.enumerator(components);
    const bool scalar = half == Half::alpha && component == CombinerComponent::rgb;
    return scalar ? CombinerComponent::blue : component;
}

CombinerInput read_input(const JsonObject& part, std::string_view name, Half half) {
    const auto value = part.find(name);
    if (!value) return {};
    const JsonObject fields(*value, {"src", "chan", "map"});
    return {fields.at("src").enumerator(general_sources), read_component(fields.at("chan"), half),
            fields.at("map").enumerator(mappings)};
}

std::optional<Register> read_output(const JsonObject& part, std::string_view name) {
    const auto value = part.enabled(name);
    return value ? std::optional(value->enumerator(outputs)) : std::nullopt;
}

/// The selector of MUX is the highest or the lowest bit of spare0's alpha.
void read_mux(const JsonObject& part, CombinerPortion& portion) {
    portion.mux = part.boolean("mux", false);
    const auto by_highest_bit = part.find("mux_msb");
    if (by_highest_bit && !portion.mux) by_highest_bit->fail("without 'mux'");
    portion.mux_by_lowest_bit = by_highest_bit && !by_highest_bit->boolean();
}

CombinerPortion read_portion(const JsonObject& stage, std::string_view name, Half half) {
    const auto value = stage.find(name);
    if (!value) return {};
    const JsonObject part(*value, {"A", "B", "C", "D", "ab", "cd", "sum", "op", "mux", "mux_msb",
                                   "ab_blue_to_alpha", "cd_blue_to_alpha"});
    CombinerPortion portion;
    portion.input = {read_input(part, "A", half), read_input(part, "B", half),
                     read_input(part, "C", half), read_input(part, "D", half)};
    portion.ab_output = read_output(part, "ab");
    portion.cd_output = read_output(part, "cd");
    portion.sum_output = read_output(part, "sum");
    const auto op = part.enumerator("op", operations, OutputOperation{CombinerScale::one, false});
    portion.scale = op.scale;
    portion.bias_by_negative_one_half = op.bias;
    portion.ab_blue_to_alpha = part.boolean("ab_blue_to_alpha", false);
    portion.cd_blue_to_alpha = part.boolean("cd_blue_to_alpha", false);
    read_mux(part, portion);
    return portion;
}

Vec4 read_constant(const JsonObject& fields, std::string_view name) {
    const auto value = fields.find(name);
    return value ? read_color_as_reals(*value) : Vec4{0.0};
}

CombinerStage read_stage(const JsonValue& value) {
    const JsonObject fields(value, {"c0", "c1", "rgb", "alpha"});
    return {read_portion(fields, "rgb", Half::rgb), read_portion(fields, "alpha", Half::alpha),
            read_constant(fields, "c0"), read_constant(fields, "c1")};
}

Register read_final_source(const JsonValue& value) {
    const std::string name = value.text();
    for (const auto& entry : sum_and_product)
        if (entry.name == name) return entry.value;
    return value.enumerator(general_sources);
}

CombinerInput read_final_input(const JsonObject& final_stage, std::string_view name, Half half) {
    const auto value = final_stage.find(name);
    if (!value) return {};
    const JsonObject fields(*value, {"src", "chan", "invert"});
    return {read_final_source(fields.at("src")), read_component(fields.at("chan"), half),
            fields.at("invert").boolean() ? CombinerMapping::unsigned_invert
                                          : CombinerMapping::unsigned_identity};
}

FinalCombiner read_final(const JsonValue& value) {
    const JsonObject fields(value, {"A", "B", "C", "D", "E", "F", "G", "c0", "c1", "clamp_sum",
                                    "invert_r0", "invert_v1"});
    FinalCombiner combiner;
    combiner.a = read_final_input(fields, "A", Half::rgb);
    combiner.b = read_final_input(fields, "B", Half::rgb);
    combiner.c = read_final_input(fields, "C", Half::rgb);
    combiner.d = read_final_input(fields, "D", Half::rgb);
    combiner.e = read_final_input(fields, "E", Half::rgb);
    combiner.f = read_final_input(fields, "F", Half::rgb);
    combiner.g = read_final_input(fields, "G", Half::alpha);
    combiner.constant_color0 = read_constant(fields, "c0");
    combiner.constant_color1 = read_constant(fields, "c1");
    combiner.clamp_sum = fields.boolean("clamp_sum", false);
    combiner.invert_spare0 = fields.boolean("invert_r0", false);
    combiner.invert_secondary = fields.boolean("invert_v1", false);
    return combiner;
}

}  // namespace

RegisterCombiners read_combiners(const JsonValue& value) {
    const JsonObject fields(value, {"stages", "final"});
    RegisterCombiners combiners;
    for (const JsonValue& stage : fields.at("stages").elements(1, 8))
        combiners.stages.push_back(read_stage(stage));
    combiners.final_stage = read_final(fields.at("final"));
    return combiners;
}

}  // namespace twofold::evidence
