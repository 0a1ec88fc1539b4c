#include "factor/vector_arithmetic.hpp"

#include <bit>
#include <cmath>

#include "factor/simd_clones.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

namespace {

constexpr double smallest_normal = 0x1p-1022;

/// 2^e for -1022 <= e <= 1023, built from its bits.
double power_of_two(int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

}  // namespace

[[gnu::flatten]] TWOFOLD_SIMD_CLONES double dot(const Vector& a, const Vector& b) {
    return ordered_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

[[gnu::flatten]] TWOFOLD_SIMD_CLONES double total(const Vector& a) {
    return ordered_sum(a.size(), [&](std::size_t i) { return a[i]; });
}

double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

TWOFOLD_SIMD_CLONES
Vector plus_scaled(Vector a, double f, const Vector& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += f * b[i];
    return a;
}

TWOFOLD_SIMD_CLONES
Vector combined(double f, const Vector& a, double g, Vector b) {
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = f * a[i] + g * b[i];
    return b;
}

Vector minus(const Vector& a, const Vector& b) {
    Vector difference(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
    return difference;
}

Vector scaled(double f, Vector a) {
    for (double& x : a) x *= f;
    return a;
}

Vector divided(Vector a, double f) {
    for (double& x : a) x /= f;
    return a;
}

double largest_magnitude(const Vector& a) {
    double largest = 0.0;
    for (const double x : a) largest = largest < std::fabs(x) ? std::fabs(x) : largest;
    return largest;
}

bool all_finite(const Vector& a) {
    for (const double x : a) {
        if (!std::isfinite(x)) return false;
    }
    return true;
}

int binary_exponent(double x) {
    const double magnitude = std::fabs(x);
    if (magnitude == 0.0) return 0;
    if (magnitude < smallest_normal) return binary_exponent(magnitude * 0x1p54) - 54;
    return static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52) - 1023;
}

double times_power_of_two(double x, int e) {
    // A step of 2^1000 at a time stays among the powers that binary64 holds; towards zero only the
    // last step can leave the normal numbers unless the result is zero anyway.
    while (e > 1000) {
        x *= 0x1p1000;
        e -= 1000;
    }
    while (e < -1000) {
        const int step = e < -2000 ? -1000 : e + 1000;
        x *= power_of_two(step);
        e -= step;
    }
    return x * power_of_two(e);
}

Vector times_power_of_two(const Vector& a, int e) {
    Vector product(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) product[i] = times_power_of_two(a[i], e);
    return product;
}

}  // namespace twofold
