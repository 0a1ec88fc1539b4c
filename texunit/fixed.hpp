#pragma once
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

/// From floating point to integers, and comparisons, with one result on every platform: the
/// language leaves out-of-range casts undefined and the C library's fmin and fmax treat zeros and
/// NaN each in its own way (docs/exactness.md, section 5).
namespace twofold {

template <class T>
concept Arithmetic = std::integral<T> || std::floating_point<T>;

/// The lesser of two; the first on ties (+0 and -0 included) and whenever either is a NaN.
template <Arithmetic T>
constexpr T min(T a, T b) {
#ifdef __wasm__
    // Of the line below alone clang 14 makes f64.min, which puts -0 below +0.
    if (a == b) return a;
#endif
    return b < a ? b : a;
}

/// The greater of two; the first on ties (+0 and -0 included) and whenever either is a NaN.
template <Arithmetic T>
constexpr T max(T a, T b) {
#ifdef __wasm__
    if (a == b) return a;
#endif
    return a < b ? b : a;
}

/// The only NaN patterns that are stored or hashed.
inline constexpr std::uint32_t canonical_nan_bits_f32 = 0x7fc00000;
inline constexpr std::uint64_t canonical_nan_bits_f64 = 0x7ff8000000000000;

/// x, or the canonical NaN for any NaN; -0 stays -0.
constexpr float canonical(float x) {
    return x == x ? x : std::bit_cast<float>(canonical_nan_bits_f32);
}

constexpr double canonical(double x) {
    return x == x ? x : std::bit_cast<double>(canonical_nan_bits_f64);
}

/// How many NaN a caller has met; it owns the count.
struct NanCount {
    std::uint64_t value = 0;
};

/// Largest integer <= x after x was clamped to [lo, hi]; 0 for NaN, whatever the range.
/// @param lo, hi at most 2^53 in magnitude, lo <= hi
template <std::integral Integer>
Integer to_fixed(double x, Integer lo, Integer hi) {
    const double number = x == x ? x : 0.0;
    const double inside = min(max(number, static_cast<double>(lo)), static_cast<double>(hi));
    return x == x ? static_cast<Integer>(std::floor(inside)) : Integer{0};
}

/// As above, counting a NaN.
template <std::integral Integer>
Integer to_fixed(double x, Integer lo, Integer hi, NanCount& nans) {
    if (x != x) ++nans.value;
    return to_fixed(x, lo, hi);
}

/// floor(x + 0.5) after x was clamped to [lo, hi]; 0 for NaN. The addition is rounded to binary64,
/// so the double just below 0.5 gives 1, as it does in the presets' formula.
template <std::integral Integer>
Integer to_fixed_half_up(double x, Integer lo, Integer hi) {
    const double inside = min(max(x, static_cast<double>(lo)), static_cast<double>(hi));
    return to_fixed(inside + 0.5, lo, hi);
}

/// As above, counting a NaN.
template <std::integral Integer>
Integer to_fixed_half_up(double x, Integer lo, Integer hi, NanCount& nans) {
    if (x != x) ++nans.value;
    return to_fixed_half_up(x, lo, hi);
}

}  // namespace twofold
