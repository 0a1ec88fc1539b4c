#include "texunit/fnv1a.hpp"

#include <catch2/catch.hpp>
#include <limits>

using twofold::Fnv1a;

TEST_CASE("FNV-1a has its published values", "[fnv1a]") {
    CHECK(Fnv1a().value() == 0xcbf29ce484222325);
    CHECK(Fnv1a().text("a").value() == 0xaf63dc4c8601ec8c);
    CHECK(Fnv1a().text("foobar").value() == 0x85944171f73967e8);
}

TEST_CASE("typed values are hashed little-endian with one NaN", "[fnv1a]") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(Fnv1a().u32(1).f64(1.0).f32(nan).value() == 0x12dc6f62d423e144);
    CHECK(Fnv1a().u32(1).f64(1.0).f32(-nan).value() == 0x12dc6f62d423e144);
}

TEST_CASE("an integer is hashed as its bytes, least first", "[fnv1a]") {
    CHECK(Fnv1a().u32(0x04030201).value() == Fnv1a().u8(1).u8(2).u8(3).u8(4).value());
    CHECK(Fnv1a().u64(0x0807060504030201).value() ==
          Fnv1a().u32(0x04030201).u32(0x08070605).value());
}

TEST_CASE("the two zeros have different hashes", "[fnv1a]") {
    CHECK(Fnv1a().f64(0.0).value() != Fnv1a().f64(-0.0).value());
    CHECK(Fnv1a().f32(0.0f).value() != Fnv1a().f32(-0.0f).value());
}
