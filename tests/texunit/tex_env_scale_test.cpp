#include <catch2/catch.hpp>

#include "tests/texunit/laws.hpp"
#include "texunit/tex_env.hpp"

/// When a texture environment scales and clamps.
using namespace twofold;
using laws::m;

TEMPLATE_TEST_CASE(
    "C02 MODULATE with RGB_SCALE is the product, scaled and clamped, but alpha is not "
    "scaled",
    "[hard][C02]", Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    for (const int scale : {1, 2, 4}) {
        TexEnv env;
        env.rgb_scale = scale;
        int unlike = 0;
        for (int a = 0; a < 256; ++a)
            for (int b = 0; b < 256; b += 3) {
                const auto x = static_cast<std::uint8_t>(a), y = static_cast<std::uint8_t>(b);
                const auto f = m<M>.texel(Rgba8{x, x, x, x}), t = m<M>.texel(Rgba8{y, y, y, y});
                const auto result = apply_tex_env(m<M>, env, f, BaseFormat::rgba, f, t, f);
                const auto product = m<M>.modulate(f[0], t[0]);
                unlike += result[0] != (scale == 1 ? product : m<M>.scale(product, scale));
                unlike += result[3] != product;
            }
        CHECK(unlike == 0);
    }
}

TEST_CASE("C02 ADD_SIGNED with scale 4: real presets do it, the chips do it with 2",
          "[hard][C02]") {
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = CombineFunction::add_signed;
    env.rgb_scale = 4;
    const auto red = [&]<NumericModel M>(const M& model, std::uint8_t a, std::uint8_t b) {
        const auto f = model.texel(Rgba8{a, a, a, a}), t = model.texel(Rgba8{b, b, b, b});
        return static_cast<double>(apply_tex_env(model, env, f, BaseFormat::rgba, f, t, f)[0]);
    };
    CHECK(red(Nv17{}, 100, 60) == 64);
    CHECK(red(Nv2x{}, 100, 60) == 64);
    CHECK(red(Custom{}, 100, 60) == 64);
    CHECK(red(Coarse8{}, 100, 60) == 128);
    CHECK(red(Ideal64{}, 100, 60) == Approx(4 * (160 / 255.0 - 0.5)));
    CHECK(red(Nv17{}, 200, 200) == 255);
}

TEMPLATE_TEST_CASE("C03 sums above 1 are clamped once, after the scale", "[hard][C03]", Nv2x,
                   Nv17) {
    using M = TestType;
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = CombineFunction::subtract;
    env.rgb_scale = 2;
    const auto f = m<M>.texel(Rgba8{40, 100, 255, 0}), t = m<M>.texel(Rgba8{250, 200, 0, 255});
    CHECK(apply_tex_env(m<M>, env, f, BaseFormat::rgba, f, t, f)[0] == 255);
    CHECK(apply_tex_env(m<M>, env, f, BaseFormat::rgba, f, t, f)[1] == 200);
    CHECK(apply_tex_env(m<M>, env, f, BaseFormat::rgba, f, t, f)[2] == 0);
    env.mode = TexEnvMode::add;
    CHECK(apply_tex_env(m<M>, env, f, BaseFormat::rgba, f, t, f)[0] == 255);
}
