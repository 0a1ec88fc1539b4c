#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/texunit/precise.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/parallel.hpp"

namespace {

namespace exact = twofold::exact;
using namespace twofold::precise;

/// Finds the floats with bit patterns [first, last] for which own(x), rounded to float, is not the
/// float nearest to the true value. A double that is not near the middle between two floats decides
/// by itself, for it is also held against the C library's double: more than two ulp apart counts as
/// wrong too. MPFR decides the others.
class FloatSweep {
  public:
    FloatSweep(Function own, Function library, Oracle oracle)
        : own_(own), library_(library), oracle_(oracle) {}

    std::vector<std::uint32_t> misrounded(std::uint32_t first, std::uint32_t last) const {
        constexpr std::uint64_t chunk = 1u << 22;
        const std::uint64_t end = std::uint64_t{last} + 1;
        std::vector<std::vector<std::uint32_t>> found((end - first + chunk - 1) / chunk);
        twofold::parallel_for(found.size(), 0, [&](std::size_t k) {
            const std::uint64_t begin = first + k * chunk;
            found[k] = misrounded_in(begin, begin + chunk < end ? begin + chunk : end);
        });
        std::vector<std::uint32_t> all;
        for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

  private:
    std::vector<std::uint32_t> misrounded_in(std::uint64_t begin, std::uint64_t end) const {
        std::vector<std::uint32_t> found;
        for (std::uint64_t i = begin; i < end; ++i) {
            const auto bits = static_cast<std::uint32_t>(i);
            if (is_wrong(std::bit_cast<float>(bits))) found.push_back(bits);
        }
        return found;
    }

    bool is_wrong(float x) const {
        const auto argument = static_cast<double>(x);
        const double value = own_(argument);
        const double reference = library_(argument);
        if (std::isnan(reference)) return !std::isnan(value);
        if (std::isinf(reference)) return value != reference;
        if (std::fabs(value - reference) > 0x1p-51 * std::fabs(reference)) {
            // Denormal doubles have no relative accuracy; all of them are zero as floats.
            if (std::fabs(reference) > 0x1p-1000) return true;
        }
        const auto below = static_cast<float>(value * (1.0 - 0x1p-40));
        const auto above = static_cast<float>(value * (1.0 + 0x1p-40));
        return below != above && static_cast<float>(value) != correct(argument);
    }

    float correct(double x) const {
        Precise value(x);
        oracle_(value.get(), value.get(), MPFR_RNDN);
        return value.nearest_float();
    }

    Function own_;
    Function library_;
    Oracle oracle_;
};

constexpr std::uint32_t sign = 0x80000000;
constexpr std::uint32_t float_two_pi = 0x40c90fdb;

}  // namespace

// Hidden, for each takes a minute or more: run by test_texunit "[.exhaustive]".
TEST_CASE("exp rounds to the right float for every float", "[.exhaustive]") {
    const FloatSweep sweep(exact::exp, std::exp, mpfr_exp);
    CHECK(sweep.misrounded(0, 0xffffffff).empty());
}

TEST_CASE("log rounds to the right float for every float but five", "[.exhaustive]") {
    const FloatSweep sweep(exact::log, std::log, mpfr_log);
    const std::vector<std::uint32_t> known = {0x3c413d3a, 0x41178feb, 0x4c5d65a5, 0x65d890d3,
                                              0x6f31a8ec};
    CHECK(sweep.misrounded(0, 0xffffffff) == known);
}

TEST_CASE("sin rounds to the right float for every float of two turns", "[.exhaustive]") {
    const FloatSweep sweep(exact::sin, std::sin, mpfr_sin);
    CHECK(sweep.misrounded(0, float_two_pi).empty());
    CHECK(sweep.misrounded(sign, sign + float_two_pi).empty());
}

TEST_CASE("cos rounds to the right float for every float of two turns", "[.exhaustive]") {
    const FloatSweep sweep(exact::cos, std::cos, mpfr_cos);
    CHECK(sweep.misrounded(0, float_two_pi).empty());
    CHECK(sweep.misrounded(sign, sign + float_two_pi).empty());
}
