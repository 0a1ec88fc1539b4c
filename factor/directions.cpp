#include "factor/directions.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

/// 2^64 phi^-j for j = 1..4, where phi^5 = phi + 1 (the golden ratio's generalisation to four
/// dimensions); the last is rounded up to be odd like the others, so that no point recurs.
constexpr std::array<std::uint64_t, 4> steps = {0xdb4f0b9175ae2165, 0xbbe0563303a4615f,
                                                0xa0f2ec75a1fe1575, 0x89e182857d9ed689};

/// The middle of the 2^-52 wide interval that the top 52 bits name: exact, and never 0 or 1.
double unit_interval(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

std::array<double, 4> recurrence_point(std::uint64_t index) {
    std::array<double, 4> u{};
    for (std::size_t j = 0; j < u.size(); ++j) {
        u[j] = unit_interval((index + 1) * steps[j]);
    }
    return u;
}

Vec3 uniform_direction(double u, double turn) {
    const double z = 1.0 - 2.0 * u;
    const double rho = std::sqrt(1.0 - z * z);
    const double phi = 2.0 * exact::pi * turn;
    return normalized(Vec3(rho * exact::cos(phi), rho * exact::sin(phi), z));
}

/// Malley's method: uniform on the disc, lifted to the hemisphere.
Vec3 cosine_weighted(Vec3 n, double u, double turn) {
    const double drawn = std::sqrt(1.0 - u);
    const double cosine = drawn < least_view_cosine ? least_view_cosine : drawn;
    const double rho = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * exact::pi * turn;
    return normalized(about(n, rho * exact::cos(phi), rho * exact::sin(phi), cosine));
}

}  // namespace

Vec3 about(Vec3 normal, double x, double y, double along) {
    const double sign = normal.z < 0.0 ? -1.0 : 1.0;
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    const Vec3 first(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    const Vec3 second(b, sign + normal.y * normal.y * a, -normal.y);
    return x * first + y * second + along * normal;
}

std::vector<SurfaceView> surface_views(int count, std::uint64_t sequence, int first) {
    std::vector<SurfaceView> views;
    views.reserve(static_cast<std::size_t>(count));
    const std::uint64_t start = (sequence << 32) + static_cast<std::uint64_t>(first);
    for (int i = 0; i < count; ++i) {
        const auto u = recurrence_point(start + static_cast<std::uint64_t>(i));
        const Vec3 n = uniform_direction(u[0], u[1]);
        views.push_back({n, cosine_weighted(n, u[2], u[3])});
    }
    return views;
}

int count_at_horizon(std::span<const SurfaceView> views) {
    int count = 0;
    for (const SurfaceView& view : views) {
        count += dot(view.n, view.v) <= least_view_cosine * (1.0 + 1e-9) ? 1 : 0;
    }
    return count;
}

}  // namespace twofold
