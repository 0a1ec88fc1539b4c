#include "texunit/exact_math.hpp"

#include <cmath>

namespace twofold::exact {
namespace {

/// An unevaluated sum hi + lo with |lo| at most half a unit in the last place of hi: about 106
/// bits.
struct Pair {
    double hi;
    double lo;
};

/// a + b exactly, for |a| >= |b| or a = 0.
/// @source T. J. Dekker, A floating-point technique for extending the available precision, 1971
Pair fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly.
/// @source D. E. Knuth, The Art of Computer Programming, volume 2, section 4.2.2
Pair two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a as two halves of 26 bits, for |a| < 2^996 (Dekker, as above).
Pair halves(double a) {
    const double c = 0x1.0000002p+27 * a;
    const double hi = c - (c - a);
    return {hi, a - hi};
}

/// a * b exactly (Dekker, as above): a fused multiply-add would do it in one step, but not
/// everywhere.
Pair two_product(double a, double b) {
    const double product = a * b;
    const Pair p = halves(a);
    const Pair q = halves(b);
    return {product, ((p.hi * q.hi - product) + p.hi * q.lo + p.lo * q.hi) + p.lo * q.lo};
}

/// a * b to about 2^-104.
Pair multiply(Pair a, Pair b) {
    const Pair product = two_product(a.hi, b.hi);
    return fast_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// a + b to about 2^-104, for |a| >= |b|.
Pair add(Pair a, Pair b) {
    const Pair sum = fast_two_sum(a.hi, b.hi);
    return fast_two_sum(sum.hi, sum.lo + (a.lo + b.lo));
}

/// 1/7 + z/9 + z^2/11 ...: the part of atanh's series for which a double is enough.
double atanh_tail(double z) {
    double sum = 1.0 / 25.0;
    sum = sum * z + 1.0 / 23.0;
    sum = sum * z + 1.0 / 21.0;
    sum = sum * z + 1.0 / 19.0;
    sum = sum * z + 1.0 / 17.0;
    sum = sum * z + 1.0 / 15.0;
    sum = sum * z + 1.0 / 13.0;
    sum = sum * z + 1.0 / 11.0;
    sum = sum * z + 1.0 / 9.0;
    sum = sum * z + 1.0 / 7.0;
    return sum;
}

/// s + s^3/3 + s^5/5 ... for |s| <= 0.172, to about 2^-70. Each factor s^2 takes five bits off what
/// the next term must be good for, so only the first three are pairs.
Pair atanh(Pair s) {
    constexpr Pair third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    constexpr Pair fifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
    const Pair z = multiply(s, s);
    const Pair from_fifth = add(fifth, {z.hi * atanh_tail(z.hi), 0.0});
    const Pair from_third = add(third, multiply(z, from_fifth));
    return add(s, multiply(s, multiply(z, from_third)));
}

/// log of a finite x > 0 to about 2^-70: 2 atanh(f / (2 + f)) + k ln 2.
Pair log_pair(double x) {
    const auto [m, k] = detail::split(x);
    const double f = m - 1.0;
    const Pair divisor = two_sum(1.0, m);
    const double quotient = f / divisor.hi;
    const Pair back = two_product(quotient, divisor.hi);
    const double rest = ((f - back.hi) - back.lo) - quotient * divisor.lo;
    const Pair half_log = atanh({quotient, rest / divisor.hi});
    const Pair sum = two_sum(k * detail::ln2_high, 2.0 * half_log.hi);
    return fast_two_sum(sum.hi, sum.lo + (2.0 * half_log.lo + k * detail::ln2_low));
}

/// x = quadrant * pi/2 + hi + lo with |hi| <= pi/4 (a little more by rounding).
struct Reduced {
    Pair angle;
    std::uint64_t quadrant;
};

/// pi/2 in three parts, of 33 bits each but the last: for |x| <= 2^20 the first two products are
/// exact, and no double of that size comes near enough to a multiple of pi/2 to need a fourth part.
Reduced reduce(double x) {
    constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
    constexpr double first = 0x1.921fb54400000p+0;
    constexpr double second = 0x1.0b4611a600000p-34;
    constexpr double third = 0x1.3198a2e037073p-69;
    const double shifted = x * two_over_pi + detail::round_shift;
    const double n = shifted - detail::round_shift;
    const Pair head = two_sum(x - n * first, -(n * second));
    return {two_sum(head.hi, head.lo - n * third), std::bit_cast<std::uint64_t>(shifted) & 3};
}

/// sin(hi + lo) for |hi| <= pi/4 by Taylor's series to hi^17; lo enters by the derivative, 1 -
/// hi^2/2.
double sin_kernel(Pair angle) {
    const double z = angle.hi * angle.hi;
    double sum = 1.0 / 355687428096000.0;
    sum = sum * z - 1.0 / 1307674368000.0;
    sum = sum * z + 1.0 / 6227020800.0;
    sum = sum * z - 1.0 / 39916800.0;
    sum = sum * z + 1.0 / 362880.0;
    sum = sum * z - 1.0 / 5040.0;
    sum = sum * z + 1.0 / 120.0;
    sum = sum * z - 1.0 / 6.0;
    return angle.hi + (angle.hi * z * sum + angle.lo * (1.0 - 0.5 * z));
}

/// cos(hi + lo) for |hi| <= pi/4 by Taylor's series to hi^16; what 1 - hi^2/2 loses is added last.
double cos_kernel(Pair angle) {
    const double z = angle.hi * angle.hi;
    double sum = 1.0 / 20922789888000.0;
    sum = sum * z - 1.0 / 87178291200.0;
    sum = sum * z + 1.0 / 479001600.0;
    sum = sum * z - 1.0 / 3628800.0;
    sum = sum * z + 1.0 / 40320.0;
    sum = sum * z - 1.0 / 720.0;
    sum = sum * z + 1.0 / 24.0;
    const Pair start = fast_two_sum(1.0, -0.5 * z);
    return start.hi + (start.lo + (z * z * sum - angle.hi * angle.lo));
}

/// sin(x + quarter_turns * pi/2).
double sin_turned(double x, std::uint64_t quarter_turns) {
    if (!(std::fabs(x) <= 0x1p+20)) return detail::not_a_number;
    const Reduced reduced = reduce(x);
    const std::uint64_t quadrant = (reduced.quadrant + quarter_turns) & 3;
    const double value =
        (quadrant & 1) != 0 ? cos_kernel(reduced.angle) : sin_kernel(reduced.angle);
    return (quadrant & 2) != 0 ? -value : value;
}

/// (asin(x) / x - 1) of z = x^2 in [0, 1/4]: a polynomial through Chebyshev's nodes (mpmath's
/// chebyfit with 13 terms, 300 bits), within 0.04 * 2^-53 of the function.
double asin_series(double z) {
    double sum = 0x1.d72b2bc8155f8p-6;
    sum = sum * z - 0x1.e6aaa8a0a04ccp-7;
    sum = sum * z + 0x1.1d189408314eep-6;
    sum = sum * z + 0x1.65a9c4dfcf8b2p-8;
    sum = sum * z + 0x1.52420b04b37bep-7;
    sum = sum * z + 0x1.782651caa6547p-7;
    sum = sum * z + 0x1.c9cf07674736ap-7;
    sum = sum * z + 0x1.1c4d35cf95421p-6;
    sum = sum * z + 0x1.6e8bb1c8209a2p-6;
    sum = sum * z + 0x1.f1c71c1db0623p-6;
    sum = sum * z + 0x1.6db6db6e31f13p-5;
    sum = sum * z + 0x1.3333333332ecap-4;
    sum = sum * z + 0x1.5555555555556p-3;
    return sum * z;
}

/// acos(x) for 1/2 <= x < 1 is 2 asin(sqrt((1 - x) / 2)), and 1 - x is exact. The root is split so
/// that its upper half has an exact square, which tells what the root itself lost.
double acos_near_one(double x) {
    const double z = 0.5 * (1.0 - x);
    const double root = std::sqrt(z);
    const double head = halves(root).hi;
    const double rest = (z - head * head) / (root + head);
    return 2.0 * (head + (root * asin_series(z) + rest));
}

}  // namespace

double pow(double x, double y) {
    if (y == 0.0 || x == 1.0) return 1.0;
    if (!(x >= 0.0) || y != y) return detail::not_a_number;
    if (x == 0.0 || x == detail::infinity) {
        return (x == 0.0) == (y > 0.0) ? 0.0 : detail::infinity;
    }
    const Pair log_x = log_pair(x);
    const double rough = y * log_x.hi;
    // Far outside the range of doubles; y may then be too large for the exact product below.
    if (std::fabs(rough) > 800.0) return exp(rough);
    const Pair product = two_product(y, log_x.hi);
    const Pair exponent = fast_two_sum(product.hi, product.lo + y * log_x.lo);
    if (exponent.hi < -746.0 || exponent.hi > 710.0) return exp(exponent.hi);
    return detail::unscaled(detail::exp_scaled(exponent.hi, exponent.lo));
}

double sin(double x) {
    // x - x^3/6 rounds to x; the reduction would also lose the sign of -0.
    return std::fabs(x) < 0x1p-27 ? x : sin_turned(x, 0);
}

double cos(double x) { return sin_turned(x, 1); }

double acos(double x) {
    constexpr double half_pi_low = 0x1.1a62633145c07p-54;
    if (x == 1.0) return 0.0;
    if (!(std::fabs(x) <= 1.0)) return detail::not_a_number;
    if (x >= 0.5) return acos_near_one(x);
    if (x > -0.5) return 0.5 * pi - (x - (half_pi_low - x * asin_series(x * x)));
    const double z = 0.5 * (1.0 + x);
    const double root = std::sqrt(z);
    return pi - 2.0 * (root + (root * asin_series(z) - half_pi_low));
}

}  // namespace twofold::exact
