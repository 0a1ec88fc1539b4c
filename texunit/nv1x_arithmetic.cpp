#include "texunit/nv1x_arithmetic.hpp"

#include <array>
#include <bit>

#include "texunit/ieee_guard.hpp"
#include "texunit/nv1x_seeds.hpp"

namespace twofold::nv1x {
namespace {

constexpr Word nan_word = 0x7fffffffu;
constexpr Word infinity_word = 0x7f800000u;
constexpr Word largest_word = 0x7f7fffffu;

constexpr Word sign_of(Word a) { return a & 0x80000000u; }
constexpr int exponent_of(Word a) { return static_cast<int>(a >> 23 & 0xff); }
constexpr Word fraction_of(Word a) { return a & 0x7fffffu; }
/// 24-bit significand with the hidden bit.
constexpr Word significand_of(Word a) { return fraction_of(a) | 0x800000u; }
constexpr bool is_nan(Word a) { return exponent_of(a) == 255 && fraction_of(a) != 0; }
constexpr bool is_infinite(Word a) { return (a & 0x7fffffffu) == infinity_word; }
constexpr bool is_zero(Word a) { return exponent_of(a) == 0; }

/// A word from sign, exponent and 24-bit significand; out of range gives signed zero or the largest
/// number.
constexpr Word compose(Word sign, int exponent, std::uint64_t significand) {
    if (exponent <= 0) return sign;
    if (exponent >= 255) return sign | largest_word;
    return sign | static_cast<Word>(exponent) << 23 | (static_cast<Word>(significand) & 0x7fffffu);
}

/// One term of sum(): the significand moved to the common exponent and signed.
std::int64_t aligned(Word a, int common_exponent) {
    if (is_zero(a)) return 0;
    const int shift = common_exponent - exponent_of(a) - 7;
    if (shift > 31) return 0;
    const std::int64_t m = significand_of(a);
    const std::int64_t moved = shift >= 0 ? m >> shift : m << -shift;
    return sign_of(a) ? -moved : moved;
}

/// The special cases of sum(): NaN if any term is or if both infinities meet, else the infinity,
/// else 0.
Word special_sum(const std::array<Word, 4>& terms) {
    Word infinity = 0;
    for (const Word t : terms) {
        if (is_nan(t)) return nan_word;
        if (!is_infinite(t)) continue;
        if (infinity != 0 && infinity != t) return nan_word;
        infinity = t;
    }
    return infinity;
}

/// A seed of 7 bits and two Newton steps in integers.
Word reciprocal_from(const ReciprocalSeeds& seeds, Word a) {
    if (is_nan(a)) return nan_word;
    if (is_zero(a)) return sign_of(a) | infinity_word;
    if (is_infinite(a)) return sign_of(a);
    if (fraction_of(a) == 0) return compose(sign_of(a), 254 - exponent_of(a), 1u << 23);
    const std::uint64_t m = significand_of(a);
    const std::uint64_t t = seeds[fraction_of(a) >> 17];
    const std::uint64_t y1 = ((std::uint64_t{1} << 31) - t * m) * t >> 24;
    const std::uint64_t y2 = ((std::uint64_t{1} << 37) - y1 * m) * y1 >> 25;
    return compose(sign_of(a), 253 - exponent_of(a), y2);
}

Word reciprocal_sqrt_from(const RootSeeds& seeds, Word a) {
    if (is_nan(a)) return nan_word;
    if (is_zero(a)) return infinity_word;
    if (is_infinite(a)) return 0;
    const int e = exponent_of(a);
    const bool even = (e & 1) == 0;
    const std::uint64_t m = std::uint64_t{significand_of(a)} << (even ? 1 : 0);
    const std::uint64_t t = seeds[(fraction_of(a) >> 17) + (even ? 64u : 0u)];
    const std::uint64_t y1 = ((std::uint64_t{3} << 37) - t * t * m) * t >> 32;
    const std::uint64_t y2 = ((std::uint64_t{3} << 49) - y1 * y1 * m) * y1 >> 39;
    const int half = (e - 127) >> 1;  // arithmetic shift: floor
    return compose(0, 126 - half, y2);
}

}  // namespace

Word mul(Word a, Word b) {
    if (is_nan(a) || is_nan(b)) return nan_word;
    if (is_zero(a) || is_zero(b)) return 0;
    if (is_infinite(a) || is_infinite(b)) return infinity_word;
    int exponent = exponent_of(a) + exponent_of(b) - 127;
    std::uint64_t product = std::uint64_t{significand_of(a)} * significand_of(b) >> 23;
    if (product >= 1u << 24) {
        product >>= 1;
        ++exponent;
    }
    return compose(sign_of(a) ^ sign_of(b), exponent, product);
}

Word sum(Word a, Word b, Word c, Word d) {
    const std::array<Word, 4> terms{a, b, c, d};
    if (const Word special = special_sum(terms); special != 0) return special;
    int exponent = 0;
    for (const Word t : terms)
        if (exponent_of(t) > exponent) exponent = exponent_of(t);
    exponent += 2;
    std::int64_t total = 0;
    for (const Word t : terms) total += aligned(t, exponent);
    if (total == 0) return 0;
    const Word sign = total < 0 ? 0x80000000u : 0u;
    const auto magnitude = static_cast<std::uint64_t>(total < 0 ? -total : total);
    const int shift =
        31 - static_cast<int>(std::bit_width(magnitude));  // brings the leading one to bit 30
    const std::uint64_t significand = shift >= 0 ? magnitude << shift : magnitude >> -shift;
    return compose(sign, exponent - shift, significand >> 7);
}

Word reciprocal(Word a) { return reciprocal_from(reciprocal_seeds, a); }
Word reciprocal_v2(Word a) { return reciprocal_from(rounded_reciprocal_seeds, a); }

Word clip_reciprocal(Word w) {
    const Word r = reciprocal(w);
    if (is_nan(r)) return r;
    const int e = exponent_of(r);
    const int held = e < 63 ? 63 : (e > 191 ? 191 : e);
    return sign_of(r) | static_cast<Word>(held) << 23 | fraction_of(r);
}

Word clip_reciprocal_v2(Word w) {
    const Word r = reciprocal_v2(w);
    if (is_nan(r)) return r;
    const int e = exponent_of(r);
    if (e < 63) return sign_of(r) | Word{63} << 23;
    return e > 191 ? sign_of(r) | Word{191} << 23 : r;
}

Word reciprocal_sqrt(Word a) { return reciprocal_sqrt_from(root_seeds, a); }
Word reciprocal_sqrt_v2(Word a) { return reciprocal_sqrt_from(rounded_root_seeds, a); }

int float_to_byte(Word a) {
    const int e = exponent_of(a);
    if (sign_of(a)) return 0;
    if (e >= 127) return 255;
    if (e < 118) return 0;
    const std::uint64_t f = std::uint64_t{(1u << 13) + (fraction_of(a) >> 10)} << (e - 116);
    const std::uint64_t rounded = ((f * 255 >> 23) + 1) >> 1;
    return rounded < 255 ? static_cast<int>(rounded) : 255;
}

Word round_to_22_bits(Word a) {
    const bool all_ones = (a >> 10 & 0xff) == 0xff;
    return (all_ones ? a : a + 0x200u) & ~Word{0x3ff};
}

}  // namespace twofold::nv1x

namespace twofold {

Nv1xArithmetic::Word Nv1xArithmetic::from_double(double x) {
    return std::bit_cast<Word>(static_cast<float>(x));
}

double Nv1xArithmetic::to_double(Word x) { return static_cast<double>(std::bit_cast<float>(x)); }

Nv1xArithmetic::Word Nv1xArithmetic::reflect(Word scaled, Word e, bool is_z) {
    if (!is_z) return nv1x::sum(scaled, negate(e));
    constexpr Word one = 0x3f800000u;
    const Word sphere = nv1x::sum(nv1x::sum(scaled, one), negate(e));
    return nv1x::sum(sphere, negate(one));
}

}  // namespace twofold
