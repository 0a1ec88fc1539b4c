#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "raster/mesh.hpp"
#include "raster/pass.hpp"

namespace twofold {

/// One triangle of a primitive: vertex numbers, and the vertex whose colour it takes under flat
/// shading.
struct AssembledTriangle {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t provoking;
};

/// Triangles of a mesh in drawing order. Odd triangles of a strip exchange their first two
/// vertices, quads split along (0, 2), quad strips along (2, 1) of each four. Triangles, strips and
/// fans obey the provoking vertex; quads take their last vertex and polygons vertex 0 whatever it
/// says. Left-over vertices draw nothing.
/// @source captures of NV2A for strips, quads and polygons; OpenGL 1.3, 2.14.7 and table 2.13
std::vector<AssembledTriangle> assemble(Primitive primitive,
                                        const std::vector<std::uint32_t>& indices,
                                        ProvokingVertex provoking);

}  // namespace twofold
