#pragma once
#include "texunit/numeric_model.hpp"
#include "texunit/tex_env_state.hpp"

/// Texture environments: what a unit makes of the colour it gets and of its texel.
/// @source OpenGL 1.3, 3.8.12
namespace twofold {

constexpr bool has_color(BaseFormat format) { return format != BaseFormat::alpha; }

constexpr bool has_alpha(BaseFormat format) {
    return format != BaseFormat::luminance && format != BaseFormat::rgb;
}

/// The COMBINE environment that does what `env` does with a texture of this format. All other modes
/// are rows of one table: a function of texture, previous and constant, or the previous value where
/// the format lacks the component. DECAL is defined for RGB and RGBA alone; others pass the colour
/// on here.
/// @source OpenGL 1.3, tables 3.21 and 3.22
inline TexEnv as_combine(const TexEnv& env, BaseFormat format) {
    if (env.mode == TexEnvMode::combine) return env;
    using enum CombineOperand;
    constexpr CombineArgument texture{CombineSource::texture, src_color};
    constexpr CombineArgument texture_alpha{CombineSource::texture, src_alpha};
    constexpr CombineArgument previous{CombineSource::previous, src_color};
    constexpr CombineArgument constant{CombineSource::constant, src_color};

    TexEnv result;
    result.mode = TexEnvMode::combine;
    result.color = env.color;
    const auto rgb = [&](CombineFunction f, std::array<CombineArgument, 3> arguments) {
        result.combine_rgb = f;
        result.rgb = arguments;
    };
    const auto alpha = [&](CombineFunction f, std::array<CombineArgument, 3> arguments) {
        result.combine_alpha = f;
        for (std::size_t k = 0; k < 3; ++k) result.alpha[k] = {arguments[k].source, src_alpha};
    };
    rgb(CombineFunction::replace, {previous});
    alpha(CombineFunction::replace, {previous});

    // Alpha is the product wherever both have one, but for REPLACE, DECAL and, with BLEND and ADD,
    // for INTENSITY, whose alpha is treated as its colour is.
    const bool intensity = format == BaseFormat::intensity;
    if (has_alpha(format)) alpha(CombineFunction::modulate, {texture, previous});
    switch (env.mode) {
        case TexEnvMode::replace:
            if (has_color(format)) rgb(CombineFunction::replace, {texture});
            if (has_alpha(format)) alpha(CombineFunction::replace, {texture});
            break;
        case TexEnvMode::modulate:
            if (has_color(format)) rgb(CombineFunction::modulate, {texture, previous});
            result.rgb_scale = env.rgb_scale;
            break;
        case TexEnvMode::decal:
            if (format == BaseFormat::rgb) rgb(CombineFunction::replace, {texture});
            if (format == BaseFormat::rgba)
                rgb(CombineFunction::interpolate, {texture, previous, texture_alpha});
            alpha(CombineFunction::replace, {previous});
            break;
        case TexEnvMode::blend:
            if (has_color(format)) rgb(CombineFunction::interpolate, {constant, previous, texture});
            if (intensity) alpha(CombineFunction::interpolate, {constant, previous, texture});
            break;
        case TexEnvMode::add:
            if (has_color(format)) rgb(CombineFunction::add, {texture, previous});
            if (intensity) alpha(CombineFunction::add, {texture, previous});
            break;
        case TexEnvMode::combine:
            break;
    }
    return result;
}

/// The colours that the arguments of COMBINE name.
template <NumericModel M>
struct CombineSources {
    Color<typename M::Channel> texture, constant, primary, previous;
};

/// The value of one argument. In the alpha function all operands read alpha: operands of colours
/// are not allowed there. @source OpenGL 1.3, tables 3.25 and 3.26
template <NumericModel M>
Color<typename M::Channel> argument_value(const M& m, const CombineArgument& argument,
                                          const CombineSources<M>& sources) {
    const std::array<const Color<typename M::Channel>*, 4> by_name{
        &sources.texture, &sources.constant, &sources.primary, &sources.previous};
    Color<typename M::Channel> value = *by_name[static_cast<std::size_t>(argument.source)];
    const bool of_alpha = argument.operand == CombineOperand::src_alpha ||
                          argument.operand == CombineOperand::one_minus_src_alpha;
    if (of_alpha) value = {value[3], value[3], value[3], value[3]};
    const bool inverted = argument.operand == CombineOperand::one_minus_src_color ||
                          argument.operand == CombineOperand::one_minus_src_alpha;
    if (inverted)
        for (auto& e : value) e = m.invert(e);
    return value;
}

/// 4 ((r0 - 1/2)(r1 - 1/2) + ...) as the combiners compute it: the sum of (2 r0 - 1)(2 r1 - 1).
template <NumericModel M>
typename M::Channel dot3(const M& m, Color<typename M::Channel> a, Color<typename M::Channel> b) {
    for (std::size_t k = 0; k < 3; ++k) {
        a[k] = m.expand_normal(a[k]);
        b[k] = m.expand_normal(b[k]);
    }
    return m.dot(a, b);
}

constexpr CombinerScale combiner_scale(int scale) {
    return scale == 4 ? CombinerScale::four
                      : (scale == 2 ? CombinerScale::two : CombinerScale::one);
}

/// One function of COMBINE on channel k, scaled and clamped to [0, 1]. REPLACE, MODULATE and
/// INTERPOLATE cannot leave that range unscaled and are not clamped then.
/// @source OpenGL 1.3, table 3.24
template <NumericModel M>
typename M::Channel combine_function(const M& m, CombineFunction function, int scale, std::size_t k,
                                     const std::array<Color<typename M::Channel>, 3>& argument) {
    const auto clamped = [&m](typename M::Channel x, int by, bool bias = false) {
        return m.clamp_unsigned(m.scale_and_bias(x, combiner_scale(by), bias));
    };
    const auto scaled = [&](typename M::Channel x) { return scale == 1 ? x : clamped(x, scale); };
    const auto a = argument[0][k], b = argument[1][k];
    switch (function) {
        case CombineFunction::replace:
            break;
        case CombineFunction::modulate:
            return scaled(m.modulate(a, b));
        case CombineFunction::add:
            return clamped(m.add(a, b), scale);
        case CombineFunction::add_signed:
            return clamped(m.add(a, b), m.add_signed_scale(scale), true);
        case CombineFunction::interpolate:
            return scaled(m.lerp(a, b, argument[2][k]));
        case CombineFunction::subtract:
            return clamped(m.add(a, m.negate(b)), scale);
        case CombineFunction::dot3_rgb:
        case CombineFunction::dot3_rgba:
            return clamped(dot3(m, argument[0], argument[1]), scale);
    }
    return scaled(a);
}

/// DOT3_RGBA writes its result, with ALPHA_SCALE, into alpha too; the alpha function is not looked
/// at.
template <NumericModel M>
Color<typename M::Channel> apply_combine(const M& m, const TexEnv& env,
                                         const CombineSources<M>& sources) {
    const auto values = [&](const std::array<CombineArgument, 3>& arguments) {
        return std::array{argument_value(m, arguments[0], sources),
                          argument_value(m, arguments[1], sources),
                          argument_value(m, arguments[2], sources)};
    };
    const auto rgb = values(env.rgb);
    Color<typename M::Channel> result;
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = combine_function(m, env.combine_rgb, env.rgb_scale, k, rgb);
    result[3] = env.combine_rgb == CombineFunction::dot3_rgba
                    ? combine_function(m, env.combine_rgb, env.alpha_scale, 3, rgb)
                    : combine_function(m, env.combine_alpha, env.alpha_scale, 3, values(env.alpha));
    return result;
}

/// The colour that a unit hands on.
/// @param env_color TEXTURE_ENV_COLOR as constant_color() gives it
/// @param format    of the texture
/// @param previous  from the unit before, or the primary colour
/// @param texel     filtered; as the base format keeps it: (L, L, L, 1), (I, I, I, I), (0, 0, 0, A)
template <NumericModel M>
Color<typename M::Channel> apply_tex_env(const M& m, const TexEnv& env,
                                         const Color<typename M::Channel>& env_color,
                                         BaseFormat format,
                                         const Color<typename M::Channel>& previous,
                                         const Color<typename M::Channel>& texel,
                                         const Color<typename M::Channel>& primary) {
    const CombineSources<M> sources{texel, env_color, primary, previous};
    if (env.mode == TexEnvMode::combine) return apply_combine(m, env, sources);
    return apply_combine(m, as_combine(env, format), sources);
}

}  // namespace twofold
