#include <limits>

#include "tests/platforms/named_hash.hpp"
#include "texunit/byte_arithmetic.hpp"
#include "texunit/fixed.hpp"
#include "texunit/number_text.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold::platforms {
namespace {

Hashes random_number_hashes() {
    Hashes hashes;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        hashes.push_back(hash_over(fmt::format("random/u64/seed-{}", seed), 256,
                                   [=](std::size_t i) { return random_u64(seed, i); }));
        hashes.push_back(hash_over(fmt::format("random/unit/seed-{}", seed), 256,
                                   [=](std::size_t i) { return random_unit(seed, i); }));
    }
    return hashes;
}

/// Magnitudes from far below 1 to far above, and what is no number.
double awkward(std::size_t i) {
    constexpr std::array special{0.0, -0.0, std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
    if (i < special.size()) return special[i];
    return real(i, 1, -1.0, 1.0) * static_cast<double>(std::uint64_t{1} << i % 48);
}

Hashes conversion_hashes() {
    const auto over = [](const char* name, const auto& result) {
        return hash_over(name, 512, [&](std::size_t i) { return result(awkward(i)); });
    };
    return {over("fixed/floor", [](double x) { return to_fixed(x, -1000, 1000); }),
            over("fixed/half-up", [](double x) { return to_fixed_half_up(x, -32768, 32767); }),
            over("fixed/canonical", [](double x) { return canonical(x); }),
            over("fixed/minimum", [](double x) { return min(x, -0.0); }),
            over("fixed/maximum", [](double x) { return max(x, 0.0); })};
}

Hashes byte_hashes() {
    const auto pairs = [](const char* name, const auto& result) {
        return hash_over(name, 65536, [&](std::size_t i) {
            return result(static_cast<int>(i >> 8), static_cast<int>(i & 255));
        });
    };
    Hashes hashes{
        pairs("bytes/product", mul_rn),
        pairs("bytes/255th", [](int a, int b) { return rounded_255th(a * 255 - b * b); }),
        pairs("bytes/sum", [](int a, int b) { return sum_rn(a, b, 255 - b, a ^ b); }),
        pairs("bytes/difference", [](int a, int b) { return difference_rn(a, b, b, a ^ b); }),
        pairs("bytes/lerp", [](int a, int b) { return flerp(a, 255 - a, b); }),
        hash_over("bytes/round", 4096, [](std::size_t i) { return rn8(real(i, 1, -0.1, 1.1)); }),
        hash_over("bytes/floor", 4096,
                  [](std::size_t i) { return floor8(real(i, 1, -0.1, 1.1)); })};
    for (const int bits : {1, 4, 5, 6, 8})
        hashes.push_back(
            hash_over(fmt::format("bytes/replicated/{}-bits", bits), std::size_t{1} << bits,
                      [=](std::size_t v) { return replicated_byte(static_cast<int>(v), bits); }));
    return hashes;
}

Hashes sum_hashes() {
    Hashes hashes;
    for (const std::size_t n : {0u, 1u, 7u, 8u, 9u, 255u, 256u, 257u, 1000u, 4096u, 65537u})
        hashes.push_back(hash_of(fmt::format("sums/{}-terms", n), ordered_sum(n, [](std::size_t i) {
                                     return real(i, 1, -1.0, 1.0) / static_cast<double>(i + 1);
                                 })));
    return hashes;
}

Hashes text_hashes() {
    Hashes hashes;
    for (const char* text : {"0.1", "-1e-308", "4.9e-324", "1e999", "123456789.123456789",
                             "9007199254740993", "0.50000000000000002775"})
        hashes.push_back(hash_of(fmt::format("text/{}", text), *parse_real(text)));
    return hashes;
}

}  // namespace

Hashes number_hashes() {
    Hashes hashes = random_number_hashes();
    append(hashes, conversion_hashes());
    append(hashes, byte_hashes());
    append(hashes, sum_hashes());
    append(hashes, text_hashes());
    return hashes;
}

}  // namespace twofold::platforms
