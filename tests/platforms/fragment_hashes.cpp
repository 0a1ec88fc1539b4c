#include "raster/fragment_ops.hpp"
#include "tests/platforms/preset_input.hpp"

namespace twofold::platforms {
namespace {

template <NumericModel M>
NamedHash blend_hash(const M& m, const std::string& what, const Blend& blend) {
    const auto constant = pixel(m, 0, 30);
    return hash_over(preset_name("blend", m, what), 64, [&](std::size_t i) {
        return blended(m, blend, {pixel(m, i, 1), pixel(m, i, 5), constant});
    });
}

template <NumericModel M>
Hashes blend_hashes(const M& m) {
    Hashes hashes;
    for (int factor = 0; factor < 15; ++factor) {
        Blend blend;
        blend.source = static_cast<BlendFactor>(factor);
        blend.destination = static_cast<BlendFactor>((factor * 4 + 3) % 14);
        hashes.push_back(blend_hash(m, fmt::format("factor-{}", factor), blend));
    }
    for (int equation = 1; equation < 5; ++equation)
        hashes.push_back(blend_hash(m, fmt::format("equation-{}", equation),
                                    {BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha,
                                     static_cast<BlendEquation>(equation), Vec4{0.0}}));
    return hashes;
}

template <NumericModel M>
Hashes pixel_hashes(const M& m) {
    const auto over = [&](const char* stage, const std::string& what, const auto& result) {
        return hash_over(preset_name(stage, m, what), 256, result);
    };
    const auto p = [&](std::size_t i) { return m.pixel(real(i, 1, -0.05, 1.05)); };
    Hashes hashes{over("pixel", "byte", [&](std::size_t i) { return m.to_unorm8(p(i)); }),
                  over("pixel", "real", [&](std::size_t i) { return m.to_real(p(i)); })};
    for (const int bits : {16, 24})
        hashes.push_back(over("depth", fmt::format("{}-bits", bits), [&](std::size_t i) {
            return m.depth(real(i, 1, -0.01, 1.01), bits);
        }));
    for (int bits = 5; bits <= 8; ++bits) {
        hashes.push_back(over("pixel", fmt::format("cut-{}-bits", bits),
                              [&](std::size_t i) { return m.quantise(p(i), bits); }));
        hashes.push_back(over("pixel", fmt::format("dither-{}-bits", bits), [&](std::size_t i) {
            return m.add_dither(p(i), bits, integer(i, 2, 0, 15));
        }));
    }
    return hashes;
}

}  // namespace

Hashes fragment_hashes() {
    return over_presets([](const auto& m) {
        Hashes hashes = blend_hashes(m);
        append(hashes, pixel_hashes(m));
        return hashes;
    });
}

}  // namespace twofold::platforms
