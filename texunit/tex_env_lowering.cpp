#include "texunit/tex_env_lowering.hpp"

#include <fmt/format.h>

#include "texunit/error.hpp"
#include "texunit/tex_env.hpp"

namespace twofold {
namespace {

/// 1 and -1 are read from the zero register.
constexpr CombinerInput one{CombinerRegister::zero, CombinerComponent::rgb,
                            CombinerMapping::unsigned_invert};
constexpr CombinerInput minus_one{CombinerRegister::zero, CombinerComponent::rgb,
                                  CombinerMapping::expand_normal};

/// The registers that a unit's arguments name, by CombineSource.
using SourceRegisters = std::array<CombinerRegister, 4>;

CombinerInput with_mapping(CombinerInput input, CombinerMapping mapping) {
    input.mapping = mapping;
    return input;
}

bool is_inverted(const CombinerInput& input) {
    return input.mapping == CombinerMapping::unsigned_invert;
}

CombinerInput inverted(const CombinerInput& input) {
    return with_mapping(input, is_inverted(input) ? CombinerMapping::unsigned_identity
                                                  : CombinerMapping::unsigned_invert);
}

/// 2 e - 1, and for 1 - e the same with the sign turned.
CombinerInput expanded(const CombinerInput& input) {
    return with_mapping(input, is_inverted(input) ? CombinerMapping::expand_negate
                                                  : CombinerMapping::expand_normal);
}

CombinerInput input_of(const CombineArgument& argument, bool alpha_portion,
                       const SourceRegisters& registers) {
    const bool of_alpha = alpha_portion || argument.operand == CombineOperand::src_alpha ||
                          argument.operand == CombineOperand::one_minus_src_alpha;
    const bool invert = argument.operand == CombineOperand::one_minus_src_color ||
                        argument.operand == CombineOperand::one_minus_src_alpha;
    return {registers[static_cast<std::size_t>(argument.source)],
            of_alpha ? CombinerComponent::alpha : CombinerComponent::rgb,
            invert ? CombinerMapping::unsigned_invert : CombinerMapping::unsigned_identity};
}

/// One function of COMBINE as a portion that writes spare0.
CombinerPortion portion_of(CombineFunction function, int scale,
                           const std::array<CombinerInput, 3>& argument) {
    CombinerPortion p;
    p.scale = combiner_scale(scale);
    const auto product = [&p](const CombinerInput& a, const CombinerInput& b) {
        p.input = {a, b};
        p.ab_output = CombinerRegister::spare0;
    };
    const auto sum = [&p](const std::array<CombinerInput, 4>& inputs) {
        p.input = inputs;
        p.sum_output = CombinerRegister::spare0;
    };
    switch (function) {
        case CombineFunction::replace:
            product(argument[0], one);
            break;
        case CombineFunction::modulate:
            product(argument[0], argument[1]);
            break;
        case CombineFunction::add:
            sum({argument[0], one, argument[1], one});
            break;
        case CombineFunction::add_signed:
            sum({argument[0], one, argument[1], one});
            p.bias_by_negative_one_half = true;
            p.scale = combiner_scale(scale == 4 ? 2 : scale);
            break;
        case CombineFunction::interpolate:
            sum({argument[0], argument[2], argument[1], inverted(argument[2])});
            break;
        case CombineFunction::subtract:
            sum({argument[0], one, argument[1], minus_one});
            break;
        case CombineFunction::dot3_rgb:
        case CombineFunction::dot3_rgba:
            product(expanded(argument[0]), expanded(argument[1]));
            p.ab_dot_product = true;
            break;
    }
    return p;
}

CombinerStage stage_of(const TexEnv& env, const SourceRegisters& registers) {
    const auto inputs = [&](const std::array<CombineArgument, 3>& arguments, bool alpha) {
        return std::array{input_of(arguments[0], alpha, registers),
                          input_of(arguments[1], alpha, registers),
                          input_of(arguments[2], alpha, registers)};
    };
    CombinerStage stage;
    stage.rgb = portion_of(env.combine_rgb, env.rgb_scale, inputs(env.rgb, false));
    stage.alpha = portion_of(env.combine_alpha, env.alpha_scale, inputs(env.alpha, true));
    const bool second = registers[static_cast<std::size_t>(CombineSource::constant)] ==
                        CombinerRegister::constant_color1;
    (second ? stage.constant_color1 : stage.constant_color0) = env.color;
    return stage;
}

/// Leaves spare0's colour alone and copies its blue into its alpha.
CombinerStage blue_to_alpha_stage() {
    CombinerStage stage;
    stage.alpha.input = {CombinerInput{CombinerRegister::spare0, CombinerComponent::blue,
                                       CombinerMapping::unsigned_identity},
                         one};
    stage.alpha.ab_output = CombinerRegister::spare0;
    return stage;
}

CombinerRegister register_of(CombinerRegister first, std::size_t offset) {
    return static_cast<CombinerRegister>(static_cast<std::size_t>(first) + offset);
}

}  // namespace

RegisterCombiners lowered(std::span<const UnitEnvironment> units, int stages) {
    RegisterCombiners result;
    auto previous = CombinerRegister::primary_color;
    auto final_alpha = CombinerComponent::alpha;
    const auto push = [&](std::size_t unit, const CombinerStage& stage) {
        if (result.stages.size() == static_cast<std::size_t>(stages))
            throw Error(ExitCode::failure,
                        fmt::format("texture unit {}: its environment needs general combiner stage "
                                    "{}, but there are {}",
                                    unit, stages + 1, stages));
        result.stages.push_back(stage);
    };
    for (const UnitEnvironment& u : units) {
        const TexEnv env = as_combine(u.env, u.format);
        if (env.combine_rgb == CombineFunction::dot3_rgba && env.rgb_scale != env.alpha_scale)
            throw Error(
                ExitCode::failure,
                fmt::format("texture unit {}: DOT3_RGBA with rgb_scale {} and alpha_scale {} "
                            "does not fit one combiner stage",
                            u.unit, env.rgb_scale, env.alpha_scale));
        const std::size_t constant = result.stages.size() % 2;
        const SourceRegisters registers{register_of(CombinerRegister::texture0, u.unit),
                                        register_of(CombinerRegister::constant_color0, constant),
                                        CombinerRegister::primary_color, previous};
        push(u.unit, stage_of(env, registers));
        previous = CombinerRegister::spare0;
        if (env.combine_rgb != CombineFunction::dot3_rgba) continue;
        if (&u == &units.back())
            final_alpha = CombinerComponent::blue;
        else
            push(u.unit, blue_to_alpha_stage());
    }
    if (result.stages.empty()) result.stages.emplace_back();  // the chips run one stage at least
    result.final_stage.d = {previous, CombinerComponent::rgb, CombinerMapping::unsigned_identity};
    result.final_stage.g = {previous, final_alpha, CombinerMapping::unsigned_identity};
    return result;
}

}  // namespace twofold
