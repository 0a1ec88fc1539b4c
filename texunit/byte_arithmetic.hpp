#pragma once

/// Integer primitives of 8-bit colour arithmetic: 0..255 stands for 0..1. Each is one formula,
/// checked over its whole domain in tests/texunit/byte_arithmetic_test.cpp.
namespace twofold {

/// round(a b / 255). The quotient never ends in .5 because 255 is odd, so rounding has one meaning.
constexpr int mul_rn(int a, int b) {
    const int t = a * b + 128;
    return (t + (t >> 8)) >> 8;
}

/// round((a b + c d) / 255) limited to 255: one rounding of the whole sum.
constexpr int sum_rn(int a, int b, int c, int d) {
    const int rounded = (2 * (a * b + c * d) + 255) / 510;
    return rounded < 255 ? rounded : 255;
}

/// round(x / 255) of any sign; no quotient ends in .5.
constexpr int rounded_255th(int x) { return x < 0 ? -((255 - 2 * x) / 510) : (2 * x + 255) / 510; }

/// round((a b - c d) / 255), negative results giving 0: one rounding of the whole difference.
constexpr int difference_rn(int a, int b, int c, int d) {
    const int rounded = rounded_255th(a * b - c * d);
    return rounded > 0 ? rounded : 0;
}

/// The byte that `bits` stored bits stand for: their pattern repeated downward.
/// @source captures of NV2A (T10)
constexpr int replicated_byte(int v, int bits) {
    int byte = v << (8 - bits);
    for (int known = bits; known < 8; known *= 2) byte |= byte >> known;
    return byte;
}

/// The highest `bits` bits of a byte, zeros below.
constexpr int keep_high_bits(int byte, int bits) { return byte >> (8 - bits) << (8 - bits); }

/// A byte raised by n sixteenths of the step that `bits` bits have, ready to be cut to them.
constexpr int dither_byte(int byte, int bits, int n) {
    const int raised = byte + (n << (8 - bits) >> 4);
    return raised < 255 ? raised : 255;
}

/// (p (256 - w) + q w) / 256, halves rounded up; w in 0..255.
constexpr int flerp(int p, int q, int w) { return (256 * p + (q - p) * w + 128) >> 8; }

/// floor(255 x + 1/2) of x limited to [0, 1]; NaN gives 0.
/// @source OpenGL 1.3, 2.13.9
constexpr int rn8(double x) {
    if (!(x > 0.0)) return 0;
    return x < 1.0 ? static_cast<int>(255.0 * x + 0.5) : 255;
}

/// floor(255 x) of x limited to [0, 1]; NaN gives 0.
constexpr int floor8(double x) {
    if (!(x > 0.0)) return 0;
    return x < 1.0 ? static_cast<int>(255.0 * x) : 255;
}

/// floor(x) of x limited to [0, most]; NaN gives 0.
constexpr int cut_within(double x, int most) {
    if (!(x > 0.0)) return 0;
    return x < most ? static_cast<int>(x) : most;
}

}  // namespace twofold
