#include "scenes/mesh_file.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "scenes/mesh_shapes.hpp"
#include "tests/scenes/mesh_text.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/fnv1a.hpp"

namespace {
using namespace twofold;
using namespace twofold::mesh_text;
using Catch::Contains;

std::uint64_t hash_of_normals(const Mesh& mesh) {
    Fnv1a hash;
    for (const Vec3& n : mesh.normals) hash.f64(n.x).f64(n.y).f64(n.z);
    return hash.value();
}

std::size_t non_unit_normals(const Mesh& mesh) {
    const auto is_unit = [](Vec3 n) { return length(n) > 1.0 - 1e-15 && length(n) < 1.0 + 1e-15; };
    return mesh.normals.size() - static_cast<std::size_t>(std::count_if(
                                     mesh.normals.begin(), mesh.normals.end(), is_unit));
}

/// A sphere by latitude and longitude whose rows at the poles are written as squares of which one
/// triangle has no area: 2 * `columns` degenerate triangles, as meshes cut from patches have them.
/// The points lie on a double pyramid, which needs no sine.
std::string pole_mesh(int columns) {
    std::string text;
    for (const int height : {-1, 0, 1})
        for (int column = 0; column < columns; ++column) {
            const int quarter = height == 0 ? column % 4 : -1;
            text += fmt::format("v {} {} {}\n", (quarter == 0) - (quarter == 2),
                                (quarter == 1) - (quarter == 3), height);
        }
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < columns; ++column) {
            const int a = row * columns + column + 1;
            const int b = row * columns + (column + 1) % columns + 1;
            text += fmt::format("f {} {} {} {}\n", a, b, b + columns, a + columns);
        }
    return text;
}
}  // namespace

TEST_CASE("Suzanne has the counts of its provenance", "[mesh]") {
    const Mesh mesh = read_ply(product_mesh("suzanne.ply"));
    CHECK(mesh.positions.size() == 7503);
    CHECK(non_unit_normals(mesh) == 0);
    const MeshReport report = inspect(mesh);
    CHECK(report.triangles == 14842);
    CHECK(report.degenerate == 0);
    CHECK(report.boundary_edges == 160);
    CHECK(report.signed_volume > 0.0);
    CHECK_FALSE(report.inverted);
}

TEST_CASE("the teapot is the same from OBJ and from PLY", "[mesh]") {
    const Mesh from_obj = read_obj(product_mesh("teapot.obj"));
    const Mesh from_ply = read_ply(product_mesh("teapot.ply"));
    CHECK(from_obj.positions.size() == 529);
    REQUIRE(from_obj.indices.size() == 3 * 992);
    REQUIRE(from_ply.indices.size() == from_obj.indices.size());
    for (std::size_t i = 0; i < from_obj.indices.size(); ++i) {
        const std::uint32_t a = from_obj.indices[i];
        const std::uint32_t b = from_ply.indices[i];
        CHECK(length(from_obj.positions[a] - from_ply.positions[b]) < 2e-6);
        CHECK(length(from_obj.normals[a] - from_ply.normals[b]) < 2e-6);
    }
    const MeshReport report = inspect(from_obj);
    CHECK(report.boundary_edges == 64);
    CHECK(report.degenerate == 0);
    CHECK(report.signed_volume == Approx(3172.5).epsilon(0.01));
}

TEST_CASE("tinyobjloader reads the same teapot", "[mesh]") {
    tinyobj::ObjReader reader;
    REQUIRE(reader.ParseFromFile(product_mesh("teapot.obj").string()));
    const auto& indices = reader.GetShapes().at(0).mesh.indices;
    const auto& vertices = reader.GetAttrib().vertices;
    const Mesh mesh = read_obj(product_mesh("teapot.obj"));
    REQUIRE(indices.size() == mesh.indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto v = 3 * static_cast<std::size_t>(indices[i].vertex_index);
        const Vec3 theirs(vertices[v], vertices[v + 1], vertices[v + 2]);
        CHECK(length(mesh.positions[mesh.indices[i]] - theirs) < 2e-6);
    }
}

TEST_CASE("D09 inverted winding is reported with its sign and nothing is flipped",
          "[mesh][hard][D09]") {
    Mesh mesh = read_ply(product_mesh("teapot.ply"));
    const MeshReport upright = inspect(mesh);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    const MeshReport mirrored = inspect(mesh);
    CHECK_FALSE(upright.inverted);
    CHECK(mirrored.inverted);
    CHECK(mirrored.signed_volume == -upright.signed_volume);
    CHECK(mirrored.boundary_edges == upright.boundary_edges);
}

TEST_CASE("D10 degenerate triangles are counted and give no NaN", "[mesh][hard][D10]") {
    const Mesh mesh = obj(pole_mesh(40));
    const MeshReport report = inspect(mesh);
    CHECK(report.triangles == 160);
    CHECK(report.degenerate == 80);
    CHECK(report.boundary_edges == 0);
    CHECK(non_unit_normals(mesh) == 0);
    const Mesh point = obj("v 1 1 1\nf 1 1 1\n");
    CHECK(point.normals == std::vector<Vec3>{Vec3(0, 0, 1)});
    CHECK(inspect(point).degenerate == 1);
}

TEST_CASE("D11 open and non-manifold edges are counted", "[mesh][hard][D11]") {
    CHECK(inspect(obj(three_points + "f 1 2 3\n")).boundary_edges == 3);
    const MeshReport fins =
        inspect(obj(three_points + "v 0 0 1\nv 0 1 1\nf 1 2 3\nf 1 2 4\nf 2 1 5\n"));
    CHECK(fins.non_manifold_edges == 1);
    CHECK(fins.boundary_edges == 6);
}

TEST_CASE("D11 missing normals follow the stated rule, bit by bit", "[mesh][hard][D11]") {
    const Mesh cube =
        obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
            "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    // Each face has a right angle at each corner, however it is cut: the diagonals of the cube.
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        const Vec3 expected = normalized(cube.positions[i] - Vec3(0.5));
        CHECK(length(cube.normals[i] - expected) < 1e-15);
    }
    CHECK(inspect(cube).signed_volume == Approx(1.0));
    std::string text = read_text_file(product_mesh("teapot.obj"), 1 << 20);
    for (std::size_t at = 0; (at = text.find("\nvn ", at)) != std::string::npos; ++at)
        text.replace(at, 4, "\nvn 0 0 0 # ");
    const Mesh teapot = obj(text);
    const Mesh original = read_obj(product_mesh("teapot.obj"));
    for (std::size_t i = 0; i < teapot.normals.size(); ++i)
        CHECK(length(teapot.normals[i] - original.normals[i]) < 5e-6);
    CHECK(hash_of_normals(teapot) == 0x7baffc7d1b4a33c2);
}

TEST_CASE("texture coordinates, colours and normals go with their corners", "[mesh]") {
    const Mesh mesh =
        obj("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvt 0.25 0.5\nvt 1 1\nvn 0 0 2\n"
            "f 1/1/1 2/2/1 3/1/1\nf 1/2 2/2 3/1\n");
    CHECK(mesh.positions.size() == 6);
    CHECK(mesh.texcoords[0][0] == Vec4(0.25, 0.5, 0, 1));
    CHECK(mesh.texcoords[0][3] == Vec4(1, 1, 0, 1));
    CHECK(mesh.colors[1] == Vec4(0, 1, 0, 1));
    CHECK(mesh.normals == std::vector<Vec3>(6, Vec3(0, 0, 1)));
    CHECK_THROWS_WITH(obj("v 0 0 0 2 0 0\n"), Contains("colour outside"));
}

TEST_CASE("an ascii PLY file of any face size and other elements is read", "[mesh]") {
    const Mesh mesh = ply(ascii_ply(4, 1, "0 0 0 1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"));
    CHECK(mesh.indices == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
    CHECK(mesh.normals == std::vector<Vec3>(4, Vec3(0, 0, 1)));
    const std::string with_more =
        "ply\nformat ascii 1.0\nelement other 2\nproperty list uchar float w\nproperty int k\n"
        "element vertex 3\nproperty double x\nproperty double y\nproperty double z\nproperty uchar "
        "red\n"
        "element face 1\nproperty uchar flag\nproperty list uchar uint vertex_index\nend_header\n"
        "2 0.5 0.5 7 0 8 0 0 0 255 1 0 0 255 0 1 0 255 9 3 0 1 2\n";
    CHECK(ply(with_more).positions.size() == 3);
}
