#include "texunit/tex_env_lowering.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "texunit/combiner.hpp"
#include "texunit/error.hpp"
#include "texunit/presets.hpp"
#include "texunit/random.hpp"
#include "texunit/tex_env.hpp"

/// Lowered combiners against the environments themselves, bit for bit.
namespace {
using namespace twofold;

constexpr std::array all_formats{
    BaseFormat::alpha,     BaseFormat::luminance, BaseFormat::luminance_alpha,
    BaseFormat::intensity, BaseFormat::rgb,       BaseFormat::rgba};
constexpr std::array<int, 10> grid{0, 1, 37, 64, 127, 128, 191, 200, 254, 255};

template <NumericModel M>
const M m{};

Vec4 vector_of(const Color<int>& c) { return Vec4{c[0], c[1], c[2], c[3]} / 255.0; }

/// Bytes on the grid; `lane` tells colours of one fragment apart.
Color<int> grid_color(std::uint64_t fragment, std::uint64_t lane) {
    std::uint64_t r = random_u64(852, 8 * fragment + lane);
    Color<int> c{};
    for (int& e : c) {
        e = grid[r % grid.size()];
        r /= grid.size();
    }
    return c;
}

template <NumericModel M>
Color<int> by_environments(const std::vector<UnitEnvironment>& units, const CombinerInputs<M>& in) {
    Color<int> color = in.primary;
    for (const UnitEnvironment& u : units)
        color = apply_tex_env(m<M>, u.env, constant_color(m<M>, u.env.color), u.format, color,
                              in.texture[u.unit], in.primary);
    return color;
}

/// On how many of some hundred fragments the two ways differ.
template <NumericModel M>
int differences(std::vector<UnitEnvironment> units, std::uint64_t fragments) {
    int unlike = 0;
    for (std::uint64_t i = 0; i < fragments; ++i) {
        CombinerInputs<M> in{};
        in.primary = grid_color(i, 0);
        for (std::size_t u = 0; u < max_units; ++u) in.texture[u] = grid_color(i, 1 + u);
        for (auto& u : units) u.env.color = vector_of(grid_color(i + u.unit, 5));
        const auto combined = run_combiners(m<M>, lowered(units, M::combiner_stages), in);
        unlike += combined != by_environments(units, in);
    }
    return unlike;
}

CombineArgument argument(std::uint64_t& r, bool of_alpha) {
    const auto source = static_cast<CombineSource>(r % 4);
    const auto operand = static_cast<CombineOperand>(of_alpha ? 2 + r / 4 % 2 : r / 4 % 4);
    r /= 16;
    return {source, operand};
}

TexEnv random_combine(std::uint64_t i) {
    std::uint64_t r = random_u64(924, i);
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = static_cast<CombineFunction>(r % 8);
    env.combine_alpha = static_cast<CombineFunction>(r / 8 % 6);
    env.rgb_scale = 1 << (r / 64 % 3);
    env.alpha_scale = 1 << (r / 256 % 3);
    // One stage has one scale for a dot product and what of it goes to alpha.
    if (env.combine_rgb == CombineFunction::dot3_rgba) env.alpha_scale = env.rgb_scale;
    r /= 4096;
    for (auto& a : env.rgb) a = argument(r, false);
    for (auto& a : env.alpha) a = argument(r, true);
    return env;
}

UnitEnvironment dot3_rgba(std::size_t unit) {
    TexEnv env;
    env.mode = TexEnvMode::combine;
    env.combine_rgb = CombineFunction::dot3_rgba;
    return {unit, env, BaseFormat::rgba};
}

std::string lowering_error(const std::vector<UnitEnvironment>& units, int stages) {
    try {
        lowered(units, stages);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}
}  // namespace

TEMPLATE_TEST_CASE("each mode with each base format is one stage that computes the same",
                   "[lowering]", Nv2x, Nv17) {
    using M = TestType;
    for (const auto mode : {TexEnvMode::replace, TexEnvMode::modulate, TexEnvMode::decal,
                            TexEnvMode::blend, TexEnvMode::add})
        for (const BaseFormat format : all_formats)
            for (const int scale : {1, 2, 4}) {
                TexEnv env;
                env.mode = mode;
                env.rgb_scale = scale;
                const std::vector<UnitEnvironment> one{{0, env, format}};
                const std::vector<UnitEnvironment> two{{0, TexEnv{}, BaseFormat::rgba},
                                                       {1, env, format}};
                CHECK(lowered(one, 1).stages.size() == 1);
                CAPTURE(static_cast<int>(mode), static_cast<int>(format), scale);
                CHECK(differences<M>(one, 1000) == 0);
                CHECK(differences<M>(two, 1000) == 0);
            }
}

TEMPLATE_TEST_CASE(
    "COMBINE of all functions, sources, operands and scales computes the same in "
    "one or two stages",
    "[lowering]", Nv2x, Nv17) {
    using M = TestType;
    for (std::uint64_t i = 0; i < 6000; ++i) {
        const TexEnv env = random_combine(i);
        const std::vector<UnitEnvironment> one{{i % 2, env, BaseFormat::rgba}};
        const std::vector<UnitEnvironment> two{{0, TexEnv{}, BaseFormat::rgba},
                                               {1, env, all_formats[i % 6]}};
        if (differences<M>(one, 20) + differences<M>(two, 20) != 0) FAIL_CHECK(i);
    }
}

TEST_CASE("four units on nv2x compute the same, DOT3_RGBA among them", "[lowering]") {
    for (std::uint64_t i = 0; i < 3000; ++i) {
        std::vector<UnitEnvironment> units;
        for (std::size_t u = 0; u < 4; ++u)
            units.push_back({u, random_combine(4 * i + u), all_formats[(i + u) % 6]});
        if (differences<Nv2x>(units, 10) != 0) FAIL_CHECK(i);
    }
}

TEST_CASE("products of all pairs of bytes are the same in a combiner and an environment",
          "[lowering]") {
    const auto state = lowered(std::vector<UnitEnvironment>{{0, TexEnv{}, BaseFormat::rgba}}, 2);
    int unlike = 0;
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b) {
            CombinerInputs<Nv17> in{};
            in.primary = {a, a, a, a};
            in.texture[0] = {b, b, b, b};
            unlike += run_combiners(Nv17{}, state, in) !=
                      Color<int>{mul_rn(a, b), mul_rn(a, b), mul_rn(a, b), mul_rn(a, b)};
        }
    CHECK(unlike == 0);
}

TEST_CASE("DOT3_RGBA takes a second stage unless it is last", "[lowering]") {
    CHECK(lowered(std::vector{dot3_rgba(0)}, 2).stages.size() == 1);
    UnitEnvironment uneven = dot3_rgba(1);
    uneven.env.alpha_scale = 2;
    CHECK(lowering_error({uneven}, 2) ==
          "texture unit 1: DOT3_RGBA with rgb_scale 1 and alpha_scale 2 does not fit one combiner "
          "stage");
    CHECK(lowered(std::vector{dot3_rgba(0), dot3_rgba(1)}, 8).stages.size() == 3);
    CHECK(lowering_error({dot3_rgba(0), dot3_rgba(1)}, 2) ==
          "texture unit 1: its environment needs general combiner stage 3, but there are 2");
}

TEST_CASE("more units than stages are refused by the unit's number", "[lowering]") {
    const UnitEnvironment modulate{2, TexEnv{}, BaseFormat::rgba};
    CHECK(lowering_error({modulate, modulate, modulate}, 2) ==
          "texture unit 2: its environment needs general combiner stage 3, but there are 2");
    CHECK(lowering_error({modulate, modulate}, 2).empty());
}

TEST_CASE("without units the primary colour is shown", "[lowering]") {
    CombinerInputs<Nv17> in{};
    in.primary = {1, 2, 3, 4};
    const auto state = lowered({}, 2);
    CHECK(state.stages.size() == 1);
    CHECK(run_combiners(Nv17{}, state, in) == in.primary);
}

TEST_CASE("two stages share two constants", "[lowering]") {
    TexEnv blend;
    blend.mode = TexEnvMode::blend;
    blend.color = Vec4{0.25, 0.5, 0.75, 1.0};
    const auto state = lowered(
        std::vector<UnitEnvironment>{{0, blend, BaseFormat::rgb}, {1, blend, BaseFormat::rgb}}, 2);
    CHECK(state.stages[0].constant_color0 == blend.color);
    CHECK(state.stages[1].constant_color1 == blend.color);
    CHECK(state.stages[1].rgb.input[0].source == CombinerRegister::constant_color1);
}
