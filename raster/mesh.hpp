#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "texunit/combiner_state.hpp"
#include "texunit/linear.hpp"

namespace twofold {

/// How the index list makes triangles. @source OpenGL 1.3, 2.6.1
enum class Primitive { triangles, triangle_strip, triangle_fan, quads, quad_strip, polygon };

/// Indexed primitives, counter-clockwise seen from their front.
struct Mesh {
    std::vector<Vec3> positions;  ///< object space, or window space where the pass says so
    std::vector<Vec3> normals;    ///< one per vertex: unit, object space
    /// s, t, r, q for each unit: empty or one per vertex. A unit without its own reads those of
    /// unit 0.
    std::array<std::vector<Vec4>, max_units> texcoords;
    std::vector<Vec4> colors;            ///< r, g, b, a in [0, 1]: empty or one per vertex
    std::vector<std::uint32_t> indices;  ///< into the lists above
    std::vector<Vec4> secondary_colors;  ///< r, g, b, unused: empty (0) or one per vertex
    std::vector<double> position_w;      ///< empty (1) or one per vertex
    Primitive primitive = Primitive::triangles;
};

}  // namespace twofold
