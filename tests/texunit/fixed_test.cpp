#include "texunit/fixed.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace {
using namespace twofold;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
}  // namespace

TEST_CASE("to_fixed rounds down within its range", "[fixed]") {
    CHECK(to_fixed(2.999, -10, 10) == 2);
    CHECK(to_fixed(-2.001, -10, 10) == -3);
    CHECK(to_fixed(-0.0, -10, 10) == 0);
    CHECK(to_fixed(3.0, -10, 10) == 3);
    CHECK(to_fixed(4294967295.5, std::int64_t{0}, std::int64_t{0xffffffff}) == 0xffffffff);
}

TEST_CASE("to_fixed_half_up takes halves up", "[fixed]") {
    CHECK(to_fixed_half_up(2.5, -10, 10) == 3);
    CHECK(to_fixed_half_up(-2.5, -10, 10) == -2);
    CHECK(to_fixed_half_up(2.49, -10, 10) == 2);
    CHECK(to_fixed_half_up(0.49999999999999994, 0, 255) == 1);
}

TEST_CASE("a conversion to fixed point clamps what is out of range", "[fixed]") {
    CHECK(to_fixed(infinity, 0, 255) == 255);
    CHECK(to_fixed(-infinity, 0, 255) == 0);
    CHECK(to_fixed(1e300, -8, 7) == 7);
    CHECK(to_fixed_half_up(1e300, -8, 7) == 7);
    CHECK(to_fixed_half_up(254.9, 0, 255) == 255);
    CHECK(to_fixed_half_up(255.9, 0, 255) == 255);
    CHECK(to_fixed_half_up(-1e300, -8, 7) == -8);
    constexpr int least = std::numeric_limits<int>::min();
    constexpr int greatest = std::numeric_limits<int>::max();
    CHECK(to_fixed(-1e10, least, greatest) == least);
    CHECK(to_fixed_half_up(1e10, least, greatest) == greatest);
}

TEST_CASE("a NaN becomes 0 and is counted", "[fixed]") {
    NanCount nans;
    CHECK(to_fixed(not_a_number, 0, 255, nans) == 0);
    CHECK(to_fixed_half_up(-not_a_number, 1, 255, nans) == 0);
    CHECK(to_fixed(1.0, 0, 255, nans) == 1);
    CHECK(to_fixed_half_up(1.0, 0, 255, nans) == 1);
    CHECK(nans.value == 2);
    CHECK(to_fixed(not_a_number, 0, 255) == 0);
    CHECK(to_fixed_half_up(not_a_number, 0, 255) == 0);
}

TEST_CASE("every byte survives the way to a fraction and back", "[fixed]") {
    for (int byte = 0; byte < 256; ++byte) {
        CHECK(to_fixed_half_up(byte / 255.0 * 255.0, 0, 255) == byte);
    }
}

TEST_CASE("min and max return the first argument on ties and for NaN", "[fixed]") {
    CHECK(twofold::min(1, 2) == 1);
    CHECK(twofold::max(1, 2) == 2);
    CHECK(std::signbit(twofold::min(-0.0, 0.0)));
    CHECK_FALSE(std::signbit(twofold::min(0.0, -0.0)));
    CHECK(std::signbit(twofold::max(-0.0, 0.0)));
    CHECK_FALSE(std::signbit(twofold::max(0.0, -0.0)));
    CHECK(std::isnan(twofold::min(not_a_number, 1.0)));
    CHECK(twofold::min(1.0, not_a_number) == 1.0);
    CHECK(std::isnan(twofold::max(not_a_number, 1.0)));
    CHECK(twofold::max(1.0, not_a_number) == 1.0);
}

TEST_CASE("canonical changes NaN only", "[fixed]") {
    CHECK(std::bit_cast<std::uint64_t>(canonical(-not_a_number)) == 0x7ff8000000000000);
    CHECK(std::bit_cast<std::uint32_t>(canonical(std::bit_cast<float>(0xffc12345u))) == 0x7fc00000);
    CHECK(std::signbit(canonical(-0.0)));
    CHECK(std::signbit(canonical(-0.0f)));
    CHECK(canonical(infinity) == infinity);
    CHECK(canonical(0x1p-1074) == 0x1p-1074);
}
