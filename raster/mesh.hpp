#pragma once
#include <cstdint>
#include <vector>

#include "texunit/linear.hpp"

namespace twofold {

/// Indexed triangles; three indices make one triangle, counter-clockwise seen from its front.
struct Mesh {
    std::vector<Vec3> positions;         ///< object space
    std::vector<Vec3> normals;           ///< one per vertex: unit, object space
    std::vector<Vec4> texcoords;         ///< s, t, r, q: empty or one per vertex
    std::vector<Vec4> colors;            ///< r, g, b, a in [0, 1]: empty or one per vertex
    std::vector<std::uint32_t> indices;  ///< into the lists above
};

}  // namespace twofold
