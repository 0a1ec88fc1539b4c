#pragma once
#include <cmath>
#include <vector>

#include "factor/solver.hpp"
#include "factor/vector_arithmetic.hpp"

namespace twofold::cases {

/// A small dense matrix for the solvers' tests; rows of equal length.
using Dense = std::vector<Vector>;

inline Dense transposed(const Dense& a) {
    Dense t(a.front().size(), Vector(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < t.size(); ++j) t[j][i] = a[i][j];
    }
    return t;
}

inline Vector product(const Dense& a, const Vector& x) {
    Vector y(a.size(), 0.0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < x.size(); ++j) y[i] += a[i][j] * x[j];
    }
    return y;
}

inline SquareOperator square_operator(const Dense& a) {
    double largest = 0.0;
    for (const Vector& row : a) {
        largest = largest < largest_magnitude(row) ? largest_magnitude(row) : largest;
    }
    return {[a](const Vector& x) { return product(a, x); },
            [t = transposed(a)](const Vector& x) { return product(t, x); }, largest};
}

inline RectangularOperator rectangular_operator(const Dense& a) {
    return {[a](const Vector& x) { return product(a, x); },
            [t = transposed(a)](const Vector& y) { return product(t, y); }};
}

}  // namespace twofold::cases
