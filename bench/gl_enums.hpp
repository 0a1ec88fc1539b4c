#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>

#include "raster/pass.hpp"

/// OpenGL's constants for our enumerators, which are named after them; tables in the enumerators'
/// order.
namespace twofold::bench {

template <class Enum, std::size_t n>
constexpr GLenum entry(const std::array<GLenum, n>& table, Enum value) {
    return table[static_cast<std::size_t>(value)];
}

constexpr GLenum gl(CompareFunc f) {
    constexpr std::array<GLenum, 8> table{GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                          GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
    return entry(table, f);
}

constexpr GLenum gl(BlendFactor f) {
    constexpr std::array<GLenum, 15> table{GL_ZERO,
                                           GL_ONE,
                                           GL_SRC_COLOR,
                                           GL_ONE_MINUS_SRC_COLOR,
                                           GL_DST_COLOR,
                                           GL_ONE_MINUS_DST_COLOR,
                                           GL_SRC_ALPHA,
                                           GL_ONE_MINUS_SRC_ALPHA,
                                           GL_DST_ALPHA,
                                           GL_ONE_MINUS_DST_ALPHA,
                                           GL_SRC_ALPHA_SATURATE,
                                           GL_CONSTANT_COLOR,
                                           GL_ONE_MINUS_CONSTANT_COLOR,
                                           GL_CONSTANT_ALPHA,
                                           GL_ONE_MINUS_CONSTANT_ALPHA};
    return entry(table, f);
}

constexpr GLenum gl(BlendEquation e) {
    constexpr std::array<GLenum, 5> table{GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                          GL_MIN, GL_MAX};
    return entry(table, e);
}

constexpr GLenum gl(FogMode m) {
    constexpr std::array<GLenum, 3> table{GL_LINEAR, GL_EXP, GL_EXP2};
    return entry(table, m);
}

constexpr GLenum gl(Primitive p) {
    constexpr std::array<GLenum, 6> table{GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                          GL_QUADS,     GL_QUAD_STRIP,     GL_POLYGON};
    return entry(table, p);
}

/// `none` has no constant: callers leave generation off.
constexpr GLenum gl(TexGen t) {
    constexpr std::array<GLenum, 6> table{
        0, GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_NORMAL_MAP, GL_REFLECTION_MAP};
    return entry(table, t);
}

constexpr GLenum gl(Wrap w) {
    constexpr std::array<GLenum, 5> table{GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER,
                                          GL_MIRRORED_REPEAT};
    return entry(table, w);
}

constexpr GLenum gl(TextureTarget t) {
    constexpr std::array<GLenum, 3> table{GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP};
    return entry(table, t);
}

constexpr GLenum gl(TexEnvMode m) {
    constexpr std::array<GLenum, 6> table{GL_REPLACE, GL_MODULATE, GL_DECAL,
                                          GL_BLEND,   GL_ADD,      GL_COMBINE};
    return entry(table, m);
}

constexpr GLenum gl(CombineFunction f) {
    constexpr std::array<GLenum, 8> table{GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                          GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
    return entry(table, f);
}

constexpr GLenum gl(CombineSource s) {
    constexpr std::array<GLenum, 4> table{GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
    return entry(table, s);
}

constexpr GLenum gl(CombineOperand o) {
    constexpr std::array<GLenum, 4> table{GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                                          GL_ONE_MINUS_SRC_ALPHA};
    return entry(table, o);
}

/// The sized format that stores texels of 8 bits (`floats`: of 32) a component.
constexpr GLenum gl(BaseFormat f, bool floats) {
    constexpr std::array<GLenum, 6> bytes{GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                          GL_INTENSITY8, GL_RGB8,       GL_RGBA8};
    constexpr std::array<GLenum, 6> real{
        GL_ALPHA32F_ARB,     GL_LUMINANCE32F_ARB, GL_LUMINANCE_ALPHA32F_ARB,
        GL_INTENSITY32F_ARB, GL_RGB32F,           GL_RGBA32F};
    return floats ? entry(real, f) : entry(bytes, f);
}

constexpr GLenum gl_min_filter(Filter filter, MipFilter mip) {
    constexpr std::array<GLenum, 6> table{
        GL_NEAREST, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
        GL_LINEAR,  GL_LINEAR_MIPMAP_NEAREST,  GL_LINEAR_MIPMAP_LINEAR};
    return table[static_cast<std::size_t>(filter) * 3 + static_cast<std::size_t>(mip)];
}

constexpr GLenum gl_mag_filter(Filter filter) {
    return filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
}

}  // namespace twofold::bench
