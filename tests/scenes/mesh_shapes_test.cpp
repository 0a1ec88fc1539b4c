#include "scenes/mesh_shapes.hpp"

#include <catch2/catch.hpp>

#include "scenes/mesh_file.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace {
using namespace twofold;
}

TEST_CASE("a sphere is closed, wound outward and has 12 n^2 triangles", "[mesh]") {
    for (const int n : {1, 2, 3, 7, 16}) {
        const MeshReport report = inspect(sphere_mesh(n));
        CHECK(report.triangles == static_cast<std::size_t>(12 * n * n));
        CHECK(report.degenerate == 0);
        CHECK(report.boundary_edges == 0);
        CHECK(report.non_manifold_edges == 0);
        CHECK(report.signed_volume > 0.0);
    }
    CHECK(inspect(sphere_mesh(64)).signed_volume == Approx(4.0 / 3.0 * exact::pi).epsilon(0.001));
}

TEST_CASE("every triangle of a sphere faces outward, and its normals are its positions", "[mesh]") {
    const Mesh mesh = sphere_mesh(5);
    CHECK(mesh.normals == mesh.positions);
    for (const Vec3& p : mesh.positions) CHECK(length(p) == Approx(1.0).margin(1e-15));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = mesh.positions[mesh.indices[i]];
        const Vec3 b = mesh.positions[mesh.indices[i + 1]];
        const Vec3 c = mesh.positions[mesh.indices[i + 2]];
        CHECK(dot(cross(b - a, c - a), a + b + c) > 0.0);
    }
}

TEST_CASE("a sphere without squares or with too many is refused", "[mesh]") {
    CHECK_THROWS_AS(sphere_mesh(0), Error);
    CHECK_THROWS_AS(sphere_mesh(1025), Error);
}

TEST_CASE("the quad covers the square and faces +z", "[mesh]") {
    const Mesh mesh = quad_mesh();
    CHECK(mesh.positions[0] == Vec3(-1, -1, 0));
    CHECK(mesh.positions[2] == Vec3(1, 1, 0));
    CHECK(mesh.texcoords[0][0] == Vec4(0, 0, 0, 1));
    CHECK(mesh.texcoords[0][2] == Vec4(1, 1, 0, 1));
    CHECK(mesh.normals == std::vector<Vec3>(4, Vec3(0, 0, 1)));
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = mesh.positions[mesh.indices[i]];
        const Vec3 b = mesh.positions[mesh.indices[i + 1]];
        area += cross(b - a, mesh.positions[mesh.indices[i + 2]] - a).z / 2.0;
    }
    CHECK(area == 4.0);
}
