#include "texunit/tex_env.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string_view>

#include "tests/texunit/laws.hpp"
#include "texunit/random.hpp"

/// Texture environments against the tables of OpenGL 1.3 written out as formulas in binary64.
namespace {
using namespace twofold;
using laws::m;
using Values = std::array<double, 4>;

constexpr std::array all_modes{TexEnvMode::replace, TexEnvMode::modulate, TexEnvMode::decal,
                               TexEnvMode::blend, TexEnvMode::add};
constexpr std::array all_formats{
    BaseFormat::alpha,     BaseFormat::luminance, BaseFormat::luminance_alpha,
    BaseFormat::intensity, BaseFormat::rgb,       BaseFormat::rgba};
constexpr std::array all_functions{CombineFunction::replace,     CombineFunction::modulate,
                                   CombineFunction::add,         CombineFunction::add_signed,
                                   CombineFunction::interpolate, CombineFunction::subtract,
                                   CombineFunction::dot3_rgb,    CombineFunction::dot3_rgba};

/// Tables 3.21 and 3.22: for each format (A L LA I RGB RGBA) a letter for colour and one for alpha:
/// f incoming, t texture, m product, b blend with the constant, a sum, d decal; ? not defined.
constexpr std::array<std::string_view, 5> tables{"ft tf tt tt tf tt",   // REPLACE
                                                 "fm mf mm mm mf mm",   // MODULATE
                                                 "?? ?? ?? ?? tf df",   // DECAL
                                                 "fm bf bm bb bf bm",   // BLEND
                                                 "fm af am aa af am"};  // ADD

struct Case {
    Values texture, constant, primary, previous;
};

double table_value(char letter, const Case& in, std::size_t k) {
    const double f = in.previous[k], t = in.texture[k], c = in.constant[k], at = in.texture[3];
    switch (letter) {
        case 'f':
            return f;
        case 't':
            return t;
        case 'm':
            return f * t;
        case 'b':
            return f * (1 - t) + c * t;
        case 'a':
            return std::min(1.0, f + t);
        default:
            return f * (1 - at) + t * at;
    }
}

Values table_result(TexEnvMode mode, std::size_t format, const Case& in) {
    const auto letters = tables[static_cast<std::size_t>(mode)].substr(3 * format, 2);
    return {table_value(letters[0], in, 0), table_value(letters[0], in, 1),
            table_value(letters[0], in, 2), table_value(letters[1], in, 3)};
}

/// Tables 3.24 to 3.26.
double argument(const CombineArgument& arg, const Case& in, std::size_t k) {
    const std::array<const Values*, 4> sources{&in.texture, &in.constant, &in.primary,
                                               &in.previous};
    const Values& v = *sources[static_cast<std::size_t>(arg.source)];
    const auto operand = static_cast<int>(arg.operand);
    const double e = operand >= 2 ? v[3] : v[k];
    return operand % 2 == 1 ? 1 - e : e;
}

double dot3(const TexEnv& env, const Case& in) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
        sum += (argument(env.rgb[0], in, k) - 0.5) * (argument(env.rgb[1], in, k) - 0.5);
    return 4 * sum;
}

double function_value(CombineFunction f, const TexEnv& env,
                      const std::array<CombineArgument, 3>& args, const Case& in, std::size_t k) {
    const double a = argument(args[0], in, k), b = argument(args[1], in, k);
    const double c = argument(args[2], in, k);
    const std::array<double, 8> values{
        a, a * b, a + b, a + b - 0.5, a * c + b * (1 - c), a - b, dot3(env, in), dot3(env, in)};
    return values[static_cast<std::size_t>(f)];
}

Values combine_result(const TexEnv& env, const Case& in) {
    Values result{};
    for (std::size_t k = 0; k < 4; ++k) {
        const bool rgb = k < 3 || env.combine_rgb == CombineFunction::dot3_rgba;
        const double x = function_value(rgb ? env.combine_rgb : env.combine_alpha, env,
                                        rgb ? env.rgb : env.alpha, in, k);
        result[k] = std::clamp(x * (k < 3 ? env.rgb_scale : env.alpha_scale), 0.0, 1.0);
    }
    return result;
}

/// Bytes that a format can hold, in the places where the environment looks.
Rgba8 kept(BaseFormat format, Rgba8 t) {
    switch (format) {
        case BaseFormat::alpha:
            return {0, 0, 0, t.a};
        case BaseFormat::luminance:
            return {t.r, t.r, t.r, 255};
        case BaseFormat::luminance_alpha:
            return {t.r, t.r, t.r, t.a};
        case BaseFormat::intensity:
            return {t.r, t.r, t.r, t.r};
        case BaseFormat::rgb:
            return {t.r, t.g, t.b, 255};
        case BaseFormat::rgba:
            break;
    }
    return t;
}

/// Every fourth byte is 0 or 255, so that the ends meet everything.
Rgba8 random_bytes(std::uint64_t index) {
    const std::uint64_t r = random_u64(1303, index);
    const auto byte = [r](int k) {
        const auto v = static_cast<std::uint8_t>(r >> (8 * k));
        const auto choice = (r >> (32 + 4 * k)) & 7;
        return choice == 0 ? std::uint8_t{0} : (choice == 1 ? std::uint8_t{255} : v);
    };
    return {byte(0), byte(1), byte(2), byte(3)};
}

Values values_of(Rgba8 c) { return {c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0}; }

template <NumericModel M>
Values applied(const TexEnv& env, BaseFormat format, const std::array<Rgba8, 4>& c) {
    const auto result = apply_tex_env(m<M>, env, m<M>.texel(c[1]), format, m<M>.texel(c[3]),
                                      m<M>.texel(c[0]), m<M>.texel(c[2]));
    Values v{};
    for (std::size_t k = 0; k < 4; ++k)
        v[k] = static_cast<double>(result[k]) / static_cast<double>(m<M>.one());
    return v;
}

/// Texel, constant, primary and previous colour of one random fragment.
std::array<Rgba8, 4> random_fragment(BaseFormat format, std::uint64_t i) {
    return {kept(format, random_bytes(4 * i)), random_bytes(4 * i + 1), random_bytes(4 * i + 2),
            random_bytes(4 * i + 3)};
}

Case case_of(const std::array<Rgba8, 4>& c) {
    return {values_of(c[0]), values_of(c[1]), values_of(c[2]), values_of(c[3])};
}

double worst_difference(const Values& a, const Values& b) {
    double worst = 0;
    for (std::size_t k = 0; k < 4; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
    return worst;
}

/// How far a model may be from the formula at scale 1: rounding of one result (real models: of a
/// few operations); coarse8 loses up to 2 steps a product, of which there are at most 3.
template <NumericModel M>
double allowed() {
    if (std::is_same_v<M, Coarse8>) return 6.0 / 255.0;
    if (M::is_integer) return 0.5 / 255.0 + 1e-12;
    return std::is_same_v<typename M::Channel, float> ? 1e-6 : 1e-12;
}

/// A COMBINE environment drawn at random; alpha operands are those of alpha.
TexEnv random_combine(CombineFunction f, std::uint64_t i) {
    std::uint64_t r = random_u64(315, i);
    const auto draw = [&r](std::uint64_t n) {
        const std::uint64_t k = r % n;
        r /= n;
        return k;
    };
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = f;
    env.combine_alpha = all_functions[draw(6)];
    for (std::size_t k = 0; k < 3; ++k) {
        env.rgb[k] = {static_cast<CombineSource>(draw(4)), static_cast<CombineOperand>(draw(4))};
        env.alpha[k] = {static_cast<CombineSource>(draw(4)),
                        static_cast<CombineOperand>(2 + draw(2))};
    }
    env.rgb_scale = 1 << draw(3);
    env.alpha_scale = 1 << draw(3);
    return env;
}

/// Scale 4 of ADD_SIGNED is another matter on chips that do it with 2.
bool has_fault(const TexEnv& env) {
    const auto signed_by_4 = [](CombineFunction f, int scale) {
        return f == CombineFunction::add_signed && scale == 4;
    };
    return signed_by_4(env.combine_rgb, env.rgb_scale) ||
           signed_by_4(env.combine_alpha, env.alpha_scale);
}
}  // namespace

TEMPLATE_TEST_CASE("every mode does with every base format what the tables say", "[tex_env]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    for (const TexEnvMode mode : all_modes)
        for (std::size_t f = 0; f < 6; ++f) {
            if (mode == TexEnvMode::decal && f < 4) continue;
            TexEnv env;
            env.mode = mode;
            double worst = 0;
            for (std::uint64_t i = 0; i < 3000; ++i) {
                const auto c = random_fragment(all_formats[f], i);
                worst = std::max(worst, worst_difference(applied<M>(env, all_formats[f], c),
                                                         table_result(mode, f, case_of(c))));
            }
            CAPTURE(static_cast<int>(mode), f);
            CHECK(worst <= allowed<M>());
        }
}

TEMPLATE_TEST_CASE(
    "every function of COMBINE does with all sources, operands and scales what the "
    "tables say",
    "[tex_env]", Ideal64, Float32, Gl13, Nv2x, Nv17, Coarse8, Custom) {
    using M = TestType;
    for (const CombineFunction f : all_functions) {
        double worst = 0;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const TexEnv env = random_combine(f, i);
            if (m<M>.add_signed_scale(4) != 4 && has_fault(env)) continue;
            const BaseFormat format = all_formats[i % 6];
            const auto c = random_fragment(format, i);
            const Values expected = combine_result(env, case_of(c)),
                         got = applied<M>(env, format, c);
            for (std::size_t k = 0; k < 4; ++k) {
                const bool rgb = k < 3 || f == CombineFunction::dot3_rgba;
                const auto function = rgb ? f : env.combine_alpha;
                // half a step more for 128 in place of 127.5
                const double bias =
                    M::is_integer && function == CombineFunction::add_signed ? 0.5 / 255.0 : 0.0;
                const double limit =
                    (allowed<M>() + bias) * (k < 3 ? env.rgb_scale : env.alpha_scale);
                worst = std::max(worst, std::abs(got[k] - expected[k]) / limit);
            }
        }
        CAPTURE(static_cast<int>(f));
        CHECK(worst <= 1.0);
    }
}

TEST_CASE("DECAL passes on what OpenGL does not define", "[tex_env]") {
    TexEnv env;
    env.mode = TexEnvMode::decal;
    const Color<int> f{10, 20, 30, 40}, t{50, 50, 50, 50};
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(apply_tex_env(Nv17{}, env, t, all_formats[k], f, t, f) == f);
}
