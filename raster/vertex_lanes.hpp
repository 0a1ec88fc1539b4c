#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/pass.hpp"

/// The vertex stage on vectors: what transform.hpp, texgen.hpp and project.hpp compute, for blocks
/// of vertices, in the three arithmetics that presets use. Numbers travel as binary64, which holds
/// every word of the narrower formats.
namespace twofold::lanes {

enum class VertexArithmetic { binary64, binary32, nv1x, nv2x };

inline constexpr std::size_t vertex_block = 256;

using Row = std::array<double, 4>;
using Rows = std::array<Row, 4>;

/// Limits within which vectors compute what single fragments do, with room to spare before any
/// product overflows even binary32.
inline constexpr double largest_coordinate = 1152921504606846976.0;  // 2^60
inline constexpr double smallest_q = 1.0 / largest_coordinate;

/// How a set's coordinates come about.
struct SetRule {
    std::array<TexGen, 4> mode;
    Rows plane;  ///< of the linear modes
    Rows matrix;
};

struct VertexRule {
    Rows composite, modelview;
    std::array<Row, 3> normal;  ///< the fourth of each is unused
    bool needs_eye = false, needs_normal = false, needs_reflection = false, normalize = false;
    std::size_t sets = 0;
    std::array<SetRule, max_units> set;
    std::array<double, 3> offset;      ///< of the viewport, as the arithmetic holds it
    std::array<double, 3> offset_f64;  ///< the same for clipping, which is in binary64
    double snap;                       ///< snap units in a pixel
    bool perspective = true, over_w = true;
    double width, height;  ///< of the picture, pixels
};

/// One component of all vertices: values[i step], up to a full vector further. With step 0 all
/// vertices have the same.
struct VertexSource {
    const double* values;
    std::size_t step;
};

/// A mesh's vertices as the arithmetic takes them.
struct VertexInput {
    std::array<VertexSource, 4> position;
    std::array<VertexSource, 3> normal;
    std::array<std::array<VertexSource, 4>, max_units> own;  ///< coordinates of each set
};

template <class T>
using VertexColumn = std::array<T, vertex_block>;

struct VertexOutput {
    alignas(64) VertexColumn<std::int32_t> x, y;  ///< in snap units
    alignas(64) VertexColumn<double> z, inverse_w;
    alignas(64) std::array<std::array<VertexColumn<double>, 4>, max_units> coords;
    /// outcode() of clip.hpp, and the bits of VertexFlags of window_mesh.hpp: bit k of each group
    /// of four belongs to set k; positive, negative, bounded, and bit 12 finite.
    alignas(64) VertexColumn<std::uint64_t> outcode, flags;
    /// Vertices for which the chip's arithmetic meets an infinity; the rest of theirs is void.
    alignas(64) VertexColumn<double> wild;  ///< not 0
};

/// Vertices first to first + count - 1, at most vertex_block.
void transform_block(VertexArithmetic arithmetic, const VertexRule& rule, const VertexInput& in,
                     std::size_t first, std::size_t count, VertexOutput& out);

}  // namespace twofold::lanes
