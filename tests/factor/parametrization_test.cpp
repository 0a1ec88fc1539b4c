#include "factor/parametrization.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "factor/directions.hpp"
#include "factor/factor_map.hpp"
#include "tests/texunit/sample_builders.hpp"

using namespace twofold;

TEST_CASE("the reflected view has unit length and the normal's cosine of the view") {
    for (const SurfaceView& at : surface_views(1000, 3)) {
        const Vec3 r = pi_2(at);
        REQUIRE(length(r) == Approx(1.0).epsilon(1e-14));
        REQUIRE(dot(at.n, r) == Approx(dot(at.n, at.v)).margin(1e-14));
        // OpenGL's REFLECTION_MAP: u - 2 n (n.u) with u = -v.
        const Vec3 u = -at.v;
        const Vec3 gl = u - 2.0 * dot(at.n, u) * at.n;
        REQUIRE(length(r - gl) < 1e-15);
    }
}

TEST_CASE("texels are numbered face, row, column, and back") {
    const MapShape shape{6, 0.875};
    CHECK(shape.texels() == 72);
    CHECK(texel_index({0, 0, 0}, shape) == 0);
    CHECK(texel_index({0, 5, 1}, shape) == 11);
    CHECK(texel_index({1, 0, 0}, shape) == 36);
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        REQUIRE(texel_index(texel_at(j, shape), shape) == j);
    }
}

TEST_CASE("the four weights of a footprint are not negative and sum to 1") {
    for (const double guard : {0.875, 1.0}) {
        for (const SurfaceView& at : surface_views(2000, 1)) {
            const TexelFootprint footprint = footprint_of(at.n, {16, guard});
            double sum = 0.0;
            for (const double weight : footprint.weight) {
                REQUIRE(weight >= 0.0);
                sum += weight;
            }
            REQUIRE(sum == Approx(1.0).epsilon(1e-15));
        }
    }
}

TEST_CASE("at a texel's centre the footprint is that texel") {
    const MapShape shape{8, 0.875};
    const std::uint32_t index = texel_index({1, 3, 5}, shape);
    const TexelFootprint footprint =
        footprint_of(texel_direction({Face::back, 3, 5}, shape.size, shape.guard), shape);
    double weight = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (footprint.index[k] == index) weight += footprint.weight[k];
    }
    CHECK(weight == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("without a guard the rim's footprints repeat the texels of the edge") {
    const TexelFootprint footprint = footprint_of({1.0, 0.0, 0.0}, {8, 1.0});
    CHECK(footprint.index == std::array<std::uint32_t, 4>{31, 31, 39, 39});
    CHECK(footprint.weight == std::array<double, 4>{0.25, 0.25, 0.25, 0.25});
}

TEST_CASE("filtering a map linear in s and t gives the linear function itself") {
    const MapShape shape{16, 0.875};
    std::vector<double> map(shape.texels());
    for (std::size_t j = 0; j < map.size(); ++j) {
        const MapTexel texel = texel_at(j, shape);
        map[j] = 2.0 * (texel.x + 0.5) / 16.0 - 3.0 * (texel.y + 0.5) / 16.0;
    }
    for (const SurfaceView& at : surface_views(1000, 5)) {
        const Vec2 st = to_paraboloid(at.n, shape.guard).st;
        REQUIRE(filtered(map, footprint_of(at.n, shape)) ==
                Approx(2.0 * st.x - 3.0 * st.y).margin(1e-14));
    }
}

TEST_CASE("a footprint weighs the texels that a texture unit samples, with both guards") {
    // Texel by texel: a texture that is 1 at one texel and 0 elsewhere shows that texel's weight.
    const Ideal64 m;
    for (const double guard : {0.875, 1.0}) {
        const MapShape shape{8, guard};
        for (const SurfaceView& at : surface_views(200, 11)) {
            const TexelFootprint footprint = footprint_of(at.n, shape);
            const Face face = face_of(at.n);
            const Vec4 st = paraboloid_matrix(face, guard) * Vec4(at.n, 1.0);
            std::array<double, 64> weight{};
            for (std::size_t k = 0; k < 4; ++k)
                weight[footprint.index[k] % 64] += footprint.weight[k];
            for (std::size_t k = 0; k < 4; ++k) {
                std::vector<Rgba32f> texels(64, Rgba32f{});
                const std::size_t texel = footprint.index[k] % 64;
                texels[texel] = {1.0F, 1.0F, 1.0F, 1.0F};
                const auto texture = upload(m, Texture{8, 8, texels});
                const auto here = coordinates<double>(st.x, st.y, 0.0, st.w);
                const auto sampled =
                    sample(m, texture, TextureUnitState{}, {here, here, here}, {})[0];
                REQUIRE(sampled == Approx(weight[texel]).margin(1e-14));
                REQUIRE(footprint.index[k] / 64 == (face == Face::front ? 0U : 1U));
            }
        }
    }
}

TEST_CASE("the texels of a cube map have the directions of their faces and are found again") {
    const MapShape shape{5, 0.875, MapForm::cube};
    REQUIRE(shape.texels() == 150);
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const MapTexel texel = texel_at(j, shape);
        REQUIRE(texel_index(texel, shape) == j);
        const Vec3 d = texel_direction(texel, shape);
        REQUIRE(length(d) == Approx(1.0).epsilon(1e-15));
        const TexelFootprint footprint = footprint_of(d, shape);
        double weight = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            if (footprint.index[k] == j) weight += footprint.weight[k];
        REQUIRE(weight == Approx(1.0).epsilon(1e-13));
    }
    // Table 3.20: on the face +x, s runs towards -z and t towards -y.
    CHECK(length(texel_direction({0, 4, 2}, shape) - normalized(Vec3(1.0, 0.0, -0.8))) < 1e-15);
    CHECK(length(texel_direction({0, 2, 4}, shape) - normalized(Vec3(1.0, -0.8, 0.0))) < 1e-15);
}

TEST_CASE("across the edges of a cube each texel is beside the one beside it") {
    const MapShape shape{7, 0.875, MapForm::cube};
    const std::array<std::pair<int, int>, 4> steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
    for (std::size_t j = 0; j < shape.texels(); ++j) {
        const MapTexel texel = texel_at(j, shape);
        for (const auto& [columns, rows] : steps) {
            const auto next = beside(texel, columns, rows, shape);
            REQUIRE(next);
            // No farther than two texels at the middle of a face.
            REQUIRE(length(texel_direction(*next, shape) - texel_direction(texel, shape)) <
                    4.0 / 7);
            bool back = false;
            for (const auto& [x, y] : steps)
                back = back || texel_index(*beside(*next, x, y, shape), shape) == j;
            REQUIRE(back);
        }
    }
    CHECK_FALSE(beside({0, 0, 3}, -1, 0, MapShape{7, 0.875}));
}

TEST_CASE("a cube map's footprint weighs the texels that a texture unit samples") {
    const Ideal64 m;
    const MapShape shape{6, 0.875, MapForm::cube};
    TextureUnitState unit;
    unit.target = TextureTarget::cube_map;
    for (const SurfaceView& at : surface_views(300, 11)) {
        const TexelFootprint footprint = footprint_of(at.n, shape);
        std::vector<double> weight(shape.texels(), 0.0);
        for (std::size_t k = 0; k < 4; ++k) weight[footprint.index[k]] += footprint.weight[k];
        for (std::size_t k = 0; k < 4; ++k) {
            NormalisedChannel one{std::vector<double>(shape.texels(), 0.0)};
            one.texel[footprint.index[k]] = 1.0;
            const Texture cube = make_factor_map({one, one, one}, shape, "t1").real.at(0);
            REQUIRE(cube.cube_faces.size() == 5);
            const auto here = coordinates<double>(at.n.x, at.n.y, at.n.z, 1.0);
            const auto sampled = sample(m, upload(m, cube), unit, {here, here, here}, {});
            REQUIRE(sampled[0] == Approx(weight[footprint.index[k]]).margin(1e-14));
            REQUIRE(sampled[3] == Approx(1.0));
        }
    }
}
