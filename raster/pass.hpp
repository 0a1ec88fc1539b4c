#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "raster/mesh.hpp"
#include "texunit/texture.hpp"
#include "texunit/unit_state.hpp"

/// What is drawn: plain values in OpenGL 1.3's terms. What is not declared is off, is not simulated
/// and costs nothing.
namespace twofold {

enum class CompareFunc { never, less, equal, lequal, greater, notequal, gequal, always };

enum class CullFace { none, front, back };

/// @source OpenGL 1.3, tables 4.1 and 4.2; as in that version source factors lack src_color and
/// destination factors lack dst_color, which is not enforced: later versions allow both.
enum class BlendFactor {
    zero,
    one,
    src_color,
    one_minus_src_color,
    dst_color,
    one_minus_dst_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
    src_alpha_saturate,
    constant_color,
    one_minus_constant_color,
    constant_alpha,
    one_minus_constant_alpha
};

/// @source OpenGL 1.3 with ARB_imaging, 4.1.7
enum class BlendEquation { add, subtract, reverse_subtract, min, max };

enum class ShadeModel { smooth, flat };

/// The vertex whose colour a flat triangle takes; quads always take their last.
enum class ProvokingVertex { last, first };

enum class FogMode { linear, exp, exp2 };

struct AlphaTest {
    CompareFunc func = CompareFunc::gequal;
    double reference = 0.5;  ///< 0..1; 8-bit presets round it to a byte
    bool operator==(const AlphaTest&) const = default;
};

struct DepthTest {
    CompareFunc func = CompareFunc::less;
    bool write = true;  ///< DepthMask
    bool operator==(const DepthTest&) const = default;
};

struct Blend {
    BlendFactor source = BlendFactor::one;
    BlendFactor destination = BlendFactor::zero;
    BlendEquation equation = BlendEquation::add;
    Vec4 color{0.0};  ///< BLEND_COLOR
    bool operator==(const Blend&) const = default;
};

/// Fog by the eye-space distance |z|, its factor computed at the vertices.
/// @source OpenGL 1.3, 3.10
struct Fog {
    FogMode mode = FogMode::exp;
    double density = 1.0;
    double start = 0.0, end = 1.0;  ///< linear
    Rgb color{0.0};
    bool operator==(const Fog&) const = default;
};

/// Pixels x..x + width - 1, y..y + height - 1 from the top left.
struct Scissor {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Scissor&) const = default;
};

/// Window x, y, z = clip x, y, z / w + offset, in pixels with y down and depth 0..1. The scale is
/// folded into the projection. The offset holds the preset's snap bias where the pass does not give
/// a viewport.
struct Viewport {
    Vec3 scale;
    Vec3 offset;
    bool operator==(const Viewport&) const = default;
};

/// The state of one pass over a mesh. Matrices act on column vectors; a triangle is front-facing
/// when its vertices run counter-clockwise on the screen (y up).
struct PassState {
    Mat4 modelview{1.0};
    Mat4 projection{1.0};
    std::optional<Viewport> viewport;  ///< none: the whole picture
    bool window_space =
        false;        ///< positions are window x, y (pixels, y down), depth 0..1 and w already
    Vec4 color{1.0};  ///< r, g, b, a of every vertex of a mesh without colours
    bool normalize = false;  ///< NORMALIZE: eye-space normals are made unit length
    CullFace cull = CullFace::none;
    ShadeModel shade_model = ShadeModel::smooth;
    ProvokingVertex provoking_vertex = ProvokingVertex::last;
    bool perspective_correction = true;  ///< off: colours and coordinates are linear in the window
    std::array<std::optional<TextureUnitState>, max_units> units;
    std::optional<RegisterCombiners> combiners;  ///< in place of the units' environments
    bool color_sum = false;                      ///< adds the secondary colour after the units
    std::optional<Fog> fog;
    std::optional<Scissor> scissor;
    std::optional<AlphaTest> alpha_test;
    std::optional<DepthTest> depth_test;
    std::optional<Blend> blend;
    std::array<bool, 4> color_mask{true, true, true, true};
    bool dither = false;  ///< 16-bit targets: the 4 x 4 Bayer matrix, named and chosen

    bool operator==(const PassState&) const = default;
};

/// `state` without what cannot change a pixel, so that equal drawings have equal states: a test
/// that always passes, a blend that replaces, a normalisation nobody reads.
PassState normalized(PassState state);

/// One pass: a state and the mesh it is drawn with.
struct Pass {
    PassState state;
    std::size_t mesh = 0;  ///< index into the frame's meshes
};

/// How the framebuffer stores colour. Missing alpha reads 1 in blending; `z` formats write it as 0,
/// `o` as 1.
enum class ColorFormat { rgba8888, xrgb8888_z, xrgb8888_o, rgb565, xrgb1555_z, xrgb1555_o };

/// A whole picture as a value: render() needs nothing else.
struct Frame {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    Vec4 clear_color{0.0};
    double clear_depth = 1.0;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    std::vector<Pass> passes;  ///< in the order in which they are drawn
    ColorFormat color_format = ColorFormat::rgba8888;
    int depth_bits = 24;  ///< 16 or 24; ideal64 keeps binary64
    /// What the picture holds at the start in place of the clear colour, rows top down.
    std::optional<ByteImage> initial_color;
};

/// Also without what cannot change a pixel of this frame: a scissor around the whole picture,
/// dither of 8-bit channels.
PassState normalized(const Frame& frame, const Pass& pass);

}  // namespace twofold
