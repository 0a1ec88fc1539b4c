#include "texunit/self_check.hpp"

#include "texunit/ieee_guard.hpp"

namespace twofold {
namespace {

// Every operand passes through a volatile, or the compiler would do the sum by its own arithmetic
// and the processor would never be asked.
template <class T>
T opaque(T value) {
    const volatile T hidden = value;
    return hidden;
}

/// Rounded to T after the product, x * x + y is exactly 0; a fused multiply-add gives the rounding
/// error.
template <class T>
bool contracts(T x, T y) {
    const T a = opaque(x);
    const T b = opaque(y);
    return a * a + b != T{0};
}

/// Each sum is a tie that only rounding to nearest, ties to even, takes to where it is expected.
bool rounds_otherwise() {
    const double half_step = opaque(0x1p-53);
    const double up = opaque(1.0) + half_step;
    const double down = opaque(-1.0) - half_step;
    const double tie_to_even = opaque(1.0 + 0x1p-52) + half_step;
    return up != 1.0 || down != -1.0 || tie_to_even != 1.0 + 0x1p-51;
}

/// Half of the least normal number is a denormal, unless the processor flushes results to zero.
template <class T>
bool flushes_results(T least_normal) {
    return opaque(least_normal) * opaque(T{0.5}) == T{0};
}

/// The least denormal raised to 1 in two steps; it stays 0 where the processor takes denormals for
/// zeros.
template <class T>
bool ignores_denormals(T least_denormal, T first, T second) {
    return opaque(opaque(least_denormal) * opaque(first)) * opaque(second) != T{1};
}

void append(std::string& list, bool broken, const char* name) {
    if (!broken) return;
    if (!list.empty()) list += ", ";
    list += name;
}

}  // namespace

std::string floating_point_defects() {
    std::string list;
    append(list,
           contracts(1.0 + 0x1p-27, -(1.0 + 0x1p-26)) ||
               contracts(1.0f + 0x1p-12f, -(1.0f + 0x1p-11f)),
           "contraction");
    append(list, rounds_otherwise(), "rounding mode");
    append(list, flushes_results(0x1p-1022) || flushes_results(0x1p-126f), "flush to zero");
    append(list,
           ignores_denormals(0x1p-1074, 0x1p+1000, 0x1p+74) ||
               ignores_denormals(0x1p-149f, 0x1p+100f, 0x1p+49f),
           "denormals are zero");
    return list;
}

}  // namespace twofold
