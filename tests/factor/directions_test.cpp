#include "factor/directions.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

using namespace twofold;

namespace {

bool same_pair(const SurfaceView& a, const SurfaceView& b) { return a.n == b.n && a.v == b.v; }

Vec3 mean_normal(const std::vector<SurfaceView>& views) {
    Vec3 sum(0.0);
    for (const SurfaceView& view : views) {
        sum += view.n;
    }
    return sum / static_cast<double>(views.size());
}

double mean_view_cosine(const std::vector<SurfaceView>& views) {
    double sum = 0.0;
    for (const SurfaceView& view : views) {
        sum += dot(view.n, view.v);
    }
    return sum / static_cast<double>(views.size());
}

}  // namespace

TEST_CASE("S01 Every pair is a unit normal and a unit view above the horizon",
          "[directions][S01]") {
    for (const SurfaceView& view : surface_views(50000, 0)) {
        REQUIRE(std::fabs(length(view.n) - 1.0) < 1e-15);
        REQUIRE(std::fabs(length(view.v) - 1.0) < 1e-15);
        REQUIRE(dot(view.n, view.v) >= least_view_cosine * (1.0 - 1e-9));
    }
}

TEST_CASE("S01 Views at the horizon are counted, those above it are not", "[directions][S01]") {
    const Vec3 n(0.0, 0.0, 1.0);
    std::vector<SurfaceView> views;
    for (const double cosine : {0.0, 1e-8, 1e-4, 2e-4, 0.5, 1.0}) {
        views.push_back({n, Vec3(std::sqrt(1.0 - cosine * cosine), 0.0, cosine)});
    }
    CHECK(count_at_horizon(views) == 3);
    CHECK(count_at_horizon(surface_views(200000, 0)) == 0);
}

TEST_CASE("Normals are uniform on the sphere and views cosine-weighted about them",
          "[directions]") {
    const auto views = surface_views(20000, 3);
    CHECK(length(mean_normal(views)) < 1e-3);
    // Integral of cos^2 / pi over the hemisphere.
    CHECK(std::fabs(mean_view_cosine(views) - 2.0 / 3.0) < 1e-3);
    Vec3 squares(0.0);
    for (const SurfaceView& view : views) {
        squares += view.n * view.n / static_cast<double>(views.size());
    }
    CHECK(length(squares - Vec3(1.0 / 3.0)) < 1e-3);
}

TEST_CASE("The same call gives the same pairs, and a longer set begins with the shorter",
          "[directions]") {
    const auto shorter = surface_views(100, 7), longer = surface_views(1000, 7);
    for (std::size_t i = 0; i < shorter.size(); ++i) {
        REQUIRE(same_pair(shorter[i], longer[i]));
    }
    const auto rest = surface_views(900, 7, 100);
    for (std::size_t i = 0; i < rest.size(); ++i) REQUIRE(same_pair(rest[i], longer[100 + i]));
    CHECK(surface_views(0, 7).empty());
}

TEST_CASE("Sets of different sequences share no pair", "[directions]") {
    std::set<std::tuple<double, double, double>> seen;
    for (std::uint64_t sequence = 0; sequence < 4; ++sequence) {
        for (const SurfaceView& view : surface_views(5000, sequence)) {
            seen.insert({view.n.x, view.n.y, view.n.z});
        }
    }
    CHECK(seen.size() == 20000);
}

TEST_CASE("The frame about a normal is orthonormal, also at both poles", "[directions]") {
    for (const Vec3 n : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 1, 0), normalized(Vec3(1, -2, -3)),
                         normalized(Vec3(1e-9, 0, -1))}) {
        const Vec3 a = about(n, 1.0, 0.0, 0.0), b = about(n, 0.0, 1.0, 0.0);
        CHECK(std::fabs(dot(a, b)) < 1e-15);
        CHECK(std::fabs(dot(a, n)) < 1e-15);
        CHECK(std::fabs(length(a) - 1.0) < 1e-15);
        CHECK(length(cross(a, b) - n) < 1e-15);
    }
}
