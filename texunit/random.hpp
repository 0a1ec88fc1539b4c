#pragma once
#include <cstdint>

/// Random numbers by counter: number `index` of sequence `seed` is a function of the two and
/// nothing else, so any thread can draw any number, and no order of drawing matters. Not for
/// secrets.
/// @source G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators,
/// OOPSLA 2014, with S. Vigna's constants (splitmix64): indices 0, 1, 2 ... give the outputs of
/// splitmix64 in turn.
namespace twofold {

/// 64 uniform bits.
constexpr std::uint64_t random_u64(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

/// 32 uniform bits.
constexpr std::uint32_t random_u32(std::uint64_t seed, std::uint64_t index) {
    return static_cast<std::uint32_t>(random_u64(seed, index) >> 32);
}

/// Uniform in [0, 1): a multiple of 2^-53.
constexpr double random_unit(std::uint64_t seed, std::uint64_t index) {
    return static_cast<double>(random_u64(seed, index) >> 11) * 0x1p-53;
}

}  // namespace twofold
