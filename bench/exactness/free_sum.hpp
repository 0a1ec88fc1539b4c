#pragma once
#include <cstddef>

namespace price {

/// Sum of a_i b_i from left to right.
double sequential_sum(const double* a, const double* b, std::size_t n);

/// The same in whatever order the compiler likes best: compiled with -ffast-math.
double free_sum(const double* a, const double* b, std::size_t n);

}  // namespace price
