#pragma once
#include <bit>
#include <cstdint>
#include <limits>

#include "texunit/ieee_guard.hpp"

/// Elementary functions made of + - * /, sqrt, fabs and bit moves only, so that they give the same
/// bits on every platform; the C library's do not (docs/exactness.md, section 4). "ulp" is a unit
/// in the last place of the correct result; every bound below was found against MPFR and is
/// asserted by tests/texunit/exact_math_test.cpp. `exp` and `log` are inline and free of branches,
/// so that loops over them become vectors; a vector gives the same bits as a scalar.
namespace twofold::exact {

/// The double next to the ratio of a circle's circumference to its diameter.
inline constexpr double pi = 0x1.921fb54442d18p+1;

namespace detail {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Adding this to |x| < 2^51 rounds x to an integer, ties to even, and leaves that integer in the
/// low bits.
inline constexpr double round_shift = 0x1.8p+52;

/// ln 2 in two parts (W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980).
/// The high part has 32 bits: its product with any binary exponent is exact.
inline constexpr double ln2_high = 0x1.62e42fee00000p-1;
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;

/// value * 2^n, with n in the low bits of `n_bits` (two's complement).
struct Scaled {
    double value;
    std::uint64_t n_bits;
};

/// (exp(r) - 1 - r) / r^2 for |r| <= ln 2 / 2: Taylor's series, cut where terms
/// fall below 0.05 ulp.
inline double exp_series(double r) {
    double sum = 1.0 / 6227020800.0;
    sum = sum * r + 1.0 / 479001600.0;
    sum = sum * r + 1.0 / 39916800.0;
    sum = sum * r + 1.0 / 3628800.0;
    sum = sum * r + 1.0 / 362880.0;
    sum = sum * r + 1.0 / 40320.0;
    sum = sum * r + 1.0 / 5040.0;
    sum = sum * r + 1.0 / 720.0;
    sum = sum * r + 1.0 / 120.0;
    sum = sum * r + 1.0 / 24.0;
    sum = sum * r + 1.0 / 6.0;
    return sum * r + 0.5;
}

/// exp(x + tail) for |x| <= 750 and |tail| below 1e-12, as a value near 1 and a power of two. What
/// rounding takes from the reduced argument r and from 1 + r is carried along in `lost` and added
/// last.
inline Scaled exp_scaled(double x, double tail) {
    constexpr double log2_e = 0x1.71547652b82fep+0;
    const double shifted = x * log2_e + round_shift;
    const double n = shifted - round_shift;
    const double head = x - n * ln2_high;
    const double rest = n * ln2_low - tail;
    const double r = head - rest;
    const double one_plus_r = 1.0 + r;
    const double lost = ((1.0 - one_plus_r) + r) + ((head - r) - rest);
    const double value = one_plus_r + (lost + r * r * exp_series(r));
    return {value, std::bit_cast<std::uint64_t>(shifted)};
}

/// The double whose biased exponent is the low 11 bits of `biased`: 2^(biased - 1023).
inline double power_of_two(std::uint64_t biased) { return std::bit_cast<double>(biased << 52); }

/// `s` as a double for -1076 <= n <= 1024. Two factors of about 2^(n/2), because 2^n itself may not
/// be a normal number; only the second can round, so a denormal result is rounded once more and no
/// oftener.
inline double unscaled(Scaled s) {
    const std::uint64_t biased = (s.n_bits + 2048) & 0xfff;
    const std::uint64_t half = biased >> 1;
    return s.value * power_of_two(half - 1) * power_of_two(biased - half - 1);
}

/// x = mantissa * 2^exponent with mantissa in [sqrt(1/2), sqrt(2)).
struct Split {
    double mantissa;
    double exponent;
};

/// Splits a finite x > 0, denormals included; for other x the result means nothing. The biased
/// exponent becomes a double by putting it under the bits of 2^52, for there is no vector
/// conversion before AVX-512.
inline Split split(double x) {
    constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t one = 0x3ff0000000000000;
    const bool denormal = x < 0x1p-1022;
    const double scaled = denormal ? x * 0x1p+54 : x;
    const double bias = denormal ? 0x1p+52 + 1077.0 : 0x1p+52 + 1023.0;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(scaled) + (one - sqrt_half);
    const double exponent = std::bit_cast<double>(0x4330000000000000 | (bits >> 52)) - bias;
    return {std::bit_cast<double>((bits & 0x000fffffffffffff) + sqrt_half), exponent};
}

/// (2 atanh(s) / s - 2) of z = s^2 for the s of `log`, |s| <= 0.172: Taylor's series.
inline double log_series(double z) {
    double sum = 2.0 / 21.0;
    sum = sum * z + 2.0 / 19.0;
    sum = sum * z + 2.0 / 17.0;
    sum = sum * z + 2.0 / 15.0;
    sum = sum * z + 2.0 / 13.0;
    sum = sum * z + 2.0 / 11.0;
    sum = sum * z + 2.0 / 9.0;
    sum = sum * z + 2.0 / 7.0;
    sum = sum * z + 2.0 / 5.0;
    sum = sum * z + 2.0 / 3.0;
    return sum * z;
}

/// log of a finite x > 0. With f = m - 1 and s = f / (2 + f), log(1 + f) = f - f^2/2 + s (f^2/2 +
/// series). f^2/2 is taken from the upper half of f, where it is exact, and what that leaves out is
/// added last.
/// @source the identity is that of FreeBSD's e_log.c (Sun Microsystems, 1993)
inline double log_positive(double x) {
    const auto [m, k] = split(x);
    const double f = m - 1.0;
    const double s = f / (m + 1.0);
    const double f_high =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(f) & 0xfffffffff8000000);
    const double square_high = 0.5 * f_high * f_high;
    const double square_low = 0.5 * (f + f_high) * (f - f_high);
    const double near = f - square_high;
    const double near_lost = (f - near) - square_high;
    const double far = k * ln2_high;
    const double sum = far + near;
    // |far| > |near| unless far is zero, and then nothing is lost.
    const double sum_lost = (far - sum) + near;
    const double series = s * ((square_high + square_low) + log_series(s * s));
    return sum + (sum_lost + (near_lost - square_low + (series + k * ln2_low)));
}

}  // namespace detail

/// exp(x) for -708 <= x <= 709, where result and scale are normal numbers; a NaN stays one, other
/// arguments give a meaningless value. At most 0.7 ulp.
inline double exp_normal(double x) {
    const detail::Scaled s = detail::exp_scaled(x, 0.0);
    return s.value * detail::power_of_two(s.n_bits + 1023);
}

/// exp(x) for every double: 0 below -745.2, infinity above 709.8, NaN for NaN. At most 0.7 ulp
/// where the result is normal, 1 ulp where it is denormal; rounded to float it is correct for every
/// float argument.
inline double exp(double x) {
    const double above = x < -746.0 ? -746.0 : x;
    const double inside = above > 710.0 ? 710.0 : above;
    return detail::unscaled(detail::exp_scaled(inside, 0.0));
}

/// Natural logarithm: -infinity at 0, NaN below it. At most 0.7 ulp.
inline double log(double x) {
    const double positive = x < detail::infinity ? detail::log_positive(x) : x;
    const double not_zero = x < 0.0 ? detail::not_a_number : positive;
    return x == 0.0 ? -detail::infinity : not_zero;
}

/// x^y for x >= 0: 1 for y = 0 or x = 1 whatever the other; 0^y is 0 for y > 0 and infinity for
/// y < 0. NaN for x < 0, whole y included. At most 0.75 ulp where the result is normal.
double pow(double x, double y);

/// Sine of x in radians, |x| <= 2^20; NaN beyond, where the reduction would no longer be exact. At
/// most 0.8 ulp. sin(-0) is -0.
double sin(double x);

/// Cosine of x in radians, |x| <= 2^20; NaN beyond. At most 0.8 ulp.
double cos(double x);

/// Arc cosine in [0, pi]; exactly 0 at 1 and exactly `pi` at -1, NaN outside [-1, 1]. At most
/// 0.9 ulp.
double acos(double x);

}  // namespace twofold::exact
