#pragma once
#include <fmt/format.h>

#include <array>
#include <concepts>
#include <string>
#include <vector>

#include "texunit/fnv1a.hpp"
#include "texunit/numeric_model.hpp"
#include "texunit/random.hpp"

/// Hashes of what each stage computes from random input. The stage is the name's first word, so
/// that a platform that differs says where.
namespace twofold::platforms {

struct NamedHash {
    std::string name;  ///< stage/what/of what
    std::uint64_t value;
};

using Hashes = std::vector<NamedHash>;

inline void append(Hashes& to, Hashes more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

inline void feed(Fnv1a& hash, double x) { hash.f64(x); }
inline void feed(Fnv1a& hash, float x) { hash.f32(x); }

template <std::integral Integer>
void feed(Fnv1a& hash, Integer x) {
    hash.u64(static_cast<std::uint64_t>(x));
}

inline void feed(Fnv1a& hash, const Vec2& v) { hash.f64(v.x).f64(v.y); }
inline void feed(Fnv1a& hash, const Vec3& v) { hash.f64(v.x).f64(v.y).f64(v.z); }
inline void feed(Fnv1a& hash, const Vec4& v) { hash.f64(v.x).f64(v.y).f64(v.z).f64(v.w); }
inline void feed(Fnv1a& hash, const Rgba8& c) { hash.u8(c.r).u8(c.g).u8(c.b).u8(c.a); }

template <class T>
void feed(Fnv1a& hash, const std::vector<T>& values);

template <class T, std::size_t n>
void feed(Fnv1a& hash, const std::array<T, n>& values) {
    for (const T& value : values) feed(hash, value);
}

template <class T>
void feed(Fnv1a& hash, const std::vector<T>& values) {
    for (const T& value : values) feed(hash, value);
}

/// Of one value, or of all values of a list.
template <class T>
NamedHash hash_of(std::string name, const T& value) {
    Fnv1a hash;
    feed(hash, value);
    return {std::move(name), hash.value()};
}

/// Of result(0) to result(count - 1).
template <class Result>
NamedHash hash_over(std::string name, std::size_t count, const Result& result) {
    Fnv1a hash;
    for (std::size_t i = 0; i < count; ++i) feed(hash, result(i));
    return {std::move(name), hash.value()};
}

/// Number `place` of the inputs of item i, uniform in [low, high).
inline double real(std::size_t i, std::size_t place, double low, double high) {
    return low + (high - low) * random_unit(place, i);
}

/// Number `place` of the inputs of item i, low to high, both included.
inline int integer(std::size_t i, std::size_t place, int low, int high) {
    return low +
           static_cast<int>(random_u64(place, i) % static_cast<std::uint64_t>(high - low + 1));
}

// One function a file. @param threads  what the stages that have threads are given
Hashes number_hashes();
Hashes function_hashes();
Hashes vertex_hashes();
Hashes direction_hashes();
Hashes channel_hashes();
Hashes environment_hashes();
Hashes combiner_hashes();
Hashes texture_hashes();
Hashes lookup_hashes();
Hashes fragment_hashes();
Hashes triangle_hashes();
Hashes frame_hashes(int threads);
Hashes light_hashes(int threads);
Hashes system_hashes(int threads);
Hashes map_hashes(int threads);

}  // namespace twofold::platforms
