#include "texunit/texgen.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "texunit/linear.hpp"
#include "texunit/nv1x_arithmetic.hpp"
#include "texunit/paraboloid.hpp"
#include "texunit/random.hpp"
#include "texunit/vertex_arithmetic.hpp"

namespace {
using namespace twofold;

/// A unit vector of the whole sphere: von Neumann's rejection, then a division.
Vec3 random_direction(std::uint64_t seed) {
    for (std::uint64_t i = 0;; i += 3) {
        const Vec3 v{2 * random_unit(seed, i) - 1, 2 * random_unit(seed, i + 1) - 1,
                     2 * random_unit(seed, i + 2) - 1};
        const double square = dot(v, v);
        if (square > 0.01 && square < 1.0) return normalized(v);
    }
}

template <class A>
Vector3<A> words(Vec3 v) {
    return {A::from_double(v.x), A::from_double(v.y), A::from_double(v.z)};
}

template <class A>
Vec3 reals(const Vector3<A>& v) {
    return {A::to_double(v[0]), A::to_double(v[1]), A::to_double(v[2])};
}

double largest_component(Vec3 v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// r = u - 2 n (n.u) as OpenGL 1.3, 2.10.4, writes it.
Vec3 reflected(Vec3 position, Vec3 n) {
    const Vec3 u = normalized(position);
    return u - 2.0 * dot(n, u) * n;
}

/// The worst component of reflection_map against the formula over random positions and normals.
template <class A>
double worst_reflection(double w) {
    double worst = 0.0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const Vec3 n = random_direction(3 * i);
        const Vec3 p = random_direction(3 * i + 1) * (0.5 + 20.0 * random_unit(3 * i + 2, 0));
        const auto eye = words<A>(p * w);
        const auto r = reflection_map<A>({eye[0], eye[1], eye[2], A::from_double(w)}, words<A>(n));
        worst = std::max(worst, largest_component(reals<A>(r) - reflected(p, n)));
    }
    return worst;
}
}  // namespace

TEST_CASE("the reflection vector is OpenGL's to the preset's precision", "[texgen]") {
    for (const double w : {1.0, 3.0}) {
        CHECK(worst_reflection<IeeeArithmetic<double>>(w) < 1e-14);
        CHECK(worst_reflection<IeeeArithmetic<float>>(w) < 1e-6);
        CHECK(worst_reflection<Nv1xArithmetic>(w) < 3e-6);
    }
}

TEST_CASE("a surface seen head-on reflects back to the eye", "[texgen]") {
    using A = IeeeArithmetic<double>;
    CHECK(reflection_map<A>({0, 0, -5, 1}, {0, 0, 1}) == Vector3<A>{0, 0, 1});
    CHECK(reflection_map<A>({0, 0, -5, 1}, {1, 0, 0}) == Vector3<A>{0, 0, -1});
    const auto glancing = reflection_map<A>({3, 0, -4, 1}, {0, 0, 1});
    CHECK(glancing[0] == Approx(0.6));
    CHECK(glancing[2] == Approx(0.8));
}

TEST_CASE("a vertex at the eye reflects to numbers that sampling can take", "[texgen]") {
    using A = Nv1xArithmetic;
    const auto r = reals<A>(reflection_map<A>({0, 0, 0, A::from_double(1.0)}, words<A>({0, 0, 1})));
    CHECK(r == Vec3{0.0});
}

namespace {
/// The worst of s, t and r of SPHERE_MAP against OpenGL's formula, m = 2 |r + (0, 0, 1)|, over
/// reflections that are not close to (0, 0, -1), where the formula has no value.
template <class A>
double worst_sphere_point() {
    double worst = 0.0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const Vec3 n = random_direction(3 * i);
        const Vec3 p = random_direction(3 * i + 1) * (0.5 + 20.0 * random_unit(3 * i + 2, 0));
        const Vec3 r = reflected(p, n);
        if (r.z < -0.9) continue;
        const double m = 2.0 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
        const auto eye = words<A>(p);
        const auto point = sphere_map<A>(
            reflection_terms<A>({eye[0], eye[1], eye[2], A::from_double(1.0)}, words<A>(n)));
        worst = std::max(
            worst, largest_component(reals<A>(point) - Vec3{r.x / m + 0.5, r.y / m + 0.5, r.z}));
    }
    return worst;
}

template <class A>
std::array<typename A::Word, 4> words(Vec4 v) {
    return {A::from_double(v.x), A::from_double(v.y), A::from_double(v.z), A::from_double(v.w)};
}

template <class A>
Vec4 reals(const std::array<typename A::Word, 4>& v) {
    return {A::to_double(v[0]), A::to_double(v[1]), A::to_double(v[2]), A::to_double(v[3])};
}

constexpr Vec4 own{0.25, 0.5, 0.75, 2.0}, object{1, 2, 3, 1}, eye{0, 0, -4, 1};
constexpr Vec3 facing{0, 0, 1};

/// What a vertex of the values above gets.
template <class A>
Vec4 generated(const TexGenState& state) {
    return reals<A>(
        generate<A>(state, words<A>(own), words<A>(object), words<A>(eye), words<A>(facing)));
}
}  // namespace

TEST_CASE("the sphere map point is OpenGL's to the preset's precision, and r is r_z", "[texgen]") {
    CHECK(worst_sphere_point<IeeeArithmetic<double>>() < 1e-14);
    CHECK(worst_sphere_point<IeeeArithmetic<float>>() < 2e-6);
    CHECK(worst_sphere_point<Nv1xArithmetic>() < 6e-6);
}

TEST_CASE("a surface seen head-on is in the middle of the sphere map, a glancing one at its rim",
          "[texgen]") {
    using A = IeeeArithmetic<double>;
    const auto at = [](Vec4 position, Vec3 normal) {
        return reals<A>(sphere_map<A>(reflection_terms<A>(words<A>(position), words<A>(normal))));
    };
    CHECK(at({0, 0, -5, 1}, {0, 0, 1}) == Vec3{0.5, 0.5, 1.0});
    const Vec3 sideways = at({0, 0, -5, 1}, normalized(Vec3{1, 0, 1}));
    CHECK(sideways.x == Approx(0.5 + 0.5 / std::sqrt(2.0)));
    CHECK(sideways.y == 0.5);
    const Vec3 rim = at({0, 0, -5, 1}, normalized(Vec3{1, 0, 1e-6}));
    CHECK(rim.x == Approx(1.0));
    CHECK(rim.z == Approx(-1.0));
}

TEST_CASE("the reflection straight away from the eye has a place in the chip's sphere map",
          "[texgen]") {
    using A = Nv1xArithmetic;
    const auto terms = reflection_terms<A>(words<A>(Vec4{0, 0, -5, 1}), words<A>({1, 0, 0}));
    const Vec3 point = reals<A>(sphere_map<A>(terms));
    CHECK(point.z == Approx(-1.0));
    CHECK((point.x >= 0.0 && point.x <= 1.0));
    CHECK(point.y == 0.5);
}

TEMPLATE_TEST_CASE("every coordinate is generated by its own mode", "[texgen]",
                   IeeeArithmetic<double>, IeeeArithmetic<float>, Nv1xArithmetic) {
    using A = TestType;
    TexGenState state;
    CHECK(generated<A>(state) == own);
    state.object_plane = {Vec4{1, 1, 1, 1}, Vec4{0, 2, 0, 0}, Vec4{0, 0, 0, 8}, Vec4{0, 0, 1, -1}};
    state.eye_plane = {Vec4{0, 0, 1, 0}, Vec4{0, 0, 0, 1}, Vec4{0, 0, 2, 3}, Vec4{0, 0, -1, 0}};
    state.mode.fill(TexGen::object_linear);
    CHECK(generated<A>(state) == Vec4{7, 4, 8, 2});
    state.mode.fill(TexGen::eye_linear);
    CHECK(generated<A>(state) == Vec4{-4, 1, -5, 4});
    state.mode = {TexGen::none, TexGen::eye_linear, TexGen::object_linear, TexGen::none};
    CHECK(generated<A>(state) == Vec4{0.25, 1, 8, 2});
    CHECK(generated<A>(texgen_all(TexGen::normal_map)) == Vec4{0, 0, 1, 2});
}

TEMPLATE_TEST_CASE("reflection modes leave q alone and give r = z of the reflected vector",
                   "[texgen]", IeeeArithmetic<double>, IeeeArithmetic<float>, Nv1xArithmetic) {
    using A = TestType;
    const auto near = [](Vec4 a, Vec4 b) {
        return largest_component(Vec3{a} - Vec3{b}) < 4e-6 && a.w == b.w;
    };
    CHECK(near(generated<A>(texgen_all(TexGen::reflection_map)), Vec4{0, 0, 1, 2}));
    CHECK(near(generated<A>(texgen_all(TexGen::sphere_map)), Vec4{0.5, 0.5, 0.75, 2}));
    TexGenState state;
    state.mode.fill(TexGen::sphere_map);
    CHECK(near(generated<A>(state), Vec4{0.5, 0.5, 1, 2}));
    state.mode = {TexGen::sphere_map, TexGen::reflection_map, TexGen::normal_map, TexGen::none};
    CHECK(near(generated<A>(state), Vec4{0.5, 0, 1, 2}));
}

TEST_CASE("generate gives the bits of reflection_map", "[texgen]") {
    using A = Nv1xArithmetic;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        const auto n = words<A>(random_direction(2 * i));
        const auto position = words<A>(Vec4{random_direction(2 * i + 1) * 3.0, 1.0});
        const auto r = reflection_map<A>(position, n);
        const auto all =
            generate<A>(texgen_all(TexGen::reflection_map), words<A>(own), {}, position, n);
        REQUIRE(all == std::array{r[0], r[1], r[2], A::from_double(own.w)});
    }
}

TEST_CASE("unit makes length 1 to the preset's precision", "[texgen]") {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Vec3 v = random_direction(i) * (0.01 + 100.0 * random_unit(i, 99));
        using D = IeeeArithmetic<double>;
        using F = IeeeArithmetic<float>;
        CHECK(std::fabs(length(reals<D>(unit<D>(words<D>(v)))) - 1.0) < 1e-15);
        CHECK(std::fabs(length(reals<F>(unit<F>(words<F>(v)))) - 1.0) < 3e-7);
        using N = Nv1xArithmetic;
        CHECK(std::fabs(length(reals<N>(unit<N>(words<N>(v)))) - 1.0) < 1.1e-6);
    }
}

TEST_CASE("dot products run left to right in IEEE formats and at once on the chip", "[texgen]") {
    using F = IeeeArithmetic<float>;
    CHECK(dot3<F>({1.0f, 0x1p-24f, 0x1p-24f}, {1.0f, 1.0f, 1.0f}) == 1.0f);
    using N = Nv1xArithmetic;
    const auto one = N::from_double(1.0), tiny = N::from_double(0x1p-24);
    CHECK(dot3<N>({one, tiny, tiny}, {one, one, one}) == N::from_double(1.0 + 0x1p-23));
    CHECK(dot4<N>({one, tiny, tiny, one}, {one, one, one, one}) == N::from_double(2.0));
}

TEST_CASE("the paraboloid texture matrix of a direction's face gives its paraboloid point",
          "[texgen]") {
    for (const double guard : {1.0, 0.875})
        for (std::uint64_t i = 0; i < 10000; ++i) {
            const Vec3 n = random_direction(i);
            const ParaboloidPoint p = to_paraboloid(n, guard);
            const Vec4 at = paraboloid_matrix(p.face, guard) * Vec4{n, 1.0};
            const double error =
                std::max(std::fabs(at.x / at.w - p.st.x), std::fabs(at.y / at.w - p.st.y));
            if (!(error < 1e-15)) CHECK(error < 1e-15);
        }
}

TEST_CASE("T13 T13a a shortened normal at a pole lands in the middle of the other face's map",
          "[hard][T13]") {
    const Mat4 back = paraboloid_matrix(Face::back, 1.0);
    const Vec4 at_pole = back * Vec4{0.0, 0.0, 0.98, 1.0};
    CHECK(at_pole.w == Approx(0.02));
    CHECK(at_pole.x / at_pole.w == Approx(0.5));
    CHECK(at_pole.y / at_pole.w == Approx(0.5));
    const Vec4 aside = back * Vec4{0.03, 0.0, 0.98, 1.0};
    CHECK(aside.x / aside.w == Approx(1.25));
}
