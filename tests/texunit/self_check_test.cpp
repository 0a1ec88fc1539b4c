#include "texunit/self_check.hpp"

#include <catch2/catch.hpp>
#include <cfenv>

#ifdef __SSE2__
#include <immintrin.h>
#endif

using twofold::floating_point_defects;

TEST_CASE("the self-check finds nothing wrong in a right build", "[self_check]") {
    CHECK(floating_point_defects().empty());
}

TEST_CASE("the self-check names a rounding mode that is not to nearest", "[self_check][fpu]") {
    const int mode = GENERATE(FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO);
    std::fesetround(mode);
    const std::string found = floating_point_defects();
    std::fesetround(FE_TONEAREST);
    CHECK(found.find("rounding mode") != std::string::npos);
}

#ifdef __SSE2__
TEST_CASE("the self-check names flushed and ignored denormals", "[self_check][fpu]") {
    const unsigned saved = _mm_getcsr();
    constexpr unsigned flush_to_zero = 0x8000;
    constexpr unsigned denormals_are_zero = 0x0040;
    _mm_setcsr(saved | flush_to_zero);
    const std::string flushing = floating_point_defects();
    _mm_setcsr(saved | denormals_are_zero);
    const std::string ignoring = floating_point_defects();
    _mm_setcsr(saved | flush_to_zero | denormals_are_zero);
    const std::string both = floating_point_defects();
    _mm_setcsr(saved);
    CHECK(flushing == "flush to zero");
    CHECK(ignoring.find("denormals are zero") != std::string::npos);
    CHECK(both.find("flush to zero, denormals are zero") != std::string::npos);
}
#endif
