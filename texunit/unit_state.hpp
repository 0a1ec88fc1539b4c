#pragma once
#include <cstddef>
#include <optional>

#include "texunit/linear.hpp"

/// State of one texture unit, in OpenGL's terms; enumerators are its constants in lower case.
namespace twofold {

/// TexGen mode of s, t and r together; `none` takes the vertex's own texture coordinates.
/// @source OpenGL 1.3, 2.10.4
enum class TexGen { none, normal_map, reflection_map };

/// @source OpenGL 1.3, 3.8.4 and 3.8.5
enum class Wrap { repeat, clamp, clamp_to_edge, clamp_to_border };

/// One filter for magnification and minification: without mipmaps both are the same choice.
enum class Filter { nearest, linear };

/// A texture unit that is switched on. Its environment is MODULATE: the incoming colour times the
/// texel, each channel with each (base format RGBA), then times RGB_SCALE.
struct TextureUnitState {
    std::optional<std::size_t>
        texture;  ///< index into the frame's textures; none reads as white (T11)
    TexGen texgen = TexGen::none;
    Mat4 matrix{1.0};  ///< texture matrix, applied to generated coordinates too
    Wrap wrap_s = Wrap::clamp_to_edge;
    Wrap wrap_t = Wrap::clamp_to_edge;
    Filter filter = Filter::linear;
    Vec4 border_color{0.0};
    int rgb_scale = 1;  ///< RGB_SCALE of the COMBINE environment: 1, 2 or 4; alpha is not scaled

    bool operator==(const TextureUnitState&) const = default;
};

}  // namespace twofold
