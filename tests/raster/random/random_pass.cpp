#include "tests/raster/random/random_parts.hpp"

/// Passes with any state, and small changes to a pass.
namespace twofold::test {
namespace {

AlphaTest random_alpha_test(Dice& dice) {
    const auto func = dice.chance(0.5) ? CompareFunc::gequal : dice.up_to(CompareFunc::always);
    return {func, dice.chance(0.7) ? dice.one_of({0.5, 0.25, 0.0, 0.0, 1.0}) : dice.unit()};
}

DepthTest random_depth_test(Dice& dice) {
    const auto func =
        dice.chance(0.6)
            ? dice.one_of({CompareFunc::less, CompareFunc::lequal, CompareFunc::lequal})
            : dice.up_to(CompareFunc::always);
    return {func, !dice.chance(0.25)};
}

Blend random_blend(Dice& dice) {
    const auto last = BlendFactor::one_minus_constant_alpha;
    switch (dice.integer(0, 4)) {
        case 0:
            return {BlendFactor::one, BlendFactor::one, BlendEquation::add, Vec4{0.0}};
        case 1:
            return {BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha, BlendEquation::add,
                    Vec4{0.0}};
        case 2:
            return {BlendFactor::dst_color, dice.one_of({BlendFactor::zero, BlendFactor::one}),
                    BlendEquation::add, Vec4{0.0}};
        default:
            break;
    }
    return {dice.up_to(last), dice.up_to(last), dice.up_to(BlendEquation::max), random_color(dice)};
}

Fog random_fog(Dice& dice) {
    return {dice.up_to(FogMode::exp2), dice.real(0.0, 1.5), dice.real(0.0, 2.0),
            dice.real(2.5, 6.0), Rgb{dice.unit(), dice.unit(), dice.unit()}};
}

Scissor random_scissor(Dice& dice, const View& view) {
    return {dice.integer(-4, view.width), dice.integer(-4, view.height),
            dice.integer(0, view.width + 4), dice.integer(0, view.height + 4)};
}

/// The window's place in the picture, moved and stretched.
Viewport random_viewport(Dice& dice, const View& view) {
    const double w = 0.5 * view.width, h = 0.5 * view.height;
    return {{w * dice.real(0.5, 1.5), -h, dice.one_of({0.5, 0.25})},
            {w + dice.one_of({0.0, 0.53125, -3.0}), h + dice.one_of({0.0, 0.5}), 0.5}};
}

void random_geometry(Dice& dice, PassState& state, const View& view) {
    if (view.space != Space::window && dice.chance(0.1))
        state.viewport = random_viewport(dice, view);
    state.color = random_color(dice);
    state.normalize = dice.chance(0.3);
    if (dice.chance(0.3)) state.cull = dice.up_to(CullFace::back);
    state.shade_model = dice.chance(0.15) ? ShadeModel::flat : ShadeModel::smooth;
    state.provoking_vertex = dice.up_to(ProvokingVertex::first);
    state.perspective_correction = !dice.chance(0.15);
}

void random_fragment_operations(Dice& dice, PassState& state, const View& view) {
    state.color_sum = dice.chance(0.2);
    if (dice.chance(0.15)) state.fog = random_fog(dice);
    if (dice.chance(0.15)) state.scissor = random_scissor(dice, view);
    if (dice.chance(0.4)) state.alpha_test = random_alpha_test(dice);
    if (dice.chance(0.6)) state.depth_test = random_depth_test(dice);
    if (dice.chance(0.4)) state.blend = random_blend(dice);
    if (dice.chance(0.15))
        for (bool& channel : state.color_mask) channel = dice.chance(0.6);
    state.dither = dice.chance(0.2);
}

}  // namespace

PassState random_pass(Dice& dice, const View& view, const std::vector<Texture>& textures, int units,
                      int combiner_stages) {
    PassState state;
    state.modelview = view.modelview;
    state.projection = view.projection;
    state.window_space = view.space == Space::window;
    random_geometry(dice, state, view);
    for (int u = 0; u < units; ++u)
        if (dice.chance(u < 2 ? 0.6 : 0.25))
            state.units[static_cast<std::size_t>(u)] = random_unit(dice, textures);
    if (dice.chance(0.12)) state.combiners = random_combiners(dice, combiner_stages);
    random_fragment_operations(dice, state, view);
    return state;
}

void disturb(Dice& dice, PassState& state, const View& view) {
    switch (dice.integer(0, 13)) {
        case 0:
            state.depth_test = random_depth_test(dice);
            break;
        case 1:
            state.alpha_test = random_alpha_test(dice);
            break;
        case 2:
            state.blend = random_blend(dice);
            break;
        case 3:
            state.scissor = random_scissor(dice, view);
            break;
        case 4:
            state.fog = random_fog(dice);
            break;
        case 5:
            state.color = random_color(dice);
            break;
        case 6:
            state.color_mask[dice.index(4)] = false;
            break;
        case 7:
            state.cull = dice.up_to(CullFace::back);
            break;
        case 8:
            state.modelview[3].x += dice.real(-0.1, 0.1);
            break;
        case 9:
            state.units[0].reset();
            break;
        case 10:
            state.units[1].reset();
            break;
        case 11:
            if (state.units[0]) state.units[0]->env = random_env(dice);
            break;
        case 12:
            state.depth_test.reset();
            break;
        default:
            state.alpha_test.reset();
            break;
    }
}

}  // namespace twofold::test
