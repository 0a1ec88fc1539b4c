#pragma once
#include "tests/platforms/named_hash.hpp"
#include "texunit/presets.hpp"

/// Random input in a preset's formats.
namespace twofold::platforms {

/// All presets, `custom` with settings that no other has.
template <class Of>
Hashes over_presets(const Of& of) {
    CustomSettings custom;
    custom.filter_weight_bits = 5;
    custom.filter_rounding = FilterRounding::once;
    custom.register_bits = 12;
    custom.product_rounding = ProductRounding::floor;
    Hashes hashes;
    for (const Preset preset : all_presets)
        append(hashes, with_model(preset, [&](const auto& m) { return of(m); }));
    append(hashes, with_model(Preset::custom, custom, [&](const auto& m) { return of(m); }));
    return hashes;
}

/// A channel in [0, 1] of the preset.
template <NumericModel M>
typename M::Channel channel(const M& m, std::size_t i, std::size_t place) {
    return m.constant(real(i, place, -0.05, 1.05));
}

/// The same with a sign.
template <NumericModel M>
typename M::Channel signed_channel(const M& m, std::size_t i, std::size_t place) {
    const auto c = channel(m, i, place);
    return integer(i, place + 32, 0, 1) == 0 ? c : m.negate(c);
}

template <NumericModel M>
Color<typename M::Channel> color(const M& m, std::size_t i, std::size_t place) {
    return {channel(m, i, place), channel(m, i, place + 1), channel(m, i, place + 2),
            channel(m, i, place + 3)};
}

template <NumericModel M>
Color<typename M::Pixel> pixel(const M& m, std::size_t i, std::size_t place) {
    const auto one = [&](std::size_t k) { return m.pixel(real(i, place + k, -0.05, 1.05)); };
    return {one(0), one(1), one(2), one(3)};
}

/// A fraction in [0, 1) in the format in which the preset iterates coordinates.
template <NumericModel M>
typename M::Real fraction(const M&, std::size_t i, std::size_t place) {
    return static_cast<typename M::Real>(real(i, place, 0.0, 0.999));
}

inline std::vector<Rgba8> random_texels(std::uint64_t seed, std::size_t count) {
    std::vector<Rgba8> texels;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t word = random_u32(seed, i);
        const auto byte = [word](int k) { return static_cast<std::uint8_t>(word >> 8 * k); };
        texels.push_back({byte(0), byte(1), byte(2), byte(3)});
    }
    return texels;
}

/// "stage/preset/what".
template <NumericModel M>
std::string preset_name(const char* stage, const M&, std::string_view what) {
    return fmt::format("{}/{}/{}", stage, name_of(M::preset), what);
}

}  // namespace twofold::platforms
