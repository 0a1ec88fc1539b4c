#include "texunit/cube_map.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <tuple>

#include "texunit/presets.hpp"
#include "texunit/random.hpp"
#include "texunit/sample.hpp"

namespace {
using namespace twofold;

using AllModels = std::tuple<Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom>;

ProjectiveCoordinates<double> direction(double x, double y, double z) { return {x, y, z, 1.0}; }

/// s, t on the direction's face as table 3.20 of OpenGL 1.3 writes them.
struct FacePoint {
    CubeFace face;
    double s, t;
};

FacePoint by_table(double x, double y, double z) {
    const double ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
    const auto at = [](CubeFace face, double sc, double tc, double ma) {
        return FacePoint{face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
    };
    if (ax >= ay && ax >= az)
        return x >= 0 ? at(CubeFace::positive_x, -z, -y, ax) : at(CubeFace::negative_x, z, -y, ax);
    if (ay >= az)
        return y >= 0 ? at(CubeFace::positive_y, x, z, ay) : at(CubeFace::negative_y, x, -z, ay);
    return z >= 0 ? at(CubeFace::positive_z, x, -y, az) : at(CubeFace::negative_z, -x, -y, az);
}

/// Faces of n x n texels: red is the face's number times 40 plus 1, green and blue are column and
/// row.
Texture cube_texture(int n) {
    const auto image = [n](int face) {
        std::vector<Rgba8> texels;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                texels.push_back({static_cast<std::uint8_t>(40 * face + 1),
                                  static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), 255});
        return texels;
    };
    Texture texture{n, n, image(0)};
    for (int face = 1; face < 6; ++face) texture.cube_faces.push_back({n, n, image(face)});
    return texture;
}

TextureUnitState cube_unit(Filter filter) {
    TextureUnitState unit;
    unit.target = TextureTarget::cube_map;
    unit.min_filter = unit.mag_filter = filter;
    return unit;
}
}  // namespace

TEST_CASE("the six axes meet the middles of the six faces", "[cube_map]") {
    struct Row {
        double x, y, z;
        CubeFace face;
    };
    for (const auto [x, y, z, face] :
         {Row{1, 0, 0, CubeFace::positive_x}, Row{-1, 0, 0, CubeFace::negative_x},
          Row{0, 1, 0, CubeFace::positive_y}, Row{0, -1, 0, CubeFace::negative_y},
          Row{0, 0, 1, CubeFace::positive_z}, Row{0, 0, -1, CubeFace::negative_z}})
        for (const double length : {1e-30, 1.0, 7.5, 1e30}) {
            const auto d = direction(x * length, y * length, z * length);
            CHECK(cube_face(d) == face);
            const auto at = on_face(face, d);
            CHECK(at.s / at.q == 0.5);
            CHECK(at.t / at.q == 0.5);
        }
}

TEST_CASE("on the twelve edges and eight corners x comes before y before z", "[cube_map]") {
    for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            for (const double z : {-1.0, 0.0, 1.0}) {
                const auto d = direction(x, y, z);
                const CubeFace expected =
                    x != 0   ? (x > 0 ? CubeFace::positive_x : CubeFace::negative_x)
                    : y != 0 ? (y > 0 ? CubeFace::positive_y : CubeFace::negative_y)
                    : z < 0  ? CubeFace::negative_z
                    : z > 0  ? CubeFace::positive_z
                             : CubeFace::positive_x;
                CHECK(cube_face(d) == expected);
            }
}

TEST_CASE("faces and coordinates are those of table 3.20", "[cube_map]") {
    for (std::uint64_t i = 0; i < 30000; i += 3) {
        const double x = 2 * random_unit(9, i) - 1, y = 2 * random_unit(9, i + 1) - 1,
                     z = 2 * random_unit(9, i + 2) - 1;
        const FacePoint expected = by_table(x, y, z);
        const auto d = direction(x, y, z);
        REQUIRE(cube_face(d) == expected.face);
        const auto at = on_face(expected.face, d);
        REQUIRE(std::fabs(at.s / at.q - expected.s) < 1e-15);
        REQUIRE(std::fabs(at.t / at.q - expected.t) < 1e-15);
    }
}

TEMPLATE_LIST_TEST_CASE("the directions of all texel centres read their texels", "[cube_map]",
                        AllModels) {
    using M = TestType;
    using Real = typename M::Real;
    const M m{};
    constexpr int n = 8;
    const auto texture = upload(m, cube_texture(n));
    const Color<typename M::Channel> border{};
    int read = 0, wrong = 0;
    for (int a = 0; a < 3; ++a)
        for (const int sign : {-1, 1})
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    std::array<Real, 3> d{};
                    d[static_cast<std::size_t>(a)] = static_cast<Real>(sign * n);
                    d[static_cast<std::size_t>((a + 1) % 3)] = static_cast<Real>(2 * i + 1 - n);
                    d[static_cast<std::size_t>((a + 2) % 3)] = static_cast<Real>(2 * j + 1 - n);
                    const auto expected =
                        by_table(static_cast<double>(d[0]), static_cast<double>(d[1]),
                                 static_cast<double>(d[2]));
                    const auto texel = m.texel(
                        Rgba8{static_cast<std::uint8_t>(40 * static_cast<int>(expected.face) + 1),
                              static_cast<std::uint8_t>(expected.s * n),
                              static_cast<std::uint8_t>(expected.t * n), 255});
                    const ProjectiveCoordinates<Real> at{d[0], d[1], d[2], Real{-3}};
                    for (const Filter filter : {Filter::nearest, Filter::linear}) {
                        ++read;
                        wrong +=
                            sample(m, texture, cube_unit(filter), {at, at, at}, border) != texel;
                    }
                }
    CHECK(read == 6 * n * n * 2);
    CHECK(wrong == 0);
}

TEMPLATE_LIST_TEST_CASE("lookups stay on their face up to its edges and corners", "[cube_map]",
                        AllModels) {
    using M = TestType;
    using Real = typename M::Real;
    const M m{};
    const auto texture = upload(m, cube_texture(4));
    const auto border = m.texel(Rgba8{255, 255, 255, 0});
    for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                const ProjectiveCoordinates<Real> at{Real{1}, static_cast<Real>(y),
                                                     static_cast<Real>(z), Real{1}};
                const auto texel = m.texel(Rgba8{1, static_cast<std::uint8_t>(z < 0 ? 3 : 0),
                                                 static_cast<std::uint8_t>(y < 0 ? 3 : 0), 255});
                CHECK(sample(m, texture, cube_unit(filter), {at, at, at}, border) == texel);
            }
}

TEST_CASE("a fragment's neighbours are laid on its own face", "[cube_map]") {
    const Ideal64 m{};
    const auto texture = upload(m, cube_texture(4));
    TextureUnitState unit = cube_unit(Filter::nearest);
    unit.mag_filter = Filter::linear;
    const auto here = direction(1.0, 0.0, 0.99), over_edge = direction(1.0, 0.0, 1.01);
    const auto far_away = direction(-1.0, 1.0, 0.0);
    const auto at = on_face(CubeFace::positive_x, over_edge);
    CHECK(at.s / at.q == Approx(-0.005));
    const Color<double> border{};
    const auto near = sample(m, texture, unit, {here, over_edge, here}, border);
    CHECK(near[2] == Approx(1.5 / 255));  // linear between rows 1 and 2
    const auto wide = sample(m, texture, unit, {here, far_away, here}, border);
    CHECK(wide[2] == Approx(2.0 / 255));
}

TEST_CASE("directions that are none read a texel all the same", "[cube_map]") {
    const Nv17 m{};
    const auto texture = upload(m, cube_texture(4));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {0.0, 1.0, -infinity, nan})
        for (const double y : {0.0, 1.0, infinity, nan})
            for (const double z : {0.0, -1.0, infinity, nan}) {
                const auto at = direction(x, y, z);
                const auto texel =
                    sample(m, texture, cube_unit(Filter::linear), {at, at, at}, {7, 7, 7, 7});
                CHECK(texel[3] == 255);
            }
}
