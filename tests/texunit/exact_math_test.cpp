#include "texunit/exact_math.hpp"

#include <mpfr.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/texunit/precise.hpp"
#include "texunit/random.hpp"

namespace {

namespace exact = twofold::exact;

using namespace twofold::precise;

constexpr std::uint64_t points = 100000;

double ulps(Function own, Oracle oracle, double x) {
    Precise correct(x);
    oracle(correct.get(), correct.get(), MPFR_RNDN);
    return correct.ulps_from(own(x));
}

/// The largest error in ulp over `points` arguments draw(i).
template <class Draw>
double worst(Function own, Oracle oracle, Draw draw) {
    double largest = 0.0;
    for (std::uint64_t i = 0; i < points; ++i) {
        largest = std::fmax(largest, ulps(own, oracle, draw(i)));
    }
    return largest;
}

auto uniform(double lo, double hi) {
    return [=](std::uint64_t i) { return lo + (hi - lo) * twofold::random_unit(17, i); };
}

double ulps_of_pow(double x, double y) {
    Precise correct(x);
    Precise exponent(y);
    mpfr_pow(correct.get(), correct.get(), exponent.get(), MPFR_RNDN);
    return correct.ulps_from(exact::pow(x, y));
}

template <class DrawX, class DrawY>
double worst_pow(DrawX draw_x, DrawY draw_y) {
    double largest = 0.0;
    for (std::uint64_t i = 0; i < points; ++i) {
        largest = std::fmax(largest, ulps_of_pow(draw_x(2 * i), draw_y(2 * i + 1)));
    }
    return largest;
}

/// 2^e times [1, 2) with e uniform between the two bounds.
auto log_uniform(int lo, int hi) {
    return [=](std::uint64_t i) {
        const auto range = static_cast<std::uint64_t>(hi - lo);
        const auto e = lo + static_cast<int>(twofold::random_u64(29, i) % range);
        return std::ldexp(1.0 + twofold::random_unit(17, i), e);
    };
}

/// Doubles within four steps of a multiple of pi/2 up to 2^20, where the argument reduction cancels
/// most.
double near_quarter_turn(std::uint64_t i) {
    double x = static_cast<double>(i % 667543) * (exact::pi / 2);
    for (std::uint64_t step = 0; step < i % 5; ++step)
        x = std::nextafter(x, i % 2 ? 0.0 : infinity);
    return x;
}

}  // namespace

TEST_CASE("exp is within 0.7 ulp of the true value", "[exact_math][long]") {
    CHECK(worst(exact::exp, mpfr_exp, uniform(-60, 20)) <= 0.7);
    CHECK(worst(exact::exp, mpfr_exp, uniform(-708, 709.78)) <= 0.7);
    CHECK(worst(exact::exp, mpfr_exp, uniform(-1, 1)) <= 0.7);
    CHECK(worst(exact::exp, mpfr_exp, log_uniform(-60, -1)) <= 0.7);
}

TEST_CASE("exp is within one unit where its result is denormal", "[exact_math]") {
    CHECK(worst(exact::exp, mpfr_exp, uniform(-745.2, -708)) <= 1.0);
}

TEST_CASE("exp has the right values at the ends of its range", "[exact_math]") {
    CHECK(exact::exp(0.0) == 1.0);
    CHECK(exact::exp(-0.0) == 1.0);
    CHECK(exact::exp(-745.2) == 0.0);
    CHECK(exact::exp(-745.1) == 0x1p-1074);
    CHECK(exact::exp(-infinity) == 0.0);
    CHECK(exact::exp(-1e300) == 0.0);
    CHECK(exact::exp(709.78) < infinity);
    CHECK(exact::exp(709.79) == infinity);
    CHECK(exact::exp(infinity) == infinity);
    CHECK(std::isnan(exact::exp(not_a_number)));
}

TEST_CASE("exp_normal and exp give the same bits where both hold", "[exact_math]") {
    const auto draw = uniform(-708, 709);
    bool same = exact::exp_normal(-708) == exact::exp(-708);
    for (std::uint64_t i = 0; i < points; ++i) {
        same = same && exact::exp_normal(draw(i)) == exact::exp(draw(i));
    }
    CHECK(same);
    CHECK(exact::exp_normal(709) == exact::exp(709));
}

TEST_CASE("exp and log in a loop give the bits of single calls", "[exact_math]") {
    std::vector<double> x(1001), exp_x(x.size()), log_x(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = uniform(-750, 720)(i);
    for (std::size_t i = 0; i < x.size(); ++i) exp_x[i] = exact::exp(x[i]);
    for (std::size_t i = 0; i < x.size(); ++i) log_x[i] = exact::log(exp_x[i]);
    bool same = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const volatile double argument = x[i];
        const volatile double power = exact::exp(argument);
        same = same && exp_x[i] == power && log_x[i] == exact::log(power);
    }
    CHECK(same);
}

TEST_CASE("log is within 0.7 ulp of the true value", "[exact_math][long]") {
    CHECK(worst(exact::log, mpfr_log, uniform(1e-9, 4)) <= 0.7);
    CHECK(worst(exact::log, mpfr_log, uniform(0.7, 1.42)) <= 0.7);
    CHECK(worst(exact::log, mpfr_log, log_uniform(-200, 200)) <= 0.7);
    CHECK(worst(exact::log, mpfr_log, log_uniform(-1074, 1024)) <= 0.7);
    CHECK(worst(exact::log, mpfr_log, [](std::uint64_t i) {
              return 1.0 + log_uniform(-52, -2)(i) * (i % 2 == 0 ? 1.0 : -1.0);
          }) <= 0.7);
}

TEST_CASE("log has the right values at the ends of its range", "[exact_math]") {
    CHECK(exact::log(1.0) == 0.0);
    CHECK(exact::log(0.0) == -infinity);
    CHECK(exact::log(-0.0) == -infinity);
    CHECK(exact::log(infinity) == infinity);
    CHECK(std::isnan(exact::log(-1.0)));
    CHECK(std::isnan(exact::log(-infinity)));
    CHECK(std::isnan(exact::log(not_a_number)));
    CHECK(ulps(exact::log, mpfr_log, 0x1p-1074) <= 0.7);
    CHECK(ulps(exact::log, mpfr_log, std::numeric_limits<double>::max()) <= 0.7);
}

TEST_CASE("pow is within 0.75 ulp of the true value", "[exact_math][long]") {
    CHECK(worst_pow(uniform(0.3, 1), uniform(0, 200)) <= 0.75);
    CHECK(worst_pow(uniform(0.999, 1), uniform(9e4, 1e5)) <= 0.75);
    CHECK(worst_pow(uniform(1e-6, 1e6), uniform(-20, 20)) <= 0.75);
    CHECK(worst_pow(log_uniform(-1000, 1000), uniform(-1, 1)) <= 0.75);
    CHECK(worst_pow(log_uniform(-10, 10), uniform(-64, 64)) <= 0.75);
}

TEST_CASE("pow knows zeros, ones, infinities and NaN", "[exact_math]") {
    const double x = GENERATE(0.0, 0.5, 1.0, 7.0, infinity, not_a_number, -2.0);
    CHECK(exact::pow(x, 0.0) == 1.0);
    CHECK(exact::pow(x, -0.0) == 1.0);
    CHECK(exact::pow(1.0, x) == 1.0);
    CHECK(exact::pow(0.0, 3.0) == 0.0);
    CHECK(exact::pow(0.0, -3.0) == infinity);
    CHECK(exact::pow(infinity, 0.1) == infinity);
    CHECK(exact::pow(infinity, -0.1) == 0.0);
    CHECK(exact::pow(2.0, infinity) == infinity);
    CHECK(exact::pow(0.5, infinity) == 0.0);
    CHECK(exact::pow(0.5, 1e308) == 0.0);
    CHECK(exact::pow(1.5, 1e308) == infinity);
    CHECK(exact::pow(2.0, 1024.0) == infinity);
    CHECK(exact::pow(2.0, -1074.0) == 0x1p-1074);
    CHECK(exact::pow(2.0, -1076.0) == 0.0);
    CHECK(exact::pow(0x1p-1074, 0.5) == 0x1p-537);
    CHECK(std::isnan(exact::pow(-2.0, 2.0)));
    CHECK(std::isnan(exact::pow(2.0, not_a_number)));
}

TEST_CASE("pow with a whole exponent is exact where the power is a double", "[exact_math]") {
    for (int base = 2; base <= 32; ++base) {
        double power = 1.0;
        for (int exponent = 1; exponent <= 10; ++exponent) {
            power *= base;
            CHECK(exact::pow(base, exponent) == power);
        }
    }
}

TEST_CASE("sin is within 0.8 ulp of the true value", "[exact_math][long]") {
    CHECK(worst(exact::sin, mpfr_sin, uniform(-6.4, 6.4)) <= 0.8);
    CHECK(worst(exact::sin, mpfr_sin, uniform(-0x1p+20, 0x1p+20)) <= 0.8);
    CHECK(worst(exact::sin, mpfr_sin, log_uniform(-60, 2)) <= 0.8);
    CHECK(worst(exact::sin, mpfr_sin, near_quarter_turn) <= 0.8);
}

TEST_CASE("cos is within 0.8 ulp of the true value", "[exact_math][long]") {
    CHECK(worst(exact::cos, mpfr_cos, uniform(-6.4, 6.4)) <= 0.8);
    CHECK(worst(exact::cos, mpfr_cos, uniform(-0x1p+20, 0x1p+20)) <= 0.8);
    CHECK(worst(exact::cos, mpfr_cos, log_uniform(-60, 2)) <= 0.8);
    CHECK(worst(exact::cos, mpfr_cos, near_quarter_turn) <= 0.8);
}

TEST_CASE("sin and cos know zeros, their range and NaN", "[exact_math]") {
    CHECK(exact::sin(0.0) == 0.0);
    CHECK(std::signbit(exact::sin(-0.0)));
    CHECK(exact::cos(0.0) == 1.0);
    const double outside = GENERATE(0x1.0000000000001p+20, -0x1.0000000000001p+20, 1e300, infinity,
                                    -infinity, not_a_number);
    CHECK(std::isnan(exact::sin(outside)));
    CHECK(std::isnan(exact::cos(outside)));
}

TEST_CASE("acos is within 0.9 ulp of the true value", "[exact_math][long]") {
    CHECK(worst(exact::acos, mpfr_acos, uniform(-1, 1)) <= 0.9);
    CHECK(worst(exact::acos, mpfr_acos, uniform(0.5, 1)) <= 0.9);
    CHECK(worst(exact::acos, mpfr_acos, uniform(-1, -0.5)) <= 0.9);
    const auto gap = log_uniform(-53, -1);
    CHECK(worst(exact::acos, mpfr_acos, [&](std::uint64_t i) { return 1.0 - gap(i); }) <= 0.9);
    CHECK(worst(exact::acos, mpfr_acos, [&](std::uint64_t i) { return gap(i) - 1.0; }) <= 0.9);
    CHECK(worst(exact::acos, mpfr_acos, gap) <= 0.9);
}

TEST_CASE("acos is exact at the ends of its range and NaN outside", "[exact_math]") {
    CHECK(exact::acos(1.0) == 0.0);
    CHECK(exact::acos(-1.0) == exact::pi);
    CHECK(exact::acos(0.0) == exact::pi / 2);
    CHECK(std::isnan(exact::acos(std::nextafter(1.0, 2.0))));
    CHECK(std::isnan(exact::acos(std::nextafter(-1.0, -2.0))));
    CHECK(std::isnan(exact::acos(not_a_number)));
}
