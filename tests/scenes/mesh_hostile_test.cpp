#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>

#include "tests/scenes/mesh_text.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

namespace {
using namespace twofold;
using namespace twofold::mesh_text;
using Catch::Contains;

/// True for a mesh, false for an Error of a bad file; anything else ends the test.
template <typename Read>
bool can_be_read(Read read, const std::string& text) {
    try {
        return !read(file_of(text)).indices.empty();
    } catch (const Error& error) {
        return error.code() != ExitCode::bad_file;
    }
}

}  // namespace

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
