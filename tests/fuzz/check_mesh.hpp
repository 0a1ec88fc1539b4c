#pragma once
#include <cmath>

#include "scenes/mesh_file.hpp"
#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

inline bool is_unit(Vec3 v) { return std::abs(dot(v, v) - 1.0) < 1e-6; }

/// Triangles of vertices that are there, with finite positions and unit normals.
inline void check_mesh(const Mesh& mesh) {
    promise(!mesh.indices.empty() && mesh.indices.size() % 3 == 0, "no whole triangles");
    promise(mesh.normals.size() == mesh.positions.size(), "vertices without normals");
    for (const std::uint32_t index : mesh.indices)
        promise(index < mesh.positions.size(), "an index beyond the vertices");
    for (const Vec3 p : mesh.positions)
        promise(std::isfinite(dot(p, p)), "a position that is not finite");
    for (const Vec3 n : mesh.normals) promise(is_unit(n), "a normal that is not unit");
    promise(inspect(mesh).triangles == mesh.indices.size() / 3, "a report of another mesh");
}

}  // namespace twofold::hostile
