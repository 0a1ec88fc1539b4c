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
/// destination factors lack dst_color, which `normalized` does not forbid: later versions allow
/// both.
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
    src_alpha_saturate
};

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
    bool operator==(const Blend&) const = default;
};

/// The state of one pass over a mesh. Matrices act on column vectors; a triangle is front-facing
/// when its vertices run counter-clockwise on the screen (y up).
struct PassState {
    Mat4 modelview{1.0};
    Mat4 projection{1.0};
    Vec4 color{1.0};         ///< r, g, b, a of every vertex of a mesh without colours
    bool normalize = false;  ///< NORMALIZE: eye-space normals are made unit length
    CullFace cull = CullFace::none;
    std::array<std::optional<TextureUnitState>, 2> units;
    std::optional<AlphaTest> alpha_test;
    std::optional<DepthTest> depth_test;
    std::optional<Blend> blend;
    std::array<bool, 4> color_mask{true, true, true, true};

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

/// A whole picture as a value: render() needs nothing else.
struct Frame {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    Vec4 clear_color{0.0};
    double clear_depth = 1.0;
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    std::vector<Pass> passes;  ///< in the order in which they are drawn
};

}  // namespace twofold
