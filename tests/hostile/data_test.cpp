#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factor/measured_data.hpp"
#include "scenes/factor_set.hpp"
#include "scenes/mesh_file.hpp"
#include "tests/factor/measured_files.hpp"
#include "tests/refusal.hpp"

using namespace twofold;
using namespace twofold::cases;
using namespace std::string_literals;
using Catch::Contains;

namespace {

const std::vector<std::string> impossible_counts{
    "-1", "-2147483649", "9223372036854775808", "nan", "1e9", "", "0x10", "1,000"};

std::string ply_of(const std::string& vertices, const std::string& faces, const std::string& data) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + data;
}

std::string ply_refusal(const std::string& text) {
    return refusal(ExitCode::bad_file, [&] { parse_ply(text, "m.ply"); });
}

std::string obj_refusal(const std::string& text) {
    return refusal(ExitCode::bad_file, [&] { parse_obj(text, "m.obj"); });
}

}  // namespace

TEST_CASE("counts in a PLY header that no file can keep are refused by element", "[hostile]") {
    const std::string points = "0 0 0 1 0 0 0 1 0 3 0 1 2\n";
    REQUIRE(ply_refusal(ply_of("3", "1", points)) == "accepted");
    for (const std::string& count : impossible_counts) {
        CHECK(ply_refusal(ply_of(count, "1", points)) == "m.ply: element 'vertex' without a count");
        CHECK(ply_refusal(ply_of("3", count, points)) == "m.ply: element 'face' without a count");
    }
    for (const char* count : {"2147483648", "4294967299", "9223372036854775807"}) {
        CHECK_THAT(ply_refusal(ply_of(count, "1", points)), Contains("vertices, allowed are"));
        CHECK_THAT(ply_refusal(ply_of("3", count, points)), Contains("items of element 'face'"));
    }
    for (const char* list : {"4294967296 0 1 2", "-3 0 1 2", "1e300 0 1 2", "3.5 0 1 2"})
        CHECK_THAT(ply_refusal(ply_of("3", "1", "0 0 0 1 0 0 0 1 0 "s + list)),
                   Contains("m.ply: a list of ") && Contains(" values in element 'face'"));
    for (const char* index : {"2147483648", "-1", "4294967296", "1e18", "0.5"})
        CHECK_THAT(ply_refusal(ply_of("3", "1", "0 0 0 1 0 0 0 1 0 3 0 1 "s + index)),
                   Contains("m.ply: face 0: index "));
}

TEST_CASE("what a mesh file says reaches no terminal", "[hostile]") {
    const std::string steering = "\x1b[2J\x07\xff\xc2\x9b";
    for (const std::string& text :
         {"ply\n" + steering + "\nend_header\n", "ply\nformat " + steering + "\n",
          "ply\nelement " + steering + " -1\n", "ply\nelement a 1\nproperty " + steering + " x\n",
          "ply\nformat ascii 1.0\nelement " + steering + " 9\nproperty int x\nend_header\n",
          ply_of("1", "1", steering)}) {
        const std::string error = ply_refusal(text);
        CHECK(printable(error, error.size()) == error);
    }
    for (const char* line : {"v 0 0 ", "f 1 2 ", "f 1 2 3/", "vt "}) {
        const std::string error = obj_refusal("v 0 0 0\n"s + line + steering + "\n");
        CHECK_THAT(error, Contains("m.obj:2: "));
        CHECK(printable(error, error.size()) == error);
    }
}

TEST_CASE("indices of an OBJ file beyond every integer type are refused with their line",
          "[hostile]") {
    for (const char* index : {"0", "4", "-4", "2147483648", "-2147483649", "9223372036854775807",
                              "9223372036854775808", "nan", "1e1"})
        for (const char* corner : {"", "1/", "1//"})
            CHECK_THAT(obj_refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvn 0 0 1\nf 1 2 "s + corner +
                                   index + "\n"),
                       Contains("m.obj:6: "));
}

TEST_CASE("fields of a tensor file that lie over each other are refused", "[hostile]") {
    const auto fields = rgl_fields([](std::size_t, std::size_t) { return 1.0F; });
    const Bytes good = tensor_file(fields);
    REQUIRE(refusal(ExitCode::bad_file, [&] { parse_rgl(good, "r.bsdf"); }) == "accepted");
    // A field's name is followed by its number of dimensions, type, offset and shape.
    const auto offset_of = [](Bytes& bytes, const std::string& name) {
        return std::search(bytes.begin(), bytes.end(), name.begin(), name.end()) +
               static_cast<std::ptrdiff_t>(name.size()) + 3;
    };
    // sigma and ndf of 140 values each where the colours' 144 are: more than the file has in all.
    Bytes bytes = good;
    for (const char* name : {"sigma", "ndf"}) {
        std::copy_n(offset_of(bytes, "rgb"), 8, offset_of(bytes, name));
        offset_of(bytes, name)[16] = 70;
    }
    CHECK_THAT(refusal(ExitCode::bad_file, [&] { parse_rgl(bytes, "r.bsdf"); }),
               Contains("lie over each other"));
    for (const std::uint64_t edge :
         {std::uint64_t{1} << 31, std::uint64_t{1} << 63, ~std::uint64_t{}}) {
        Bytes huge = good;
        const auto shape = offset_of(huge, "sigma") + 8;
        for (int i = 0; i < 8; ++i) shape[i] = static_cast<unsigned char>(edge >> (8 * i));
        CHECK_THAT(refusal(ExitCode::bad_file, [&] { parse_rgl(huge, "r.bsdf"); }),
                   Contains("r.bsdf: field 'sigma' does not fit: [" + std::to_string(edge)));
    }
}

TEST_CASE("a Cornell file of more measurements than could be searched is refused", "[hostile]") {
    std::string text = "2\n500 600\n";
    for (int i = 0; i < 100'001; ++i) text += "0 0 0 0 1 1\n";
    CHECK(refusal(ExitCode::bad_file, [&] { parse_cornell(text, "c.brdf"); }) ==
          "c.brdf: line 100003: more than 100000 measurements");
    for (const std::string& count : {"2147483648"s, "-1"s, "1025"s, "nan"s, "1e308"s})
        CHECK_THAT(refusal(ExitCode::bad_file, [&] { parse_cornell(count, "c.brdf"); }),
                   Contains("c.brdf: line 1: number of wavelengths: '" + count));
}

TEST_CASE("a MERL file of every special value is read and its marks are counted", "[hostile]") {
    using Limits = std::numeric_limits<double>;
    const std::array<double, 8> values{Limits::quiet_NaN(),
                                       Limits::infinity(),
                                       -Limits::infinity(),
                                       -0.0,
                                       Limits::denorm_min(),
                                       Limits::max(),
                                       -1.0,
                                       1.0};
    const Bytes file =
        merl_file([&](int, int, int, int k) { return values[static_cast<std::size_t>(k % 8)]; });
    const MeasuredData data = parse_merl(file, "m.binary");
    for (const ValueCounts& counts : data.counts) {
        CHECK(counts.values == merl_plane);
        CHECK(counts.not_finite > merl_plane / 3);
        CHECK(counts.negative > merl_plane / 9);
    }
    for (const Vec3 wi : {Vec3(0.0, 0.0, 1.0), Vec3(0.6, 0.0, 0.8), Vec3(0.0, 1.0, 0.0)})
        for (int c = 0; c < 3; ++c) CHECK_FALSE(data.value(wi, Vec3(0.8, 0.0, 0.6))[c] < 0.0);
}

TEST_CASE("a set of factor textures with an impossible line is refused by it", "[hostile]") {
    const auto set = [](const std::string& text) {
        return refusal(ExitCode::bad_file, [&] { parse_factor_set(text, "f.txt"); });
    };
    CHECK(set("a\n0\n1 1 1\n0\n") == "accepted");
    for (const char* kind : {"3", "-1", "2147483648", "x", "", "0x0"})
        CHECK(set("a\n"s + kind + "\n1 1 1\n") == "f.txt: line 2: the kind is none of 0, 1 and 2");
    for (const char* alpha : {"1 1", "-1 1 1", "1 nan 1", "1 1 inf", "1e999 1 1", "2e6 1 1", ""})
        CHECK(set("a\n0\n"s + alpha) == "f.txt: line 3: three constants of 0 to 1e6 are wanted");
}
