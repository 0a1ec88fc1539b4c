#include "texunit/nv1x_arithmetic.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "texunit/random.hpp"

/// The chip's arithmetic against restatements that share nothing with it: products and sums in
/// exact binary64 with ldexp and trunc, reciprocals against the quotient.
namespace {
using namespace twofold;
using namespace twofold::nv1x;

constexpr Word nan_word = 0x7fffffff, infinity = 0x7f800000, largest = 0x7f7fffff;
constexpr Word minus = 0x80000000;

Word word(double x) { return std::bit_cast<Word>(static_cast<float>(x)); }
double real(Word x) { return static_cast<double>(std::bit_cast<float>(x)); }

bool is_nan(Word a) { return std::isnan(std::bit_cast<float>(a)); }
bool is_infinite(Word a) { return std::isinf(std::bit_cast<float>(a)); }
bool is_flushed(Word a) { return std::fabs(std::bit_cast<float>(a)) < 0x1p-126f; }

/// x cut to 24 bits toward zero, the chip's way at both ends of the range.
Word cut(double x) {
    const Word sign = std::signbit(x) ? minus : 0;
    if (std::fabs(x) < 0x1p-126) return sign;
    if (std::fabs(x) >= 0x1p128) return sign | largest;
    int e = 0;
    const double f = std::frexp(x, &e);
    return word(std::ldexp(std::trunc(std::ldexp(f, 24)), e - 24));
}

Word product(Word a, Word b) {
    if (is_nan(a) || is_nan(b)) return nan_word;
    if (is_flushed(a) || is_flushed(b)) return 0;
    if (is_infinite(a) || is_infinite(b)) return infinity;
    return cut(real(a) * real(b));  // 48 bits: exact
}

/// Terms are cut to multiples of the largest one's last place / 2^5, then added exactly.
Word total(const std::array<Word, 4>& terms) {
    bool plus_infinity = false, minus_infinity = false;
    int top = -1000;
    for (const Word t : terms) {
        if (is_nan(t)) return nan_word;
        if (is_infinite(t)) (t == infinity ? plus_infinity : minus_infinity) = true;
        if (!is_flushed(t) && !is_infinite(t)) top = std::max(top, std::ilogb(real(t)));
    }
    if (plus_infinity && minus_infinity) return nan_word;
    if (plus_infinity || minus_infinity) return plus_infinity ? infinity : infinity | minus;
    double sum = 0.0;
    for (const Word t : terms)
        if (!is_flushed(t)) sum += std::trunc(std::ldexp(real(t), 28 - top));
    return sum == 0.0 ? 0 : cut(std::ldexp(sum, top - 28));
}

/// Words of all kinds: any bits, near in exponent, and the special ones.
Word random_word(std::uint64_t index) {
    static const std::vector<Word> special{0,
                                           minus,
                                           1,
                                           minus | 1,
                                           0x007fffff,
                                           0x00800000,
                                           infinity,
                                           infinity | minus,
                                           nan_word,
                                           0x7f800001,
                                           0xffc00000,
                                           largest,
                                           largest | minus,
                                           0x3f800000,
                                           0xbf800000};
    const std::uint64_t r = random_u64(2002, index);
    const auto bits = static_cast<Word>(r);
    switch (r >> 61) {
        case 0:
            return special[(r >> 32) % special.size()];
        case 1:
        case 2:
            return bits;
        default:  // exponents 110..141: terms that meet
            return (bits & 0x807fffff) | static_cast<Word>(110 + (r >> 40) % 32) << 23;
    }
}

constexpr std::uint64_t samples = 300000;

/// Largest relative error of `f` against `exact` over all fractions at one exponent.
template <class F, class Exact>
double worst_error(Word exponent, F f, Exact exact) {
    double worst = 0.0;
    for (Word m = 0; m < 1u << 23; ++m) {
        const Word a = exponent << 23 | m;
        const double e = exact(real(a));
        worst = std::max(worst, std::fabs(real(f(a)) - e) / e);
    }
    return worst;
}
}  // namespace

TEST_CASE("a product is the exact product cut toward zero", "[nv1x]") {
    int wrong = 0;
    for (std::uint64_t i = 0; i < samples; ++i) {
        const Word a = random_word(2 * i), b = random_word(2 * i + 1);
        wrong += mul(a, b) != product(a, b);
    }
    CHECK(wrong == 0);
}

TEST_CASE("a sum cuts each term at the largest one's scale and adds once", "[nv1x]") {
    int wrong = 0;
    for (std::uint64_t i = 0; i < samples; ++i) {
        std::array<Word, 4> t{};
        for (std::size_t k = 0; k < 4; ++k) t[k] = random_word(1000000 + 4 * i + k);
        wrong += sum(t[0], t[1], t[2], t[3]) != total(t);
        wrong += sum(t[0], t[1], t[2]) != total({t[0], t[1], t[2], 0});
        wrong += sum(t[0], t[1]) != total({t[0], t[1], 0, 0});
    }
    CHECK(wrong == 0);
}

TEST_CASE("a sum at once is not the sum in pairs", "[nv1x]") {
    const Word one = word(1.0), tiny = word(0x1p-24), half_last_place = word(0.75 * 0x1p-23);
    CHECK(sum(one, tiny, tiny) == word(1.0 + 0x1p-23));
    CHECK(sum(sum(one, tiny), tiny) == one);
    CHECK(sum(one, half_last_place) == one);
}

TEST_CASE("special values of products and sums follow the chip, not IEEE", "[nv1x]") {
    const Word one = word(1.0);
    CHECK(mul(0, infinity) == 0);
    CHECK(mul(minus, one) == 0);
    CHECK(mul(infinity | minus, one) == infinity);
    CHECK(mul(nan_word, 0) == nan_word);
    CHECK(mul(0xffc00001, one) == nan_word);
    CHECK(mul(largest, word(-2.0)) == (largest | minus));
    CHECK(mul(word(0x1p-126), word(-0.5)) == minus);
    CHECK(mul(0x007fffff, one) == 0);
    CHECK(sum(one, one ^ minus) == 0);
    CHECK(sum(minus, minus) == 0);
    CHECK(sum(infinity, one) == infinity);
    CHECK(sum(infinity | minus, one, one) == (infinity | minus));
    CHECK(sum(infinity, infinity | minus) == nan_word);
    CHECK(sum(infinity, infinity | minus, nan_word) == nan_word);
    CHECK(sum(largest, largest) == largest);
    CHECK(sum(0x007fffff, one) == one);
}

TEST_CASE("the reciprocal errs by at most 4.3e-7 over all fractions", "[nv1x]") {
    const auto exact = [](double x) { return 1.0 / x; };
    const double even = worst_error(126, reciprocal, exact);
    const double odd = worst_error(127, reciprocal, exact);
    CHECK(even == odd);
    CHECK(odd < 4.3e-7);
    CHECK(odd > 4.2e-7);
}

TEST_CASE("the reciprocal root errs by at most 7.31e-7 for both parities of the exponent",
          "[nv1x]") {
    const auto exact = [](double x) { return 1.0 / std::sqrt(x); };
    const double even = worst_error(128, reciprocal_sqrt, exact);
    const double odd = worst_error(127, reciprocal_sqrt, exact);
    CHECK(even < 7.31e-7);
    CHECK(even > 7.30e-7);
    CHECK(odd < 3.02e-7);
}

TEST_CASE("special values of the reciprocals", "[nv1x]") {
    CHECK(reciprocal(0) == infinity);
    CHECK(reciprocal(minus) == (infinity | minus));
    CHECK(reciprocal(infinity) == 0);
    CHECK(reciprocal(infinity | minus) == minus);
    CHECK(reciprocal(nan_word) == nan_word);
    CHECK(reciprocal(largest) == 0);  // 2^-128: below the smallest normal
    for (int k = -125; k <= 125; ++k)
        CHECK(reciprocal(word(std::ldexp(-1.0, k))) == word(std::ldexp(-1.0, -k)));
    CHECK(reciprocal_sqrt(0) == infinity);
    CHECK(reciprocal_sqrt(infinity) == 0);
    CHECK(reciprocal_sqrt(nan_word) == nan_word);
    CHECK(reciprocal_sqrt(word(-4.0)) == reciprocal_sqrt(word(4.0)));
    for (int k = -60; k <= 60; ++k) {
        const double root = real(reciprocal_sqrt(word(std::ldexp(1.0, 2 * k))));
        CHECK(root == Approx(std::ldexp(1.0, -k)).epsilon(7.31e-7));
    }
}

TEST_CASE("the reciprocal of clip w keeps its exponent within 63..191", "[nv1x]") {
    CHECK(clip_reciprocal(0) == word(0x1p64));
    CHECK(clip_reciprocal(minus) == word(-0x1p64));
    CHECK(clip_reciprocal(word(0x1p-100)) == word(0x1p64));
    CHECK(clip_reciprocal(word(0x1p100)) == word(0x1p-64));
    CHECK(clip_reciprocal(infinity) == word(0x1p-64));
    CHECK(clip_reciprocal(nan_word) == nan_word);
    for (const double w : {0.5, 1.0, 3.0, -7.25, 1e10, 1e-10})
        CHECK(clip_reciprocal(word(w)) == reciprocal(word(w)));
}

TEST_CASE("0.7 and 0.9 become the bytes that the chip's model gives", "[nv1x]") {
    const auto rgb = [](double x) { return float_to_byte(round_to_22_bits(word(x))); };
    CHECK(rgb(0.7) == 179);
    CHECK(float_to_byte(word(0.7)) == 178);
    CHECK(rgb(0.9) == 230);
    CHECK(float_to_byte(word(0.9)) == 229);
}

TEST_CASE("all 256 bytes come back through a float, with and without the 22-bit rounding",
          "[nv1x]") {
    for (int k = 0; k < 256; ++k) {
        const Word w = word(k * 0x010101 * 0x1p-24);  // a byte as the chip turns it into a float
        CHECK(float_to_byte(w) == k);
        CHECK(float_to_byte(round_to_22_bits(w)) == k);
        CHECK(float_to_byte(word(k / 255.0)) == k);
        CHECK(float_to_byte(round_to_22_bits(word(k / 255.0))) == k);
    }
}

TEST_CASE("a float becomes a byte by sign, size and 13 fraction bits", "[nv1x]") {
    for (const Word w : {Word{0}, minus, word(-0.5), infinity | minus, 0xffc00000u, word(0x1p-10),
                         word(0x1p-20), Word{1}})
        CHECK(float_to_byte(w) == 0);
    for (const Word w : {word(1.0), word(1.5), word(1e30), infinity, nan_word})
        CHECK(float_to_byte(w) == 255);
    int backward = 0, away = 0;
    for (Word w = word(0x1p-12); w < word(1.0); w += 64) {
        backward += float_to_byte(w) > float_to_byte(w + 64);
        away +=
            std::fabs(float_to_byte(w) - 255.0 * real(w)) > 0.5156;  // a step of 2^-14 above a half
    }
    CHECK(backward == 0);
    CHECK(away == 0);
}

TEST_CASE("the 22-bit rounding adds half a unit unless it would carry past eight ones", "[nv1x]") {
    CHECK(round_to_22_bits(0x3f000200) == 0x3f000400);
    CHECK(round_to_22_bits(0x3f0001ff) == 0x3f000000);
    CHECK(round_to_22_bits(0x3f03fe00) == 0x3f03fc00);
    CHECK(round_to_22_bits(0x3f03fa00) == 0x3f03fc00);
}

TEST_CASE("the z of a reflection loses its low bits near 0", "[nv1x]") {
    const Word small = word(0x1.234567p-20);
    CHECK(Nv1xArithmetic::reflect(small, 0, false) == small);
    CHECK(Nv1xArithmetic::reflect(small, 0, true) == word(0x1.2p-20));
}

TEST_CASE("1/w leaves the vertex stage without its low 8 bits", "[nv1x]") {
    CHECK(Nv1xArithmetic::emitted_reciprocal(0x3eaaaaab) == 0x3eaaaa00);
    CHECK(Nv1xArithmetic::emitted_reciprocal(word(0.5)) == word(0.5));
}

TEST_CASE("the NV2x reciprocals err by at most 2.28e-7 and 3.13e-7", "[nv2x]") {
    const double reciprocal = worst_error(127, reciprocal_v2, [](double x) { return 1.0 / x; });
    CHECK(reciprocal < 2.28e-7);
    CHECK(reciprocal > 2.27e-7);
    const auto root = [](double x) { return 1.0 / std::sqrt(x); };
    const double worst = std::max(worst_error(127, reciprocal_sqrt_v2, root),
                                  worst_error(128, reciprocal_sqrt_v2, root));
    CHECK(worst < 3.13e-7);
    CHECK(worst > 3.11e-7);
}

TEST_CASE("a clip reciprocal of NV2x that is held loses its fraction, one of NV1x keeps it",
          "[nv2x]") {
    const Word small = word(0x1.8p-100), large = word(0x1.8p100);
    CHECK(clip_reciprocal_v2(small) == word(0x1p64));
    CHECK(clip_reciprocal_v2(large) == word(0x1p-64));
    CHECK(clip_reciprocal(small) != clip_reciprocal_v2(small));
    CHECK(clip_reciprocal_v2(0) == word(0x1p64));
    CHECK(clip_reciprocal_v2(nan_word) == nan_word);
    for (const double w : {0.5, 1.0, 3.0, -7.25, 1e10, 1e-10})
        CHECK(clip_reciprocal_v2(word(w)) == reciprocal_v2(word(w)));
}

TEST_CASE("1/w leaves the NV2x vertex stage whole", "[nv2x]") {
    CHECK(Nv2xArithmetic::emitted_reciprocal(0x3eaaaaab) == 0x3eaaaaab);
}
