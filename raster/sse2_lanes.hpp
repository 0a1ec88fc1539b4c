#pragma once
#include "raster/sse2_vector.hpp"

/// The operations of Highway that the vector loops call, under its names, on SSE2's vectors. What
/// is narrower than Highway's is said where it stands.
namespace twofold::lanes::sse2 {
// NOLINTBEGIN(readability-identifier-naming): the names are Highway's.

template <class V>
inline constexpr bool holds_f64 = std::is_same_v<typename V::Lane, double>;
template <class V>
inline constexpr bool holds_f32 = std::is_same_v<typename V::Lane, float>;

// ------------------------------------------------------------------------------------------- bits

template <class V>
HWY_INLINE V And(V a, V b) {
    return from_ints<V>(_mm_and_si128(ints(a), ints(b)));
}
template <class V>
HWY_INLINE V Or(V a, V b) {
    return from_ints<V>(_mm_or_si128(ints(a), ints(b)));
}
template <class V>
HWY_INLINE V Not(V a) {
    return from_ints<V>(_mm_xor_si128(ints(a), _mm_set1_epi32(-1)));
}
template <int bits, class V>
HWY_INLINE V ShiftLeft(V a) {
    return {a.raw << bits};
}
template <int bits, class V>
HWY_INLINE V ShiftRight(V a) {
    return {a.raw >> bits};
}
template <class V>
HWY_INLINE V ShiftRightSame(V a, int bits) {
    return {a.raw >> bits};
}

template <class V>
HWY_INLINE V IfVecThenElse(V m, V yes, V no) {
    return from_ints<V>(
        _mm_or_si128(_mm_and_si128(ints(m), ints(yes)), _mm_andnot_si128(ints(m), ints(no))));
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> IfThenElse(Lanewise<T, N> m, Vector<T, N> yes, Vector<T, N> no) {
    return IfVecThenElse(Vector<T, N>{m.raw}, yes, no);
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> IfThenElseZero(Lanewise<T, N> m, Vector<T, N> yes) {
    return And(Vector<T, N>{m.raw}, yes);
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> IfThenZeroElse(Lanewise<T, N> m, Vector<T, N> no) {
    return from_ints<Vector<T, N>>(_mm_andnot_si128(ints(m), ints(no)));
}

template <class T, std::size_t N>
HWY_INLINE Vector<T, N> CopySign(Vector<T, N> magnitude, Vector<T, N> sign) {
    return IfVecThenElse(Set(Tag<T, N>(), -T{0}), sign, magnitude);
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> Abs(Vector<T, N> a) {
    return CopySign(a, Zero(Tag<T, N>()));
}

// ------------------------------------------------------------------------------------- comparisons

template <class T, std::size_t N>
HWY_INLINE Lanewise<T, N> Lt(Vector<T, N> a, Vector<T, N> b) {
    using M = Lanewise<T, N>;
    if constexpr (holds_f64<M>)
        return {_mm_cmplt_pd(a.raw, b.raw)};
    else if constexpr (holds_f32<M>)
        return {_mm_cmplt_ps(a.raw, b.raw)};
    else
        return from_ints<M>(_mm_cmplt_epi32(ints(a), ints(b)));
}
template <class T, std::size_t N>
HWY_INLINE Lanewise<T, N> Eq(Vector<T, N> a, Vector<T, N> b) {
    using M = Lanewise<T, N>;
    if constexpr (holds_f64<M>)
        return {_mm_cmpeq_pd(a.raw, b.raw)};
    else if constexpr (holds_f32<M>)
        return {_mm_cmpeq_ps(a.raw, b.raw)};
    const __m128i equal = _mm_cmpeq_epi32(ints(a), ints(b));
    if constexpr (sizeof(T) == 4) return from_ints<M>(equal);
    return from_ints<M>(_mm_and_si128(equal, _mm_shuffle_epi32(equal, 0xb1)));
}
template <class T, std::size_t N>
HWY_INLINE Lanewise<T, N> Ne(Vector<T, N> a, Vector<T, N> b) {
    return Not(Eq(a, b));
}
HWY_INLINE Lanewise<double, 2> Le(Vector<double, 2> a, Vector<double, 2> b) {
    return {_mm_cmple_pd(a.raw, b.raw)};
}
template <class V>
HWY_INLINE auto Gt(V a, V b) {
    return Lt(b, a);
}
template <class V>
HWY_INLINE auto Ge(V a, V b) {
    return Le(b, a);
}

/// A bit for each lane of 32 or 64 bits.
template <class T, std::size_t N>
HWY_INLINE unsigned bits_of(Lanewise<T, N> m) {
    const int bits =
        sizeof(T) == 8 ? _mm_movemask_pd(as<double>(m.raw)) : _mm_movemask_ps(as<float>(m.raw));
    return static_cast<unsigned>(bits) & ((1u << N) - 1);
}
template <class T, std::size_t N>
HWY_INLINE bool AllTrue(Tag<T, N>, Lanewise<T, N> m) {
    return bits_of(m) == (1u << N) - 1;
}
template <class T, std::size_t N>
HWY_INLINE bool AllFalse(Tag<T, N>, Lanewise<T, N> m) {
    return bits_of(m) == 0;
}
template <class T, std::size_t N>
HWY_INLINE std::size_t CountTrue(Tag<T, N>, Lanewise<T, N> m) {
    const unsigned bits = bits_of(m), pairs = (bits & 5) + (bits >> 1 & 5);
    return (pairs & 3) + (pairs >> 2);
}

/// Writes a whole vector.
HWY_INLINE void CompressStore(Vector<double, 2> v, Lanewise<double, 2> m, Tag<double, 2>,
                              double* p) {
    const Lanewise<double, 2> first{_mm_unpacklo_pd(m.raw, m.raw)};
    const Vector<double, 2> upper{_mm_unpackhi_pd(v.raw, v.raw)};
    _mm_storeu_pd(p, IfThenElse(first, v, upper).raw);
}
/// Writes a whole vector: each pair is closed up by itself.
HWY_INLINE void CompressStore(Vector<std::int32_t, 4> v, Lanewise<std::int32_t, 4> m,
                              Tag<std::int32_t, 4>, std::int32_t* p) {
    using V = Vector<std::int32_t, 4>;
    const V first = from_ints<V>(_mm_shuffle_epi32(ints(m), 0xa0));
    const __m128i closed = ints(IfVecThenElse(first, v, from_ints<V>(_mm_srli_epi64(ints(v), 32))));
    const unsigned bits = bits_of(m);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p), closed);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(p + (bits & 1) + (bits >> 1 & 1)),
                     _mm_unpackhi_epi64(closed, closed));
}

// ------------------------------------------------------------------------------------- arithmetic

/// What + - * of a type are done in: integers wrap around.
template <class T>
using Wrapping = typename std::conditional_t<std::is_integral_v<T>, std::make_unsigned<T>,
                                             std::type_identity<T>>::type;

template <class T, std::size_t N>
HWY_INLINE Vector<T, N> Add(Vector<T, N> a, Vector<T, N> b) {
    return {as<T>(as<Wrapping<T>>(a.raw) + as<Wrapping<T>>(b.raw))};
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> Sub(Vector<T, N> a, Vector<T, N> b) {
    return {as<T>(as<Wrapping<T>>(a.raw) - as<Wrapping<T>>(b.raw))};
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> Mul(Vector<T, N> a, Vector<T, N> b) {
    return {as<T>(as<Wrapping<T>>(a.raw) * as<Wrapping<T>>(b.raw))};
}
/// small_product() of lane_math-inl.hpp: the upper halves are 0.
HWY_INLINE Vector<std::int32_t, 4> small_product(Vector<std::int32_t, 4> a,
                                                 Vector<std::int32_t, 4> b) {
    return from_ints<Vector<std::int32_t, 4>>(_mm_madd_epi16(ints(a), ints(b)));
}
template <class V>
HWY_INLINE V Div(V a, V b) {
    return {a.raw / b.raw};
}
template <class V>
HWY_INLINE V Neg(V a) {
    return {-a.raw};
}
HWY_INLINE Vector<std::uint16_t, 8> MulHigh(Vector<std::uint16_t, 8> a,
                                            Vector<std::uint16_t, 8> b) {
    return from_ints<Vector<std::uint16_t, 8>>(_mm_mulhi_epu16(ints(a), ints(b)));
}
HWY_INLINE Vector<double, 2> Sqrt(Vector<double, 2> a) { return {_mm_sqrt_pd(a.raw)}; }

/// Of real numbers, 32-bit integers, and unsigned ones of 16 bits.
template <class V>
HWY_INLINE V Min(V a, V b) {
    if constexpr (holds_f64<V>)
        return {_mm_min_pd(a.raw, b.raw)};
    else if constexpr (holds_f32<V>)
        return {_mm_min_ps(a.raw, b.raw)};
    else if constexpr (sizeof(typename V::Lane) == 4)
        return IfThenElse(Lt(b, a), b, a);
    else
        return Sub(a, from_ints<V>(_mm_subs_epu16(ints(a), ints(b))));
}
/// Of real numbers and 32-bit integers.
template <class V>
HWY_INLINE V Max(V a, V b) {
    if constexpr (holds_f64<V>)
        return {_mm_max_pd(a.raw, b.raw)};
    else if constexpr (holds_f32<V>)
        return {_mm_max_ps(a.raw, b.raw)};
    else
        return IfThenElse(Lt(a, b), b, a);
}

/// For |x| < 2^51 in binary64, 2^22 in binary32, where adding 1.5 times the first number without
/// fractions rounds to an integer. A zero is +0.
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> Floor(Vector<T, N> x) {
    const auto no_fractions = Set(Tag<T, N>(), sizeof(T) == 8 ? T{0x1.8p52} : T{0x1.8p23});
    const auto near = Sub(Add(x, no_fractions), no_fractions);
    return Sub(near, IfThenElseZero(Lt(x, near), Set(Tag<T, N>(), T{1})));
}
/// For |x| < 2^31. A zero is +0.
HWY_INLINE Vector<double, 2> Trunc(Vector<double, 2> x) {
    return {_mm_cvtepi32_pd(_mm_cvttpd_epi32(x.raw))};
}

// ------------------------------------------------------------------------ texels (shade_lanes.cpp)

HWY_INLINE std::array<Vector<std::uint64_t, 2>, 2> words_at(Tag<std::uint64_t, 2>,
                                                            const std::uint32_t* texels,
                                                            const std::int32_t* at) {
    const auto word = [&](std::size_t i) {
        return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(texels + at[i]));
    };
    const auto two = [&](std::size_t i) {
        return from_ints<Vector<std::uint64_t, 2>>(_mm_unpacklo_epi64(word(i), word(i + 1)));
    };
    return {two(0), two(2)};
}
HWY_INLINE Vector<std::uint16_t, 8> lower_for_both(Vector<std::uint32_t, 4> v) {
    return from_ints<Vector<std::uint16_t, 8>>(
        _mm_shufflehi_epi16(_mm_shufflelo_epi16(ints(v), 0xa0), 0xa0));
}
HWY_INLINE Vector<std::uint16_t, 8> upper_for_both(Vector<std::uint32_t, 4> v) {
    return from_ints<Vector<std::uint16_t, 8>>(
        _mm_shufflehi_epi16(_mm_shufflelo_epi16(ints(v), 0xf5), 0xf5));
}

// ----------------------------------------------------------------------------- parts, conversions

template <class D, class T>
HWY_INLINE Vec<D> LowerHalf(D, Vector<T, 4> v) {
    return {v.raw};
}
template <class D, class T>
HWY_INLINE Vec<D> UpperHalf(D, Vector<T, 4> v) {
    return from_ints<Vec<D>>(_mm_unpackhi_epi64(ints(v), ints(v)));
}
template <class T>
HWY_INLINE Vector<T, 4> Combine(Tag<T, 4>, Vector<T, 2> high, Vector<T, 2> low) {
    return from_ints<Vector<T, 4>>(_mm_unpacklo_epi64(ints(low), ints(high)));
}
template <class T>
HWY_INLINE Vector<T, 4> ConcatEven(Tag<T, 4>, Vector<T, 4> high, Vector<T, 4> low) {
    return {as<T>(_mm_shuffle_ps(as<float>(low.raw), as<float>(high.raw), 0x88))};
}
template <class T>
HWY_INLINE Vector<T, 4> ConcatOdd(Tag<T, 4>, Vector<T, 4> high, Vector<T, 4> low) {
    return {as<T>(_mm_shuffle_ps(as<float>(low.raw), as<float>(high.raw), 0xdd))};
}

HWY_INLINE Vector<double, 2> PromoteTo(Tag<double, 2>, Vector<std::int32_t, 2> v) {
    return {_mm_cvtepi32_pd(ints(v))};
}
HWY_INLINE Vector<double, 2> PromoteTo(Tag<double, 2>, Vector<float, 2> v) {
    return {_mm_cvtps_pd(v.raw)};
}
HWY_INLINE Vector<std::int64_t, 2> PromoteTo(Tag<std::int64_t, 2>, Vector<std::int32_t, 2> v) {
    return from_ints<Vector<std::int64_t, 2>>(
        _mm_unpacklo_epi32(ints(v), _mm_srai_epi32(ints(v), 31)));
}
HWY_INLINE Vector<float, 2> DemoteTo(Tag<float, 2>, Vector<double, 2> v) {
    return {_mm_cvtpd_ps(v.raw)};
}
/// Cut; -2^31 for what has no integer of 32 bits.
HWY_INLINE Vector<std::int32_t, 2> DemoteTo(Tag<std::int32_t, 2>, Vector<double, 2> v) {
    return from_ints<Vector<std::int32_t, 2>>(_mm_cvttpd_epi32(v.raw));
}
/// Limited to a byte's range.
template <std::size_t N>
HWY_INLINE Vector<std::uint8_t, N> DemoteTo(Tag<std::uint8_t, N>, Vector<std::int32_t, N> v) {
    const __m128i words = _mm_packs_epi32(ints(v), ints(v));
    return from_ints<Vector<std::uint8_t, N>>(_mm_packus_epi16(words, words));
}
template <std::size_t N>
HWY_INLINE Vector<std::int32_t, N> ConvertTo(Tag<std::int32_t, N>, Vector<float, N> v) {
    return from_ints<Vector<std::int32_t, N>>(_mm_cvttps_epi32(v.raw));
}

// NOLINTEND(readability-identifier-naming)
}  // namespace twofold::lanes::sse2
