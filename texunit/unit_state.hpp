#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "texunit/combiner_state.hpp"
#include "texunit/linear.hpp"
#include "texunit/tex_env_state.hpp"

/// State of one texture unit, in OpenGL's terms; enumerators are its constants in lower case.
namespace twofold {

/// How a texture coordinate is generated; `none` takes the vertex's own.
/// @source OpenGL 1.3, 2.10.4
enum class TexGen { none, object_linear, eye_linear, sphere_map, normal_map, reflection_map };

/// The modes of s, t, r, q and the planes of the linear ones. An eye plane is given in eye
/// coordinates, as OpenGL holds it after specification.
struct TexGenState {
    std::array<TexGen, 4> mode{TexGen::none, TexGen::none, TexGen::none, TexGen::none};
    std::array<Vec4, 4> object_plane{Vec4{1, 0, 0, 0}, Vec4{0, 1, 0, 0}, Vec4{0.0}, Vec4{0.0}};
    std::array<Vec4, 4> eye_plane{Vec4{1, 0, 0, 0}, Vec4{0, 1, 0, 0}, Vec4{0.0}, Vec4{0.0}};
    bool operator==(const TexGenState&) const = default;
};

/// The same mode for s, t and r, as NORMAL_MAP and REFLECTION_MAP are used; SPHERE_MAP for s and t.
constexpr TexGenState texgen_all(TexGen mode) {
    TexGenState state;
    state.mode = {mode, mode, mode == TexGen::sphere_map ? TexGen::none : mode, TexGen::none};
    return state;
}

constexpr bool any_mode(const TexGenState& texgen, TexGen a, TexGen b, TexGen c) {
    for (const TexGen mode : texgen.mode)
        if (mode == a || mode == b || mode == c) return true;
    return false;
}

/// Whether a coordinate is made from the reflected view.
constexpr bool uses_reflection(const TexGenState& texgen) {
    return any_mode(texgen, TexGen::sphere_map, TexGen::reflection_map, TexGen::reflection_map);
}

/// Whether a coordinate is made from the eye-space normal.
constexpr bool uses_normal(const TexGenState& texgen) {
    return any_mode(texgen, TexGen::normal_map, TexGen::sphere_map, TexGen::reflection_map);
}

/// Whether a coordinate is made from the eye-space position.
constexpr bool uses_eye_position(const TexGenState& texgen) {
    return any_mode(texgen, TexGen::eye_linear, TexGen::sphere_map, TexGen::reflection_map);
}

/// @source OpenGL 1.3, 3.8.4 and 3.8.5; mirrored_repeat of OpenGL 1.4, 3.8.6
enum class Wrap { repeat, clamp, clamp_to_edge, clamp_to_border, mirrored_repeat };

/// Filter between the texels of one image.
enum class Filter { nearest, linear };

/// Filter between mipmap levels; `off` uses the base level alone.
enum class MipFilter { off, nearest, linear };

/// Which image of the texture's a lookup reads.
enum class TextureTarget {
    texture_2d,
    rectangle,  ///< coordinates in texels instead of 0..1, as NV_texture_rectangle
    cube_map    ///< by the direction (s, t, r)
};

/// A texture unit that is switched on.
struct TextureUnitState {
    /// Index into the frame's textures; none reads as white (T11).
    std::optional<std::size_t> texture;
    TextureTarget target = TextureTarget::texture_2d;
    TexGenState texgen;
    Mat4 matrix{1.0};  ///< texture matrix, applied to generated coordinates too
    bool divide_by_q = true;
    Wrap wrap_s = Wrap::clamp_to_edge;
    Wrap wrap_t = Wrap::clamp_to_edge;
    Filter min_filter = Filter::linear;
    Filter mag_filter = Filter::linear;
    MipFilter mip_filter = MipFilter::off;
    double lod_bias = 0.0;  ///< levels
    Vec4 border_color{0.0};
    TexEnv env;

    bool operator==(const TextureUnitState&) const = default;
};

}  // namespace twofold
