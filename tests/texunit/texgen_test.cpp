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

TEST_CASE("T13a a shortened normal at a pole lands in the middle of the other face's map",
          "[hard][T13]") {
    const Mat4 back = paraboloid_matrix(Face::back, 1.0);
    const Vec4 at_pole = back * Vec4{0.0, 0.0, 0.98, 1.0};
    CHECK(at_pole.w == Approx(0.02));
    CHECK(at_pole.x / at_pole.w == Approx(0.5));
    CHECK(at_pole.y / at_pole.w == Approx(0.5));
    const Vec4 aside = back * Vec4{0.03, 0.0, 0.98, 1.0};
    CHECK(aside.x / aside.w == Approx(1.25));
}
