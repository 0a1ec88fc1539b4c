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

/// (p (256 - w) + q w) / 256, halves rounded up; w in 0..255.
constexpr int flerp(int p, int q, int w) { return (p * (256 - w) + q * w + 128) >> 8; }

/// floor(255 x + 1/2) of x limited to [0, 1]; NaN gives 0.
/// @source OpenGL 1.3, 2.13.9
constexpr int rn8(double x) {
    if (!(x > 0.0)) return 0;
    return x < 1.0 ? static_cast<int>(255.0 * x + 0.5) : 255;
}

}  // namespace twofold
