#include "texunit/paraboloid.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "texunit/exact_math.hpp"
#include "texunit/random.hpp"

using namespace twofold;

namespace {

Vec3 random_direction(std::uint64_t index) {
    const double z = 2.0 * random_unit(11, 2 * index) - 1.0;
    const double phi = 2.0 * exact::pi * random_unit(11, 2 * index + 1);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * exact::cos(phi), radius * exact::sin(phi), z};
}

double distance(Vec3 a, Vec3 b) { return length(a - b); }

/// Whether the four texels of a bilinear look-up, clamped to the edge, all have alpha 1.
bool footprint_is_opaque(const ParaboloidPoint& point, int size, double guard) {
    const int x = static_cast<int>(std::floor(point.st.x * size - 0.5));
    const int y = static_cast<int>(std::floor(point.st.y * size - 0.5));
    const auto clamped = [&](int i) { return i < 0 ? 0 : i >= size ? size - 1 : i; };
    for (const int i : {x, x + 1}) {
        for (const int j : {y, y + 1}) {
            if (!texel_is_opaque(clamped(i), clamped(j), size, guard)) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("a direction comes back from its place on the paraboloid maps") {
    for (const double guard : {1.0, 0.875, 31.0 / 32.0}) {
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const Vec3 d = random_direction(i);
            const ParaboloidPoint point = to_paraboloid(d, guard);
            REQUIRE(point.face == (d.z >= 0.0 ? Face::front : Face::back));
            REQUIRE(distance(from_paraboloid(point, guard), d) < 1e-14);
        }
    }
}

TEST_CASE(
    "beyond the rim a face runs on into the other hemisphere, where the other face holds it") {
    for (const Face face : {Face::front, Face::back}) {
        const ParaboloidPoint corner{face, {0.5 + 0.875 * 0.5 * 1.25, 0.5}};
        const Vec3 d = from_paraboloid(corner, 0.875);
        CHECK(face_of(d) != face);
        CHECK(length(d) == Approx(1.0).epsilon(1e-15));
        // Radius 1.25 on one face is 1 / 1.25 on the other.
        CHECK(to_paraboloid(d, 0.875).st.x == Approx(0.5 + 0.875 * 0.5 / 1.25).epsilon(1e-14));
    }
}

TEST_CASE("T01 on the great circle z = 0 plus and minus zero choose the front face alone",
          "[hard][T01]") {
    for (int i = 0; i < 4096; ++i) {
        const double phi = 2.0 * exact::pi * i / 4096.0;
        const Vec3 d{exact::cos(phi), exact::sin(phi), i % 2 == 0 ? 0.0 : -0.0};
        REQUIRE(face_of(d) == Face::front);
        REQUIRE(face_of({d.x, d.y, -0x1p-1074}) == Face::back);
        REQUIRE(footprint_is_opaque(to_paraboloid(d, 0.875), 32, 0.875));
    }
}

TEST_CASE("T01 every direction of a face finds alpha 1 in its whole bilinear footprint",
          "[hard][T01]") {
    for (const int size : {4, 16, 33, 64}) {
        for (const double guard : {0.5, 0.875, (size - 1.0) / size, 1.0}) {
            for (std::uint64_t i = 0; i < 2000; ++i) {
                Vec3 d = random_direction(i);
                REQUIRE(footprint_is_opaque(to_paraboloid(d, guard), size, guard));
                // The rim itself, where footprints reach farthest.
                d = normalized(Vec3{d.x, d.y, 0.0});
                REQUIRE(footprint_is_opaque(to_paraboloid(d, guard), size, guard));
            }
        }
    }
}

TEST_CASE("alpha is 0 in the corners of a guarded map") {
    CHECK_FALSE(texel_is_opaque(0, 0, 32, 0.875));
    CHECK_FALSE(texel_is_opaque(31, 31, 32, 0.875));
    CHECK(texel_is_opaque(16, 1, 32, 0.875));
    CHECK_FALSE(texel_is_opaque(16, 0, 32, 0.875));
}

TEST_CASE(
    "the texture matrix gives the same point as the formula, and q = 1 + |z| on its own face") {
    for (const double guard : {1.0, 0.875}) {
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const Vec3 d = random_direction(i);
            const ParaboloidPoint point = to_paraboloid(d, guard);
            const Vec4 strq = paraboloid_matrix(point.face, guard) * Vec4(d, 1.0);
            REQUIRE(strq.w == Approx(1.0 + std::fabs(d.z)).epsilon(1e-15));
            REQUIRE(strq.z == 0.0);
            REQUIRE(strq.x / strq.w == Approx(point.st.x).epsilon(1e-14));
            REQUIRE(strq.y / strq.w == Approx(point.st.y).epsilon(1e-14));
        }
    }
}

TEST_CASE("the other face's matrix sees the far pole at q = 0") {
    const Vec4 strq = paraboloid_matrix(Face::back, 0.875) * Vec4(0.0, 0.0, 1.0, 1.0);
    CHECK(strq.w == 0.0);
    const Vec4 shortened = paraboloid_matrix(Face::back, 0.875) * Vec4(0.0, 0.0, 0.98, 1.0);
    CHECK(shortened.x / shortened.w == Approx(0.5));
}

TEST_CASE("texel directions have unit length and fall on their own texel") {
    const int size = 16;
    for (const Face face : {Face::front, Face::back}) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const Vec3 d = texel_direction({face, x, y}, size, 0.875);
                REQUIRE(length(d) == Approx(1.0).epsilon(1e-15));
                if (texel_radius(x, y, size, 0.875) > 1.0) continue;
                const ParaboloidPoint point = to_paraboloid(d, 0.875);
                REQUIRE(point.face == face);
                REQUIRE(point.st.x * size == Approx(x + 0.5).epsilon(1e-14));
                REQUIRE(point.st.y * size == Approx(y + 0.5).epsilon(1e-14));
            }
        }
    }
}

TEST_CASE("a guard of (R - 1) / R puts the rim on the outermost texel centres") {
    const ParaboloidPoint rim = to_paraboloid({1.0, 0.0, 0.0}, 63.0 / 64.0);
    CHECK(rim.st.x * 64.0 == Approx(63.5).epsilon(1e-15));
}

TEST_CASE("the texels of a face cover half the sphere") {
    const int size = 256;
    double solid_angle = 0.0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double radius = texel_radius(x, y, size, 1.0);
            const double edge = 2.0 / size;
            if (radius > 1.0) continue;
            const double density = 2.0 / (1.0 + radius * radius);
            solid_angle += density * density * edge * edge;
        }
    }
    CHECK(solid_angle == Approx(2.0 * exact::pi).epsilon(2e-3));
}
