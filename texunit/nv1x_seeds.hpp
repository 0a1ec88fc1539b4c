#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

/// The seed tables of the NV1x and NV2x reciprocals: 7 bits each, by the first six bits of the
/// argument's fraction.
/// @source public NV1x model of envytools, restated as formulas
namespace twofold::nv1x {

/// floor(128 / (1 + (i + 1/2) / 64)).
constexpr std::array<std::uint64_t, 64> make_reciprocal_seeds() {
    std::array<std::uint64_t, 64> seeds{};
    for (std::uint64_t i = 0; i < 64; ++i) seeds[i] = 16384 / (129 + 2 * i);
    return seeds;
}

/// floor(128 / sqrt(1 + (i + 1/2) / 64)), then the same with the argument doubled: the largest T
/// with T^2 x argument <= 128^2.
constexpr std::array<std::uint64_t, 128> make_root_seeds() {
    std::array<std::uint64_t, 128> seeds{};
    for (std::uint64_t i = 0; i < 128; ++i) {
        const std::uint64_t argument = (129 + 2 * (i & 63)) << (i >> 6);  // in units of 1/128
        std::uint64_t t = 128;
        while (t * t * argument > 16384 * 128) --t;
        seeds[i] = t;
    }
    return seeds;
}

/// floor(128 / (1 + (i + 1/2) / 64) + 1/2).
constexpr std::array<std::uint64_t, 64> make_rounded_reciprocal_seeds() {
    std::array<std::uint64_t, 64> seeds{};
    for (std::uint64_t i = 0; i < 64; ++i) {
        const std::uint64_t argument = 129 + 2 * i;
        seeds[i] = (2 * 16384 + argument) / (2 * argument);
    }
    return seeds;
}

/// The root seeds rounded: the largest T up to 127 with (T - 1/2)^2 x argument <= 128^2.
constexpr std::array<std::uint64_t, 128> make_rounded_root_seeds() {
    std::array<std::uint64_t, 128> seeds{};
    for (std::uint64_t i = 0; i < 128; ++i) {
        const std::uint64_t argument = (129 + 2 * (i & 63)) << (i >> 6);  // in units of 1/128
        std::uint64_t t = 127;
        while ((2 * t - 1) * (2 * t - 1) * argument > 4 * 16384 * 128) --t;
        seeds[i] = t;
    }
    return seeds;
}

using ReciprocalSeeds = std::array<std::uint64_t, 64>;
using RootSeeds = std::array<std::uint64_t, 128>;

inline constexpr ReciprocalSeeds reciprocal_seeds = make_reciprocal_seeds();
inline constexpr ReciprocalSeeds rounded_reciprocal_seeds = make_rounded_reciprocal_seeds();
inline constexpr RootSeeds root_seeds = make_root_seeds();
inline constexpr RootSeeds rounded_root_seeds = make_rounded_root_seeds();

/// The tables for arithmetic in binary64.
template <std::size_t N>
constexpr std::array<double, N> as_f64(const std::array<std::uint64_t, N>& seeds) {
    std::array<double, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<double>(seeds[i]);
    return result;
}

inline constexpr auto reciprocal_seeds_f64 = as_f64(reciprocal_seeds);
inline constexpr auto rounded_reciprocal_seeds_f64 = as_f64(rounded_reciprocal_seeds);
inline constexpr auto root_seeds_f64 = as_f64(root_seeds);
inline constexpr auto rounded_root_seeds_f64 = as_f64(rounded_root_seeds);

}  // namespace twofold::nv1x
