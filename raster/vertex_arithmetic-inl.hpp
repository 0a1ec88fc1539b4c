// The arithmetics of the vertex stage on vectors, compiled once for each instruction set: no
// #pragma once.
#include "raster/lane_math-inl.hpp"
#include "texunit/nv1x_seeds.hpp"

#if defined(TWOFOLD_VERTEX_ARITHMETIC) == defined(HWY_TARGET_TOGGLE)
#ifdef TWOFOLD_VERTEX_ARITHMETIC
#undef TWOFOLD_VERTEX_ARITHMETIC
#else
#define TWOFOLD_VERTEX_ARITHMETIC
#endif

HWY_BEFORE_NAMESPACE();
namespace twofold::lanes {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE V set(double x) { return hn::Set(D(), x); }
HWY_INLINE V masked(V v, std::uint64_t bits) {
    return hn::BitCast(D(), hn::And(hn::BitCast(U(), v), hn::Set(U(), bits)));
}

/// IeeeArithmetic<double>.
struct Binary64 {
    static constexpr bool sums_products = false;
    static HWY_INLINE V word(V x) { return x; }
    static HWY_INLINE V mul(V a, V b) { return hn::Mul(a, b); }
    static HWY_INLINE V sum(V a, V b) { return hn::Add(a, b); }
    static HWY_INLINE V sum(V a, V b, V c) { return hn::Add(hn::Add(a, b), c); }
    static HWY_INLINE V sum(V a, V b, V c, V d) { return hn::Add(sum(a, b, c), d); }
    static HWY_INLINE V reciprocal(V a) { return hn::Div(set(1.0), a); }
    static HWY_INLINE V clip_reciprocal(V w) { return reciprocal(w); }
    static HWY_INLINE V emitted_reciprocal(V rw) { return rw; }
    static HWY_INLINE V reciprocal_sqrt(V a) { return hn::Div(set(1.0), hn::Sqrt(a)); }
    static HWY_INLINE V reflect(V scaled, V e, bool) { return hn::Sub(scaled, e); }
    static HWY_INLINE Mask wild(V) { return hn::FirstN(D(), 0); }
};

/// IeeeArithmetic<float>: every operation of two binary32 numbers in binary64, rounded to binary32
/// afterwards, gives what binary32 gives (2 x 24 + 2 <= 53).
struct Binary32 {
    static constexpr bool sums_products = false;
    static HWY_INLINE V word(V x) {
        const hn::Rebind<float, D> narrow;
        return hn::PromoteTo(D(), hn::DemoteTo(narrow, x));
    }
    static HWY_INLINE V mul(V a, V b) { return word(hn::Mul(a, b)); }
    static HWY_INLINE V sum(V a, V b) { return word(hn::Add(a, b)); }
    static HWY_INLINE V sum(V a, V b, V c) { return sum(sum(a, b), c); }
    static HWY_INLINE V sum(V a, V b, V c, V d) { return sum(sum(a, b, c), d); }
    static HWY_INLINE V reciprocal(V a) { return word(hn::Div(set(1.0), a)); }
    static HWY_INLINE V clip_reciprocal(V w) { return reciprocal(w); }
    static HWY_INLINE V emitted_reciprocal(V rw) { return rw; }
    static HWY_INLINE V reciprocal_sqrt(V a) { return reciprocal(word(hn::Sqrt(a))); }
    static HWY_INLINE V reflect(V scaled, V e, bool) { return sum(scaled, hn::Neg(e)); }
    static HWY_INLINE Mask wild(V) { return hn::FirstN(D(), 0); }
};

inline constexpr std::uint64_t to_24_bits = ~((std::uint64_t{1} << 29) - 1);
inline constexpr std::uint64_t exponent_bits = std::uint64_t{0x7ff} << 52;
inline constexpr double least_normal = 0x1p-126, largest_finite = 0x1.fffffep127;

/// texunit/nv1x_arithmetic.hpp for finite words, held in binary64: products of two words are exact
/// there, and cutting to 24 bits is a mask.
struct Nv1x {
    /// 0 times anything is +0, and so is a sum of zeros: terms of 0 can be left out.
    static constexpr bool sums_products = true;
    /// Cut toward zero; too small gives 0, too large the largest number.
    static HWY_INLINE V composed(V exact) {
        const V cut = masked(exact, to_24_bits);
        const V held = hn::Min(hn::Max(cut, set(-largest_finite)), set(largest_finite));
        return hn::IfThenZeroElse(hn::Lt(hn::Abs(held), set(least_normal)), held);
    }
    static HWY_INLINE V word(V x) { return x; }
    static HWY_INLINE V mul(V a, V b) { return composed(hn::Mul(a, b)); }

    /// 2^floor(log2 |a|) of a nonzero number, and 1 over it.
    static HWY_INLINE V power(V a) { return masked(a, exponent_bits); }
    static HWY_INLINE V over_power(V power) {
        const U u;
        return hn::BitCast(D(),
                           hn::Sub(hn::Set(u, std::uint64_t{2046} << 52), hn::BitCast(u, power)));
    }

    /// The terms cut to a common unit, 2^-28 of the largest's power of two.
    template <class... Terms>
    static HWY_INLINE V sum_of(V most, Terms... terms) {
        const V p = power(hn::Max(most, set(least_normal)));
        const V units = hn::Mul(over_power(p), set(0x1p28));
        V total = set(0.0);
        ((total = hn::Add(total, hn::Trunc(hn::Mul(terms, units)))), ...);
        return composed(hn::Mul(total, hn::Mul(p, set(0x1p-28))));
    }
    static HWY_INLINE V larger(V a, V b) { return hn::Max(hn::Abs(a), hn::Abs(b)); }

    /// The sum of the products a[k] b[k]. Where the largest is far from both ends of the range no
    /// product and no sum needs its limits: one below 2^-126 is cut off by the common unit.
    template <std::size_t N>
    static HWY_INLINE V sum_of_products(const std::array<V, N>& a, const std::array<V, N>& b) {
        return over_terms(std::make_index_sequence<N>(), a, b);
    }
    template <std::size_t N, std::size_t... K>
    static HWY_INLINE V over_terms(std::index_sequence<K...>, const std::array<V, N>& a,
                                   const std::array<V, N>& b) {
        const std::array<V, N> exact{hn::Mul(a[K], b[K])...};
        V most = hn::Abs(exact[0]);
        ((most = hn::Max(most, hn::Abs(exact[K]))), ...);
        const D d;
        const Mask moderate =
            hn::Or(hn::And(hn::Gt(most, set(0x1p-90)), hn::Lt(most, set(0x1p120))),
                   hn::Eq(most, hn::Zero(d)));
        if (HWY_UNLIKELY(!hn::AllTrue(d, moderate)))
            return sum_of(most_of(composed(exact[K])...), composed(exact[K])...);
        const V p = power(hn::Max(most, set(least_normal)));
        const V units = hn::Mul(over_power(p), set(0x1p28));
        V total = set(0.0);
        ((total = hn::Add(total, hn::Trunc(hn::Mul(masked(exact[K], to_24_bits), units)))), ...);
        return masked(hn::Mul(total, hn::Mul(p, set(0x1p-28))), to_24_bits);
    }
    template <class... Terms>
    static HWY_INLINE V most_of(Terms... terms) {
        V most = set(0.0);
        ((most = hn::Max(most, hn::Abs(terms))), ...);
        return most;
    }
    static HWY_INLINE V sum(V a, V b, V c, V d) {
        return sum_of(hn::Max(larger(a, b), larger(c, d)), a, b, c, d);
    }
    static HWY_INLINE V sum(V a, V b, V c) {
        return sum_of(hn::Max(larger(a, b), hn::Abs(c)), a, b, c);
    }
    static HWY_INLINE V sum(V a, V b) { return sum_of(larger(a, b), a, b); }

    /// The first six bits behind the leading one.
    static HWY_INLINE hn::Vec<hn::RebindToSigned<D>> seed_index(V a) {
        const U u;
        const auto bits = hn::And(hn::ShiftRight<46>(hn::BitCast(u, a)), hn::Set(u, 63));
        return hn::BitCast(hn::RebindToSigned<D>(), bits);
    }

    /// A seed of 7 bits and two Newton steps; all integers here are below 2^53.
    static HWY_INLINE V reciprocal_from(const double* seeds, V a) {
        const V over = over_power(power(a));
        const V m = hn::Mul(hn::Mul(hn::Abs(a), over), set(0x1p23));
        const V t = hn::GatherIndex(D(), seeds, seed_index(a));
        const V y1 =
            hn::Floor(hn::Mul(hn::Mul(hn::Sub(set(0x1p31), hn::Mul(t, m)), t), set(0x1p-24)));
        const V y2 =
            hn::Floor(hn::Mul(hn::Mul(hn::Sub(set(0x1p37), hn::Mul(y1, m)), y1), set(0x1p-25)));
        const Mask whole = hn::Eq(m, set(0x1p23));
        const V significand = hn::IfThenElse(whole, set(0x1p24), y2);
        return composed(hn::CopySign(hn::Mul(hn::Mul(significand, set(0x1p-24)), over), a));
    }
    static HWY_INLINE V reciprocal(V a) {
        return reciprocal_from(nv1x::reciprocal_seeds_f64.data(), a);
    }

    /// The exponent held within 2^-64 and 2^64, the fraction kept; 1/0 is 2^64.
    static HWY_INLINE V clip_reciprocal(V w) {
        const Mask zero = hn::Eq(w, hn::Zero(D()));
        const V r = reciprocal(hn::IfThenElse(zero, set(1.0), w));
        const V magnitude = hn::Abs(r);
        const V fraction = hn::Or(masked(magnitude, ~exponent_bits), set(1.0));
        V held = hn::IfThenElse(hn::Lt(magnitude, set(0x1p-64)), hn::Mul(fraction, set(0x1p-64)),
                                magnitude);
        held = hn::IfThenElse(hn::Ge(magnitude, set(0x1p65)), hn::Mul(fraction, set(0x1p64)), held);
        return hn::CopySign(hn::IfThenElse(zero, set(0x1p64), held), w);
    }
    static HWY_INLINE V emitted_reciprocal(V rw) {
        return masked(rw, ~((std::uint64_t{1} << 37) - 1));
    }

    static HWY_INLINE V reciprocal_sqrt_from(const double* seeds, V a) {
        const U u;
        const V p = power(a);
        // 2^(e - 127) with e even is an odd power: the argument is doubled and the power halved.
        const auto biased = hn::ShiftRight<52>(hn::BitCast(u, p));
        const auto odd_power =
            hn::BitCast(D(), hn::Sub(hn::Zero(u), hn::And(hn::Not(biased), hn::Set(u, 1))));
        const V m = hn::Mul(hn::Mul(hn::Mul(hn::Abs(a), over_power(p)), set(0x1p23)),
                            hn::IfVecThenElse(odd_power, set(2.0), set(1.0)));
        const auto row = hn::And(hn::BitCast(u, odd_power), hn::Set(u, 64));
        const auto index = hn::Add(seed_index(a), hn::BitCast(hn::RebindToSigned<D>(), row));
        const V t = hn::GatherIndex(D(), seeds, index);
        const V y1 = hn::Floor(
            hn::Mul(hn::Mul(hn::Sub(set(0x3p37), hn::Mul(hn::Mul(t, t), m)), t), set(0x1p-32)));
        // The last product has 64 bits: in two parts, each exact.
        const V rest = hn::Sub(set(0x3p49), hn::Mul(hn::Mul(y1, y1), m));
        const V high = hn::Floor(hn::Mul(rest, set(0x1p-26)));
        const V low = hn::Sub(rest, hn::Mul(high, set(0x1p26)));
        const V y2 = hn::Floor(
            hn::Mul(hn::Add(hn::Mul(high, y1), hn::Floor(hn::Mul(hn::Mul(low, y1), set(0x1p-26)))),
                    set(0x1p-13)));
        // compose(0, 126 - half, y2) with half = floor((e - 127) / 2).
        const auto half =
            hn::ShiftRight<1>(hn::Add(biased, hn::Set(u, 1)));  // floor((E-1023)/2)+512
        const V over_root =
            hn::BitCast(D(), hn::ShiftLeft<52>(hn::Sub(hn::Set(u, 1023 + 512), half)));
        return composed(hn::Mul(hn::Mul(y2, set(0x1p-24)), over_root));
    }
    static HWY_INLINE V reciprocal_sqrt(V a) {
        return reciprocal_sqrt_from(nv1x::root_seeds_f64.data(), a);
    }
    static HWY_INLINE V reflect(V scaled, V e, bool is_z) {
        if (!is_z) return sum(scaled, hn::Neg(e));
        return sum(sum(sum(scaled, set(1.0)), hn::Neg(e)), set(-1.0));
    }
    /// What reciprocals and roots have an infinity for.
    static HWY_INLINE Mask wild(V a) { return hn::Eq(a, hn::Zero(D())); }
};

/// The reciprocals of NV2x.
struct Nv2x : Nv1x {
    static HWY_INLINE V reciprocal(V a) {
        return reciprocal_from(nv1x::rounded_reciprocal_seeds_f64.data(), a);
    }
    /// An exponent that is held loses its fraction.
    static HWY_INLINE V clip_reciprocal(V w) {
        const Mask zero = hn::Eq(w, hn::Zero(D()));
        const V r = hn::Abs(reciprocal(hn::IfThenElse(zero, set(1.0), w)));
        V held = hn::IfThenElse(hn::Lt(r, set(0x1p-64)), set(0x1p-64), r);
        held = hn::IfThenElse(hn::Or(zero, hn::Ge(r, set(0x1p65))), set(0x1p64), held);
        return hn::CopySign(held, w);
    }
    static HWY_INLINE V emitted_reciprocal(V rw) { return rw; }
    static HWY_INLINE V reciprocal_sqrt(V a) {
        return reciprocal_sqrt_from(nv1x::rounded_root_seeds_f64.data(), a);
    }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace twofold::lanes
HWY_AFTER_NAMESPACE();
#endif
