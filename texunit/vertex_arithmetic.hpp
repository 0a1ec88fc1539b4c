#pragma once
#include <cmath>

namespace twofold {

/// The operations of the vertex stage in an IEEE format: each is rounded once, to nearest, and sums
/// run left to right. Nv1xArithmetic has the same operations with that chip's rounding.
template <class Float>
struct IeeeArithmetic {
    using Word = Float;

    static Word from_double(double x) { return static_cast<Float>(x); }
    static double to_double(Word x) { return static_cast<double>(x); }
    static Word negate(Word a) { return -a; }
    static Word mul(Word a, Word b) { return a * b; }
    static Word sum(Word a, Word b) { return a + b; }
    static Word sum(Word a, Word b, Word c) { return a + b + c; }
    static Word sum(Word a, Word b, Word c, Word d) { return a + b + c + d; }
    static Word reciprocal(Word a) { return Float{1} / a; }
    static Word clip_reciprocal(Word w) { return Float{1} / w; }
    /// 1/w as the iterators get it.
    static Word emitted_reciprocal(Word rw) { return rw; }
    static Word reciprocal_sqrt(Word a) { return Float{1} / std::sqrt(a); }

    /// r = 2 (n.e) n - e for the unit vector e from the vertex to the eye, component by component:
    /// `scaled` is n_i times 2 (n.e).
    static Word reflect(Word scaled, Word e, bool) { return scaled - e; }
};

}  // namespace twofold
