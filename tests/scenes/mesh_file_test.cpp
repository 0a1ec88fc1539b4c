#include "scenes/mesh_file.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "scenes/mesh_shapes.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/fnv1a.hpp"

namespace {
using namespace twofold;
using namespace std::string_literals;
using Catch::Contains;
namespace fs = std::filesystem;

const TemporaryFolder& folder() {
    static const TemporaryFolder result;
    return result;
}

fs::path file_of(const std::string& text) {
    // Not write_file_atomically(): thousands of flushes to the disk would take half a minute.
    std::ofstream(folder() / "mesh", std::ios::binary) << text;
    return folder() / "mesh";
}

fs::path product_mesh(const std::string& name) {
    return fs::path(TWOFOLD_SOURCE_DIR) / "scenes/data/mesh" / name;
}

const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

Mesh obj(const std::string& text) { return read_obj(file_of(text)); }
Mesh ply(const std::string& text) { return read_ply(file_of(text)); }

std::string ascii_ply(int vertices, int faces, const std::string& data) {
    return fmt::format(
        "ply\nformat ascii 1.0\ncomment none\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n{}",
        vertices, faces, data);
}

/// True for a mesh, false for an Error of a bad file; anything else ends the test.
template <typename Read>
bool can_be_read(Read read, const std::string& text) {
    try {
        return !read(file_of(text)).indices.empty();
    } catch (const Error& error) {
        return error.code() != ExitCode::bad_file;
    }
}

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

TEST_CASE("D12 an index that is zero or beyond its list names its line", "[mesh][hard][D12]") {
    for (const std::string index :
         {"0", "4", "-4", "2147483648", "99999999999999999999", "-2147483649", "1.5", "x", "1/1",
          "1//1", "1/2/3/4", "1/", "/1", "--1", "+-1"}) {
        CAPTURE(index);
        CHECK_THROWS_WITH(obj(three_points + "\nf 1 2 " + index + "\n"), Contains("mesh:5: "));
    }
    CHECK(obj(three_points + "f -3 -2 -1\n").indices == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(obj("f 1 2 3\n" + three_points).indices.size() == 3);
}

TEST_CASE("D12 faces of 2 corners are refused and faces of 1,000 become a fan",
          "[mesh][hard][D12]") {
    CHECK_THROWS_WITH(obj(three_points + "f 1 2\n"), Contains("mesh:4: a face of 2 corners"));
    CHECK_THROWS_WITH(obj(three_points), Contains("no faces"));
    std::string text;
    std::string face = "f";
    for (int i = 0; i < 1000; ++i) {
        text += fmt::format("v {} {} 0\n", i, i * i);
        face += fmt::format(" {}", i + 1);
    }
    const Mesh mesh = obj(text + face + "\n");
    REQUIRE(mesh.indices.size() == 3 * 998);
    for (std::uint32_t t = 0; t < 998; ++t) {
        CHECK(mesh.indices[3 * t] == 0);
        CHECK(mesh.indices[3 * t + 1] == t + 1);
        CHECK(mesh.indices[3 * t + 2] == t + 2);
    }
}

TEST_CASE("D12 numbers are read whole or refused with their line", "[mesh][hard][D12]") {
    for (const std::string number : {"1e999", "-1e999", "nan", "inf", "1,5", "0x10", "1e", ".", "-",
                                     "1.2.3", "1e5x", "\xff"}) {
        CAPTURE(number);
        CHECK_THROWS_WITH(obj("v 0 0 " + number + "\n"), Contains("mesh:1: "));
    }
    const Mesh mesh = obj("v .5 -1. +1.25e-1 # comment\r\nv 1e-999 0.1 1E2\rv 0 1 0\nf 1 2 3\n");
    CHECK(mesh.positions[0] == Vec3(0.5, -1.0, 0.125));
    CHECK(mesh.positions[1] == Vec3(0.0, 0.1, 100.0));
    CHECK_THROWS_WITH(obj("v 1 2\n"), Contains("2 numbers where 3 to 6"));
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

TEST_CASE("D12 a PLY file that is damaged says how", "[mesh][hard][D12]") {
    const std::string points = "0 0 0 1 0 0 0 1 0 ";
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, points + "3 0 1 3")), Contains("face 0: index 3 into 3"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, points + "3 0 1 -1")), Contains("index -1"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, points + "2 0 1")), Contains("2 corners"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, points + "999999999 0 1")),
                      Contains("list of 999999999"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, "0 0 nan 1 0 0 0 1 0 3 0 1 2")),
                      Contains("'nan' is not a number"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 1, "0 0 1e99 1 0 0 0 1 0 3 0 1 2")), Contains("vertex 0"));
    CHECK_THROWS_WITH(ply(ascii_ply(2000000000, 1, points)), Contains("2000000000 vertices"));
    CHECK_THROWS_WITH(ply(ascii_ply(9000000, 1, points)), Contains("truncated"));
    CHECK_THROWS_WITH(ply(ascii_ply(-1, 1, points)), Contains("without a count"));
    CHECK_THROWS_WITH(ply(ascii_ply(3, 0, points)), Contains("no faces"));
    CHECK_THROWS_WITH(ply("ply\nformat binary_big_endian 1.0\n"), Contains("binary_big_endian"));
    CHECK_THROWS_WITH(ply("solid"), Contains("not a PLY file"));
}

TEST_CASE("D04 a Git LFS pointer in place of a mesh is named as such", "[mesh][hard][D04]") {
    const std::string pointer =
        "version https://git-lfs.github.com/spec/v1\noid sha256:1\nsize 9\n";
    CHECK_THROWS_WITH(obj(pointer), Contains("Git LFS pointer"));
    CHECK_THROWS_WITH(ply(pointer), Contains("Git LFS pointer"));
}

TEST_CASE("D12 a binary PLY file truncated anywhere is an error", "[mesh][hard][D12]") {
    const std::string whole = read_text_file(product_mesh("teapot.ply"), 1 << 20);
    REQUIRE(can_be_read(read_ply, whole));
    for (std::size_t length = 0; length < whole.size(); length += length < 400 ? 1 : 97)
        CHECK_FALSE(can_be_read(read_ply, whole.substr(0, length)));
    CHECK_FALSE(can_be_read(read_ply, whole.substr(0, whole.size() - 1)));
}

TEST_CASE("D12 a mesh file with one changed byte is a mesh or an error", "[mesh][hard][D12]") {
    const std::string points = "0 0 0 1 0 0 0 1 0 ";
    std::string as_ply = ascii_ply(3, 1, points + "3 0 1 2\n");
    std::string as_obj = three_points + "vt 0 1\nvn 0 0 1\nf 1/1/1 2/1/1 -1//-1\n";
    int meshes = 0;
    for (const int change : {1, 4, 16, 64, 128, 255}) {
        for (char& c : as_ply) {
            c = static_cast<char>(c ^ change);
            meshes += can_be_read(read_ply, as_ply) ? 1 : 0;
            c = static_cast<char>(c ^ change);
        }
        for (char& c : as_obj) {
            c = static_cast<char>(c ^ change);
            meshes += can_be_read(read_obj, as_obj) ? 1 : 0;
            c = static_cast<char>(c ^ change);
        }
    }
    CHECK(meshes > 0);
}
