#include "texunit/byte_arithmetic.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace {
using namespace twofold;

/// True when n is the integer nearest to x / 255; a tie cannot occur, because 255 is odd.
bool is_nearest_255th(int n, int x) { return 2 * std::abs(255 * n - x) < 255; }

/// On how many of the 65,536 pairs of bytes a product rule differs from mul_rn.
template <class Rule>
int pairs_unlike_mul_rn(Rule rule) {
    int count = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) count += rule(a, b) != mul_rn(a, b);
    return count;
}
}  // namespace

TEST_CASE("C01 a product of bytes is a b / 255 to nearest for all 65,536 pairs", "[hard][C01]") {
    int wrong = 0, unlike_the_quotient = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            wrong += !is_nearest_255th(mul_rn(a, b), a * b);
            unlike_the_quotient += mul_rn(a, b) != (2 * a * b + 255) / 510;
        }
    CHECK(wrong == 0);
    CHECK(unlike_the_quotient == 0);
    CHECK(mul_rn(255, 255) == 255);
}

TEST_CASE("C01 the three wrong products differ on as many pairs as is known", "[hard][C01]") {
    CHECK(pairs_unlike_mul_rn([](int a, int b) { return a * b >> 8; }) == 47056);
    CHECK(pairs_unlike_mul_rn([](int a, int b) { return (a * b + 255) >> 8; }) == 18760);
    CHECK(pairs_unlike_mul_rn([](int a, int b) { return a * (b + (b >> 7)) >> 8; }) == 32064);
    CHECK(pairs_unlike_mul_rn([](int a, int b) { return a * (b + 1) >> 8; }) == 18760);
}

TEST_CASE("a sum of two products is rounded once and stops at 255", "[byte]") {
    int wrong = 0;
    for (int a = 0; a < 256; a += 5)
        for (int b = 0; b < 256; b += 3)
            for (int c = 0; c < 256; c += 5)
                for (int d = 0; d < 256; d += 5) {
                    const int x = a * b + c * d, sum = sum_rn(a, b, c, d);
                    wrong += sum > 255 || !(is_nearest_255th(sum, x) || (sum == 255 && x > 65025));
                }
    CHECK(wrong == 0);
    CHECK(sum_rn(255, 255, 255, 255) == 255);
    CHECK(sum_rn(1, 127, 1, 1) == 1);  // 128 / 255: separate roundings would give 0
}

TEST_CASE("the texture filter's interpolation is (p (256 - w) + q w) / 256 with halves up",
          "[byte]") {
    int wrong = 0, outside = 0;
    for (int p = 0; p < 256; ++p)
        for (int q = 0; q < 256; ++q)
            for (int w = 0; w < 256; ++w) {
                const int exact = 256 * p + (q - p) * w;  // in units of 1/256
                const int twice = 2 * (256 * flerp(p, q, w) - exact);
                wrong += !(twice > -256 && twice <= 256);
                outside += flerp(p, q, w) < (p < q ? p : q) || flerp(p, q, w) > (p < q ? q : p);
            }
    CHECK(wrong == 0);
    CHECK(outside == 0);
    CHECK(flerp(0, 1, 128) == 1);
    CHECK(flerp(17, 200, 0) == 17);
}

TEST_CASE("Q04 a real becomes a byte with halves up at all 255 ties", "[hard][Q04]") {
    for (int k = 0; k < 255; ++k) {
        const double tie = (k + 0.5) / 255.0;
        CHECK(rn8(tie) == k + 1);
        CHECK(rn8(tie - 1e-14) == k);
        CHECK(rn8(tie + 1e-14) == k + 1);
    }
}

TEST_CASE("a real outside 0..1 becomes the nearer end and NaN becomes 0", "[byte]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(rn8(-1e300) == 0);
    CHECK(rn8(-0.0) == 0);
    CHECK(rn8(-infinity) == 0);
    CHECK(rn8(1.0) == 255);
    CHECK(rn8(std::nextafter(1.0, 0.0)) == 255);
    CHECK(rn8(1e300) == 255);
    CHECK(rn8(infinity) == 255);
    CHECK(rn8(std::numeric_limits<double>::quiet_NaN()) == 0);
    for (int k = 0; k < 256; ++k) CHECK(rn8(k / 255.0) == k);
}

TEST_CASE("a signed quotient by 255 is the nearest, and differences end at 0", "[byte]") {
    for (int x = -3 * 65025; x <= 3 * 65025; ++x)
        if (!is_nearest_255th(rounded_255th(x), x)) FAIL_CHECK(x);
    CHECK(difference_rn(255, 255, 255, 1) == 254);
    CHECK(difference_rn(0, 255, 1, 255) == 0);
}

TEST_CASE("cutting to 255 steps loses what is below a step", "[byte]") {
    for (int k = 0; k < 255; ++k) CHECK(floor8((k + 0.9) / 255.0) == k);
    CHECK(floor8(1.0) == 255);
    CHECK(floor8(1e300) == 255);
    CHECK(floor8(-1.0) == 0);
    CHECK(floor8(std::numeric_limits<double>::quiet_NaN()) == 0);
}
