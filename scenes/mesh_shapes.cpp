#include "scenes/mesh_shapes.hpp"

#include <array>
#include <string>

#include "texunit/error.hpp"

namespace twofold {
namespace {

/// A face of the cube: the axis it looks along, and the axes of its columns and rows, with
/// column x row = outward, so that all faces are wound alike.
struct CubeFace {
    Vec3 outward, column, row;
};

const std::array<CubeFace, 6>& cube_faces() {
    static const std::array<CubeFace, 6> faces{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                                {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                                {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};
    return faces;
}

void append_vertices(Mesh& mesh, const CubeFace& face, int n) {
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            // The numerator is exact and odd in i - n/2, so both faces at an edge get the same
            // point.
            const double u = static_cast<double>(2 * i - n) / n;
            const double v = static_cast<double>(2 * j - n) / n;
            const Vec3 point = normalized(face.outward + face.column * u + face.row * v);
            mesh.positions.push_back(point);
            mesh.normals.push_back(point);
        }
}

/// Two triangles for each square of the (n + 1) x (n + 1) vertices that start at `first`.
void append_triangles(Mesh& mesh, std::uint32_t first, std::uint32_t n) {
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = first + j * (n + 1) + i;
            const std::uint32_t d = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
        }
}

}  // namespace

Mesh sphere_mesh(int n) {
    if (n < 1 || n > 1024)
        throw Error(ExitCode::failure, "sphere of " + std::to_string(n) +
                                           " squares along an edge, allowed are 1 to 1024");
    Mesh mesh;
    for (const CubeFace& face : cube_faces()) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        append_vertices(mesh, face, n);
        append_triangles(mesh, first, static_cast<std::uint32_t>(n));
    }
    return mesh;
}

Mesh quad_mesh() {
    Mesh mesh;
    for (const Vec2 corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
        mesh.positions.emplace_back(2.0 * corner.x - 1.0, 2.0 * corner.y - 1.0, 0.0);
        mesh.normals.emplace_back(0.0, 0.0, 1.0);
        mesh.texcoords[0].emplace_back(corner.x, corner.y, 0.0, 1.0);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

}  // namespace twofold
