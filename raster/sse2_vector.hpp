#pragma once
#include <emmintrin.h>
#include <hwy/base.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

/// Vectors of Highway's for any x86-64 processor, under its names: Highway 1.0.3 has none below
/// SSSE3 but portable ones, each operation a loop over an array. Here are tags, vectors and memory;
/// sse2_lanes.hpp has the operations.
namespace twofold::lanes::sse2 {
// NOLINTBEGIN(readability-identifier-naming): the names are Highway's.

/// A number of lanes of one type, at most 16 bytes.
template <class T, std::size_t N>
struct Tag {
    using Lane = T;
    static constexpr std::size_t lanes = N, bytes = N * sizeof(T);
};

template <class D>
using TFromD = typename D::Lane;
template <class T>
using ScalableTag = Tag<T, 16 / sizeof(T)>;
template <class T, std::size_t most>
using CappedTag = Tag<T, std::min(16 / sizeof(T), most)>;
template <class T, class D>
using Rebind = Tag<T, D::lanes>;
template <class T, class D>
using Repartition = Tag<T, D::bytes / sizeof(T)>;
template <class D>
using Half = Tag<TFromD<D>, D::lanes / 2>;

template <class T>
using SignedOf = std::conditional_t<sizeof(T) == 8, std::int64_t,
                                    std::conditional_t<sizeof(T) == 4, std::int32_t, std::int16_t>>;
template <class D>
using RebindToSigned = Rebind<SignedOf<TFromD<D>>, D>;
template <class D>
using RebindToUnsigned = Rebind<std::make_unsigned_t<SignedOf<TFromD<D>>>, D>;

/// Sixteen bytes as lanes of one type: the compiler knows + - * / and shifts of them.
template <class T>
struct Register {
    using Raw __attribute__((vector_size(16))) = T;
};
template <class T>
using Raw = typename Register<T>::Raw;

/// Lanes behind the last hold anything.
template <class T, std::size_t N>
struct Vector {
    using Lane = T;
    Raw<T> raw;
};
/// All bits of a lane that holds are ones.
template <class T, std::size_t N>
struct Lanewise {
    using Lane = T;
    Raw<T> raw;
};

template <class D>
using Vec = Vector<TFromD<D>, D::lanes>;
template <class D>
using Mask = Lanewise<TFromD<D>, D::lanes>;

template <class D>
HWY_INLINE std::size_t Lanes(D) {
    return D::lanes;
}
template <class D>
constexpr std::size_t MaxLanes(D) {
    return D::lanes;
}

template <class To, class From>
HWY_INLINE Raw<To> as(From raw) {
    return reinterpret_cast<Raw<To>>(raw);
}
/// As the intrinsics of integers take it.
template <class V>
HWY_INLINE __m128i ints(V v) {
    return reinterpret_cast<__m128i>(v.raw);
}
template <class V>
HWY_INLINE V from_ints(__m128i bits) {
    return {as<typename V::Lane>(bits)};
}

template <class To, class T, std::size_t N>
HWY_INLINE Vec<To> BitCast(To, Vector<T, N> v) {
    return {as<TFromD<To>>(v.raw)};
}
template <class To, class T, std::size_t N>
HWY_INLINE Mask<To> RebindMask(To, Lanewise<T, N> m) {
    return {as<TFromD<To>>(m.raw)};
}
template <class T, std::size_t N>
HWY_INLINE Vector<T, N> VecFromMask(Tag<T, N>, Lanewise<T, N> m) {
    return {m.raw};
}
template <class T, std::size_t N>
HWY_INLINE Lanewise<T, N> MaskFromVec(Vector<T, N> v) {
    return {v.raw};
}

// ------------------------------------------------------------------------------ memory, constants

template <class D>
HWY_INLINE Vec<D> LoadU(D, const TFromD<D>* p) {
    const auto* const from = reinterpret_cast<const __m128i*>(p);
    return from_ints<Vec<D>>(D::bytes == 8 ? _mm_loadl_epi64(from) : _mm_loadu_si128(from));
}
template <class D>
HWY_INLINE Vec<D> Load(D d, const TFromD<D>* p) {
    if constexpr (D::bytes < 16) return LoadU(d, p);
    return from_ints<Vec<D>>(_mm_load_si128(reinterpret_cast<const __m128i*>(p)));
}
template <class D>
HWY_INLINE void StoreU(Vec<D> v, D, TFromD<D>* p) {
    if constexpr (D::bytes == 16) {
        _mm_storeu_si128(reinterpret_cast<__m128i*>(p), ints(v));
    } else {
        const std::int64_t low = _mm_cvtsi128_si64(ints(v));
        std::memcpy(p, &low, D::bytes);
    }
}
template <class D>
HWY_INLINE void Store(Vec<D> v, D d, TFromD<D>* p) {
    StoreU(v, d, p);
}

template <class D>
HWY_INLINE Vec<D> Set(D, TFromD<D> x) {
    if constexpr (std::is_same_v<TFromD<D>, double>)
        return {_mm_set1_pd(x)};
    else if constexpr (std::is_same_v<TFromD<D>, float>)
        return {_mm_set1_ps(x)};
    else
        return {Raw<TFromD<D>>{} + x};
}
template <class D>
HWY_INLINE Vec<D> Zero(D d) {
    return Set(d, TFromD<D>{});
}
template <class D>
HWY_INLINE Vec<D> Iota(D d, TFromD<D> first) {
    Vec<D> v = Zero(d);
    for (std::size_t i = 0; i < D::lanes; ++i) v.raw[i] = first + static_cast<TFromD<D>>(i);
    return v;
}
template <class D>
HWY_INLINE Mask<D> FirstN(D, std::size_t n) {
    static constexpr std::array<std::int64_t, 4> ones_then_zeros{-1, -1, 0, 0};
    const auto* const ones = reinterpret_cast<const char*>(ones_then_zeros.data());
    const std::size_t bytes = std::min(n * sizeof(TFromD<D>), std::size_t{16});
    return from_ints<Mask<D>>(_mm_loadu_si128(reinterpret_cast<const __m128i*>(ones + 16 - bytes)));
}

/// Of four lanes of 32 bits.
template <class T, class I>
HWY_INLINE Vector<T, 4> GatherIndex(Tag<T, 4>, const T* base, Vector<I, 4> at) {
    const std::int64_t low = _mm_cvtsi128_si64(ints(at));
    const std::int64_t high = _mm_cvtsi128_si64(_mm_unpackhi_epi64(ints(at), ints(at)));
    return {Raw<T>{base[static_cast<std::int32_t>(low)], base[low >> 32],
                   base[static_cast<std::int32_t>(high)], base[high >> 32]}};
}
template <class T>
HWY_INLINE Vector<T, 2> GatherIndex(Tag<T, 2>, const T* base, Vector<std::int64_t, 2> at) {
    return {Raw<T>{base[at.raw[0]], base[at.raw[1]]}};
}
/// Lane after lane.
template <class T, std::size_t N>
HWY_INLINE void ScatterIndex(Vector<T, N> v, Tag<T, N>, T* base, Vector<std::int32_t, N> at) {
    for (std::size_t i = 0; i < N; ++i) base[at.raw[i]] = v.raw[i];
}
template <class T, std::size_t N>
HWY_INLINE T GetLane(Vector<T, N> v) {
    return v.raw[0];
}
// NOLINTEND(readability-identifier-naming)
}  // namespace twofold::lanes::sse2
