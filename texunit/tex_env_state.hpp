#pragma once
#include <array>

#include "texunit/linear.hpp"

/// State of a texture environment, in OpenGL's terms.
/// @source OpenGL 1.3, 3.8.12
namespace twofold {

enum class TexEnvMode { replace, modulate, decal, blend, add, combine };

enum class CombineFunction {
    replace,
    modulate,
    add,
    add_signed,
    interpolate,
    subtract,
    dot3_rgb,  ///< RGB only
    dot3_rgba  ///< RGB only; its result is the alpha too
};

enum class CombineSource { texture, constant, primary_color, previous };

enum class CombineOperand { src_color, one_minus_src_color, src_alpha, one_minus_src_alpha };

struct CombineArgument {
    CombineSource source = CombineSource::texture;
    CombineOperand operand = CombineOperand::src_color;
    bool operator==(const CombineArgument&) const = default;
};

/// Initial values as OpenGL's: MODULATE, and for COMBINE texture times previous.
struct TexEnv {
    TexEnvMode mode = TexEnvMode::modulate;
    Vec4 color{0.0};  ///< TEXTURE_ENV_COLOR
    CombineFunction combine_rgb = CombineFunction::modulate;
    CombineFunction combine_alpha = CombineFunction::modulate;
    std::array<CombineArgument, 3> rgb{
        CombineArgument{CombineSource::texture, CombineOperand::src_color},
        CombineArgument{CombineSource::previous, CombineOperand::src_color},
        CombineArgument{CombineSource::constant, CombineOperand::src_alpha}};
    std::array<CombineArgument, 3> alpha{
        CombineArgument{CombineSource::texture, CombineOperand::src_alpha},
        CombineArgument{CombineSource::previous, CombineOperand::src_alpha},
        CombineArgument{CombineSource::constant, CombineOperand::src_alpha}};
    int rgb_scale = 1;    ///< 1, 2 or 4; with COMBINE, and with MODULATE as a shorthand for it
    int alpha_scale = 1;  ///< 1, 2 or 4; with COMBINE
    bool operator==(const TexEnv&) const = default;
};

/// Base internal formats, which decide what a texture supplies to its environment.
/// @source OpenGL 1.3, table 3.15
enum class BaseFormat { alpha, luminance, luminance_alpha, intensity, rgb, rgba };

}  // namespace twofold
