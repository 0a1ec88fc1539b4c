#pragma once
#include <cstdint>

#include "factor/solver.hpp"

/// What the solvers share: vectors of binary64 with every sum in the fixed order of
/// docs/exactness.md, section 3. A vector that is passed by value and moved in becomes the result:
/// those of an iteration are too many for the caches, and fresh memory is the slowest.
namespace twofold {

/// Sum of a_i b_i, in fixed order.
double dot(const Vector& a, const Vector& b);

/// Sum of a_i, in fixed order.
double total(const Vector& a);

/// Euclidean length, in fixed order.
double norm(const Vector& a);

/// a + f b.
Vector plus_scaled(Vector a, double f, const Vector& b);

/// f a + g b.
Vector combined(double f, const Vector& a, double g, Vector b);

/// a - b.
Vector minus(const Vector& a, const Vector& b);

/// f a.
Vector scaled(double f, Vector a);

/// a / f, one rounding an element.
Vector divided(Vector a, double f);

/// The largest |a_i|, 0 for an empty vector.
double largest_magnitude(const Vector& a);

/// Whether no element is NaN or infinite.
bool all_finite(const Vector& a);

/// Exponent e with 2^e <= |x| < 2^(e+1); 0 for x = 0. Exact, also for denormals.
int binary_exponent(double x);

/// x 2^e, rounded once at most; overflow gives infinity.
double times_power_of_two(double x, int e);

/// Every element times 2^e.
Vector times_power_of_two(const Vector& a, int e);

}  // namespace twofold
