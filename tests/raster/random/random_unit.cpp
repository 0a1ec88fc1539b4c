#include "tests/raster/random/random_parts.hpp"
#include "texunit/paraboloid.hpp"

/// Texture units, their environments and register combiners with any state.
namespace twofold::test {
namespace {

Vec4 random_plane(Dice& dice) {
    return {dice.real(-1, 1), dice.real(-1, 1), dice.real(-0.5, 0.5), dice.real(-1, 1)};
}

TexGenState random_texgen(Dice& dice) {
    if (dice.chance(0.6)) return {};
    if (dice.chance(0.5)) return texgen_all(dice.up_to(TexGen::reflection_map));
    TexGenState texgen;
    for (std::size_t i = 0; i < 3; ++i) texgen.mode[i] = dice.up_to(TexGen::reflection_map);
    texgen.mode[3] = dice.up_to(TexGen::eye_linear);
    for (auto& plane : texgen.object_plane) plane = random_plane(dice);
    for (auto& plane : texgen.eye_plane) plane = random_plane(dice);
    return texgen;
}

Mat4 random_matrix(Dice& dice) {
    Mat4 m{1.0};
    switch (dice.integer(0, 9)) {
        case 0:  // scale and shift
            m[0][0] = dice.real(-3, 3);
            m[1][1] = dice.real(-3, 3);
            m[3] = {dice.real(-1, 1), dice.real(-1, 1), 0.0, 1.0};
            break;
        case 1:  // projective: q from s, t and r
            m[0][3] = dice.real(-0.5, 0.5);
            m[1][3] = dice.real(-0.5, 0.5);
            m[3][3] = dice.one_of({1.0, 0.5, 0.0});
            break;
        case 2:
            m = paraboloid_matrix(dice.one_of({Face::front, Face::back}), 0.875);
            break;
        case 3:
            for (int i = 0; i < 4; ++i) m[i] = random_plane(dice);
            break;
        case 4:
            m[3][3] = dice.one_of({0.0, -1.0, 2.0, 1e-30});
            break;
        default:
            break;
    }
    return m;
}

Wrap random_wrap(Dice& dice) {
    if (dice.chance(0.5)) return dice.one_of({Wrap::clamp_to_edge, Wrap::repeat});
    return dice.up_to(Wrap::mirrored_repeat);
}

/// Scale of the base image: a rectangle's coordinates count texels.
void make_rectangle(TextureUnitState& unit, const Texture* texture) {
    unit.target = TextureTarget::rectangle;
    unit.wrap_s = unit.wrap_t = Wrap::clamp_to_edge;
    unit.mip_filter = MipFilter::off;
    if (texture == nullptr) return;
    Mat4 scale{1.0};
    scale[0][0] = texture->width;
    scale[1][1] = texture->height;
    unit.matrix = scale * unit.matrix;
}

void random_target(Dice& dice, TextureUnitState& unit, const Texture* texture) {
    if (dice.chance(0.02)) {  // what scene files forbid
        unit.target = dice.up_to(TextureTarget::cube_map);
        return;
    }
    if (texture != nullptr && !texture->cube_faces.empty())
        unit.target = TextureTarget::cube_map;
    else if (dice.chance(0.1) && (texture == nullptr || texture->border == 0))
        make_rectangle(unit, texture);
}

void random_filters(Dice& dice, TextureUnitState& unit) {
    unit.min_filter = unit.mag_filter = dice.up_to(Filter::linear);
    if (dice.chance(0.2)) unit.mag_filter = dice.up_to(Filter::linear);
    if (dice.chance(0.4)) unit.mip_filter = dice.up_to(MipFilter::linear);
    if (dice.chance(0.3)) unit.lod_bias = dice.one_of({-16.0, -1.0, 0.5, 1.0, 2.25, 16.0});
}

CombineArgument random_argument(Dice& dice, bool alpha) {
    const auto source = dice.up_to(CombineSource::previous);
    if (alpha)
        return {source,
                dice.one_of({CombineOperand::src_alpha, CombineOperand::one_minus_src_alpha})};
    return {source, dice.up_to(CombineOperand::one_minus_src_alpha)};
}

CombinerInput random_input(Dice& dice, CombinerRegister last, bool alpha) {
    const auto half = alpha ? CombinerComponent::blue : CombinerComponent::rgb;
    return {dice.up_to(last), dice.one_of({half, CombinerComponent::alpha}),
            dice.up_to(CombinerMapping::signed_negate)};
}

std::optional<CombinerRegister> random_output(Dice& dice) {
    if (dice.chance(0.3)) return std::nullopt;
    return dice.one_of({CombinerRegister::primary_color, CombinerRegister::secondary_color,
                        CombinerRegister::texture0, CombinerRegister::texture1,
                        CombinerRegister::spare0, CombinerRegister::spare0,
                        CombinerRegister::spare1});
}

/// Nothing that NV_register_combiners answers with INVALID_OPERATION.
CombinerPortion random_portion(Dice& dice, bool alpha) {
    CombinerPortion p;
    for (auto& input : p.input) input = random_input(dice, CombinerRegister::spare1, alpha);
    if (!alpha && dice.chance(0.2)) p.ab_dot_product = true;
    if (!alpha && dice.chance(0.1)) p.cd_dot_product = true;
    p.ab_output = random_output(dice);
    p.cd_output = random_output(dice);
    if (p.cd_output == p.ab_output) p.cd_output.reset();
    if (!p.ab_dot_product && !p.cd_dot_product) p.sum_output = random_output(dice);
    if (p.sum_output == p.ab_output || p.sum_output == p.cd_output) p.sum_output.reset();
    p.mux = dice.chance(0.2);
    p.mux_by_lowest_bit = dice.chance(0.1);
    p.scale = dice.up_to(CombinerScale::one_half);
    p.bias_by_negative_one_half =
        (p.scale == CombinerScale::one || p.scale == CombinerScale::two) && dice.chance(0.3);
    p.ab_blue_to_alpha = !alpha && dice.chance(0.05);
    p.cd_blue_to_alpha = !alpha && dice.chance(0.05);
    return p;
}

CombinerInput random_final_input(Dice& dice, CombinerRegister last, bool alpha) {
    CombinerInput input = random_input(dice, last, alpha);
    input.mapping =
        dice.one_of({CombinerMapping::unsigned_identity, CombinerMapping::unsigned_invert});
    return input;
}

FinalCombiner random_final(Dice& dice) {
    FinalCombiner last;
    for (auto* input : {&last.a, &last.b, &last.c, &last.d})
        *input = random_final_input(dice, CombinerRegister::e_times_f, false);
    for (auto* input : {&last.e, &last.f})
        *input = random_final_input(dice, CombinerRegister::spare1, false);
    last.g = random_final_input(dice, CombinerRegister::spare1, true);
    last.constant_color0 = random_color(dice);
    last.constant_color1 = random_color(dice);
    last.clamp_sum = dice.chance(0.5);
    last.invert_spare0 = dice.chance(0.1);
    last.invert_secondary = dice.chance(0.1);
    return last;
}

}  // namespace

TexEnv random_env(Dice& dice) {
    TexEnv env;
    env.color = random_color(dice);
    if (dice.chance(0.3)) return env;
    env.mode = dice.up_to(TexEnvMode::combine);
    if (dice.chance(0.4)) env.rgb_scale = dice.one_of({1, 2, 4});
    if (env.mode != TexEnvMode::combine) return env;
    env.combine_rgb = dice.up_to(CombineFunction::dot3_rgba);
    env.combine_alpha = dice.up_to(CombineFunction::subtract);
    for (auto& argument : env.rgb) argument = random_argument(dice, false);
    for (auto& argument : env.alpha) argument = random_argument(dice, true);
    env.alpha_scale = dice.one_of({1, 1, 2, 4});
    return env;
}

TextureUnitState random_unit(Dice& dice, const std::vector<Texture>& textures) {
    TextureUnitState unit;
    if (!textures.empty() && !dice.chance(0.05)) unit.texture = dice.index(textures.size());
    unit.texgen = random_texgen(dice);
    unit.matrix = random_matrix(dice);
    unit.divide_by_q = !dice.chance(0.1);
    unit.wrap_s = random_wrap(dice);
    unit.wrap_t = random_wrap(dice);
    random_filters(dice, unit);
    unit.border_color = random_color(dice);
    unit.env = random_env(dice);
    random_target(dice, unit, unit.texture ? &textures[*unit.texture] : nullptr);
    return unit;
}

RegisterCombiners random_combiners(Dice& dice, int most_stages) {
    RegisterCombiners combiners;
    for (int n = dice.integer(1, most_stages < 3 ? most_stages : 3); n > 0; --n)
        combiners.stages.push_back({random_portion(dice, false), random_portion(dice, true),
                                    random_color(dice), random_color(dice)});
    combiners.final_stage = random_final(dice);
    return combiners;
}

}  // namespace twofold::test
