#include "raster/fragment_ops.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "texunit/presets.hpp"

namespace {
using namespace twofold;

constexpr std::array all_functions{CompareFunc::never,  CompareFunc::less,    CompareFunc::equal,
                                   CompareFunc::lequal, CompareFunc::greater, CompareFunc::notequal,
                                   CompareFunc::gequal, CompareFunc::always};

/// Bit 0 lets "less" pass, bit 1 "equal", bit 2 "greater": OpenGL numbers its functions so.
bool passes(CompareFunc f, int incoming, int stored) {
    const int relation = incoming < stored ? 1 : (incoming == stored ? 2 : 4);
    return (static_cast<int>(f) & relation) != 0;
}

constexpr std::array all_factors{BlendFactor::zero,
                                 BlendFactor::one,
                                 BlendFactor::src_color,
                                 BlendFactor::one_minus_src_color,
                                 BlendFactor::dst_color,
                                 BlendFactor::one_minus_dst_color,
                                 BlendFactor::src_alpha,
                                 BlendFactor::one_minus_src_alpha,
                                 BlendFactor::dst_alpha,
                                 BlendFactor::one_minus_dst_alpha,
                                 BlendFactor::src_alpha_saturate};

/// Tables 4.1 and 4.2 in 255ths.
int factor_255(BlendFactor f, std::size_t c, const std::array<int, 4>& s,
               const std::array<int, 4>& d) {
    const std::array<int, 11> value{0,
                                    255,
                                    s[c],
                                    255 - s[c],
                                    d[c],
                                    255 - d[c],
                                    s[3],
                                    255 - s[3],
                                    d[3],
                                    255 - d[3],
                                    c == 3 ? 255 : std::min(s[3], 255 - d[3])};
    return value[static_cast<std::size_t>(f)];
}

template <NumericModel M>
Color<typename M::Pixel> pixels(const std::array<int, 4>& bytes) {
    return {M::pixel(bytes[0] / 255.0), M::pixel(bytes[1] / 255.0), M::pixel(bytes[2] / 255.0),
            M::pixel(bytes[3] / 255.0)};
}
}  // namespace

TEST_CASE("C05 the eight comparisons are right for all pairs of bytes", "[hard][C05]") {
    int wrong = 0;
    for (const CompareFunc f : all_functions)
        for (int a = 0; a < 256; ++a)
            for (int b = 0; b < 256; ++b) wrong += compare(f, a, b) != passes(f, a, b);
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("C05 alpha against a reference k/255 decides as bytes do", "[hard][C05]",
                   Ideal64, Float32, Gl13, Nv17) {
    using M = TestType;
    int wrong = 0;
    for (int ref = 0; ref < 256; ++ref) {
        const auto reference = M::pixel(ref / 255.0);
        for (int a = 0; a < 256; ++a) {
            const auto alpha = M::finish(M::texel(Rgba8{0, 0, 0, static_cast<std::uint8_t>(a)})[3]);
            for (const CompareFunc f : all_functions)
                wrong += compare(f, alpha, reference) != passes(f, a, ref);
        }
    }
    CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("a blend is s S + d D in one sum for all pairs of factors", "[blend]", Ideal64,
                   Float32, Gl13, Nv17) {
    using M = TestType;
    const std::array<std::array<int, 4>, 5> colors{{{0, 1, 127, 0},
                                                    {255, 254, 128, 255},
                                                    {10, 90, 200, 64},
                                                    {77, 33, 5, 128},
                                                    {250, 180, 60, 200}}};
    int wrong = 0;
    for (const auto& s : colors)
        for (const auto& d : colors)
            for (const BlendFactor sf : all_factors)
                for (const BlendFactor df : all_factors) {
                    const auto result = blended(M{}, {.source = sf, .destination = df},
                                                {pixels<M>(s), pixels<M>(d), {}});
                    for (std::size_t c = 0; c < 4; ++c) {
                        const int sum =
                            s[c] * factor_255(sf, c, s, d) + d[c] * factor_255(df, c, s, d);
                        const long nearest = std::min(255L, std::lround(sum / 255.0));
                        wrong += M::to_unorm8(result[c]) != nearest;
                    }
                }
    CHECK(wrong == 0);
}
