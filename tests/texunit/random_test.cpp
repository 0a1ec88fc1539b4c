#include "texunit/random.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace twofold;

TEST_CASE("the generator gives the published outputs of splitmix64", "[random]") {
    CHECK(random_u64(0, 0) == 0xe220a8397b1dcdaf);
    CHECK(random_u64(1234567, 0) == 6457827717110365317u);
    CHECK(random_u64(1234567, 1) == 3203168211198807973u);
    CHECK(random_u64(1234567, 2) == 9817491932198370423u);
    CHECK(random_u64(1234567, 3) == 4593380528125082431u);
    CHECK(random_u64(1234567, 4) == 16408922859458223821u);
}

TEST_CASE("32 bits are the upper half of 64", "[random]") { CHECK(random_u32(0, 0) == 0xe220a839); }

TEST_CASE("fractions are at least 0, below 1, and fill the interval evenly", "[random]") {
    constexpr int draws = 160000;
    std::array<int, 16> bins{};
    bool inside = true;
    for (std::uint64_t i = 0; i < draws; ++i) {
        const double u = random_unit(3, i);
        inside = inside && u >= 0.0 && u < 1.0;
        ++bins[static_cast<std::size_t>(u * 16.0)];
    }
    CHECK(inside);
    // 10,000 expected in each; the standard deviation is 97.
    for (const int bin : bins) CHECK(std::abs(bin - draws / 16) < 500);
}
