#include "raster/transform.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "raster/project.hpp"
#include "tests/raster/builders.hpp"
#include "texunit/presets.hpp"

namespace {
using namespace twofold;
using namespace twofold::test;

constexpr int edge = 1024;

/// The snapped window place of a vertex at (x, y) pixels.
template <NumericModel M>
WindowVertex<M> window_vertex(double x, double y, double z = 0.5) {
    PassState state;
    state.projection = pixel_projection(edge, edge);
    const Viewport viewport = viewport_of(edge, edge, M{}.snap());
    using A = typename M::Vertex;
    const Mesh mesh = triangles({{x, y, z}});
    const auto constants = vertex_constants<A>(state, viewport);
    return project(M{}, transform_vertex<A>(constants, state, mesh, 0), viewport, true);
}

std::int64_t cut_toward_zero(double x) {
    return x < 0 ? -static_cast<std::int64_t>(-x) : static_cast<std::int64_t>(x);
}
}  // namespace

TEMPLATE_TEST_CASE("R16 half a snap step rounds up by the bias, then cuts toward zero",
                   "[hard][R16]", Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    const double steps = static_cast<double>(1 << M{}.snap().fraction_bits);
    for (const double whole : {0.0, 100.0, 1000.0})
        for (int tie = 0; tie < 16; ++tie)
            for (const double sign : {1.0, -1.0}) {
                const double x = sign * (whole + (tie + 0.5) / steps);
                CAPTURE(x);
                CHECK(window_vertex<M>(x, 7.0).x == cut_toward_zero(x * steps + 0.5));
                CHECK(window_vertex<M>(7.0, x).y == cut_toward_zero(x * steps + 0.5));
            }
    // The case's own words: a tie goes up on the right of the origin and toward it on the left.
    CHECK(window_vertex<M>(3.0 + 0.5 / steps, 0.0).x == static_cast<std::int64_t>(3 * steps) + 1);
    CHECK(window_vertex<M>(-3.0 - 0.5 / steps, 0.0).x == static_cast<std::int64_t>(-3 * steps));
}

TEMPLATE_TEST_CASE("places on the snap grid stay where they are", "[transform]", Ideal64, Float32,
                   Gl13, Nv17) {
    using M = TestType;
    const std::int64_t steps = 1 << M{}.snap().fraction_bits;
    for (int k = 0; k <= 16 * 40; ++k) {
        const auto v = window_vertex<M>(k / 16.0, 1000.0 - k / 16.0);
        CHECK(v.x == k * steps / 16);
        CHECK(v.y == (16000 - k) * steps / 16);
    }
}

TEMPLATE_TEST_CASE("window depth runs from 0 to 1 and 1/w is 1 without perspective", "[transform]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    for (const double z : {0.0, 0.25, 0.5, 1.0}) {
        const auto v = window_vertex<M>(5.0, 5.0, z);
        CHECK(v.z == z);
        CHECK(v.inverse_w == 1);
    }
}

TEMPLATE_TEST_CASE("texture coordinates are carried over w", "[transform]", Ideal64, Float32, Gl13,
                   Nv17) {
    using M = TestType;
    using A = typename M::Vertex;
    PassState state;
    state.projection = frustum(1.0, 10.0);
    state.units[1] = TextureUnitState{};
    state.units[1]->matrix[0][0] = 2.0;
    Mesh mesh = triangles({{0.0, 0.0, -4.0}});
    mesh.texcoords[0] = {{0.5, 0.25, 9.0, 1.0}};
    const Viewport viewport = viewport_of(64, 64, M{}.snap());
    const auto constants = vertex_constants<A>(state, viewport);
    const auto v = project(M{}, transform_vertex<A>(constants, state, mesh, 0), viewport, true);
    using Real = typename M::Real;
    CHECK(v.inverse_w == Real{1} / 4);
    CHECK(v.coords[1] == std::array<Real, 4>{Real{1} / 4, Real{1} / 16, Real{9} / 4, Real{1} / 4});
    CHECK(v.x == 32 << M{}.snap().fraction_bits);
}

TEST_CASE("R18 a singular modelview transforms no normals and is named", "[hard][R18]") {
    Mat4 rank2{1.0}, rank0{0.0}, skewed{1.0};
    rank2[2] = rank2[0] + rank2[1];
    skewed[1][0] = 5.0;
    CHECK_THROWS_WITH(normal_matrix(rank2), Catch::Contains("modelview"));
    CHECK_THROWS_WITH(normal_matrix(rank0), Catch::Contains("modelview"));
    CHECK_FALSE(invertible(Mat3{std::numeric_limits<double>::quiet_NaN()}));
    CHECK_FALSE(invertible(Mat3{std::numeric_limits<double>::infinity()}));
    CHECK(invertible(Mat3{1e-40}));
    CHECK(invertible(Mat3{1e40}));
    CHECK_NOTHROW(normal_matrix(skewed));
}

TEST_CASE("the normal matrix keeps a normal perpendicular to its surface", "[transform]") {
    Mat4 m{1.0};
    m[0] = {2.0, 0.0, 0.5, 0.0};
    m[1] = {0.25, 3.0, 0.0, 0.0};
    m[2] = {0.0, -1.0, 0.5, 0.0};
    const Mat3 normal = normal_matrix(m), linear{m};
    const Vec3 n{1.0, 2.0, 3.0}, along{3.0, 0.0, -1.0}, across{2.0, -1.0, 0.0};
    CHECK(dot(normal * n, linear * along) == Approx(0.0).margin(1e-14));
    CHECK(dot(normal * n, linear * across) == Approx(0.0).margin(1e-14));
}

TEMPLATE_TEST_CASE("eye normals are scaled by the modelview unless NORMALIZE is on", "[transform]",
                   IeeeArithmetic<double>, IeeeArithmetic<float>, Nv1xArithmetic) {
    using A = TestType;
    PassState state;
    state.modelview = Mat4{0.5};
    state.modelview[3][3] = 1.0;
    state.units[0] = TextureUnitState{};
    state.units[0]->texgen = texgen_all(TexGen::normal_map);
    Mesh mesh = triangles({{0.0, 0.0, 0.0}});
    mesh.normals = {{0.0, 0.6, 0.8}};
    const auto z_of = [&] {
        const auto constants = vertex_constants<A>(state, viewport_of(4, 4, Nv17{}.snap()));
        return transform_vertex<A>(constants, state, mesh, 0).coords[0].z;
    };
    CHECK(z_of() == Approx(1.6).epsilon(1e-6));
    state.normalize = true;
    CHECK(z_of() == Approx(0.8).epsilon(1e-6));
}

TEST_CASE("only generated coordinates need normals", "[transform]") {
    PassState state;
    CHECK_FALSE(needs_normals(state));
    state.units[0] = TextureUnitState{};
    CHECK_FALSE(needs_normals(state));
    state.units[1] = TextureUnitState{};
    state.units[1]->texgen = texgen_all(TexGen::reflection_map);
    CHECK(needs_normals(state));
}
