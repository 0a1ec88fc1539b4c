#include "texunit/combiner.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "tests/texunit/laws.hpp"

/// The register combiners against values worked out by hand from the specification.
namespace {
using namespace twofold;
using laws::m;
using R = CombinerRegister;
using Map = CombinerMapping;
using Part = CombinerComponent;

constexpr CombinerInput one{R::zero, Part::rgb, Map::unsigned_invert};

constexpr CombinerInput rgb(R r, Map map = Map::unsigned_identity) { return {r, Part::rgb, map}; }
constexpr CombinerInput alpha(R r, Map map = Map::unsigned_identity) {
    return {r, Part::alpha, map};
}

/// Inputs from bytes: primary, secondary and texture 0 (grey r with its own alpha).
template <NumericModel M>
CombinerInputs<M> inputs(Rgba8 primary, Rgba8 secondary = {}, Rgba8 texture0 = {}) {
    CombinerInputs<M> in{};
    in.primary = m<M>.texel(primary);
    in.secondary = m<M>.texel(secondary);
    in.texture[0] = m<M>.texel(texture0);
    return in;
}

Rgba8 grey(int v, int a = 255) {
    const auto b = static_cast<std::uint8_t>(v);
    return {b, b, b, static_cast<std::uint8_t>(a)};
}

/// What is shown: the final colour as bytes.
template <NumericModel M>
std::array<int, 4> shown(const RegisterCombiners& state, const CombinerInputs<M>& in) {
    const auto c = run_combiners(m<M>, state, in);
    const auto byte = [](auto e) { return static_cast<int>(m<M>.to_unorm8(m<M>.finish(e))); };
    return {byte(c[0]), byte(c[1]), byte(c[2]), byte(c[3])};
}

/// One RGB stage that writes A B + C D to spare0, shown as it is; alpha is spare0's.
RegisterCombiners one_stage(std::array<CombinerInput, 4> input,
                            CombinerScale scale = CombinerScale::one, bool bias = false) {
    CombinerStage stage;
    stage.rgb.input = input;
    stage.rgb.sum_output = R::spare0;
    stage.rgb.scale = scale;
    stage.rgb.bias_by_negative_one_half = bias;
    RegisterCombiners state{{stage}, {}};
    state.final_stage.d = rgb(R::spare0);
    state.final_stage.g = alpha(R::spare0);
    return state;
}

/// @source hardware column of the mapping table, restated: max(0, e) is p
int mapped_byte(Map map, int e) {
    const int p = std::max(e, 0);
    const std::array<int, 8> table{p, 255 - p, 2 * p - 255, 255 - 2 * p, p - 128, 128 - p, e, -e};
    return table[static_cast<std::size_t>(map)];
}
constexpr std::array all_mappings{
    Map::unsigned_identity, Map::unsigned_invert,  Map::expand_normal,   Map::expand_negate,
    Map::half_bias_normal,  Map::half_bias_negate, Map::signed_identity, Map::signed_negate};
}  // namespace

TEMPLATE_TEST_CASE("C04 all 256 inputs, and their negatives, under the 8 mappings", "[hard][C04]",
                   Nv2x, Nv17, Custom) {
    using M = TestType;
    for (const Map map : all_mappings)
        for (int e = -255; e < 256; ++e) CHECK(mapped(m<M>, map, e) == mapped_byte(map, e));
}

TEMPLATE_TEST_CASE("C04 real presets map as the specification's table says", "[hard][C04]", Ideal64,
                   Float32, Gl13) {
    using M = TestType;
    using C = typename M::Channel;
    for (int k = -255; k < 256; ++k) {
        const C e = static_cast<C>(k) / C{255}, p = std::max(e, C{0});
        const std::array<C, 8> table{
            p, C{1} - p, 2 * p - C{1}, C{1} - 2 * p, p - C{0.5}, C{0.5} - p, e, -e};
        for (const Map map : all_mappings)
            CHECK(mapped(m<M>, map, e) == table[static_cast<std::size_t>(map)]);
    }
}

TEMPLATE_TEST_CASE("C04 a mapped value keeps its sign and no hidden fraction between stages",
                   "[hard][C04]", Nv2x, Nv17) {
    using M = TestType;
    for (const Map map : all_mappings)
        for (int e = 0; e < 256; ++e) {
            auto state = one_stage({rgb(R::primary_color, map), one});
            CHECK(shown<M>(state, inputs<M>(grey(e)))[0] == std::max(mapped_byte(map, e), 0));
            CombinerStage negate;
            negate.rgb.input = {rgb(R::spare0, Map::signed_negate), one};
            negate.rgb.ab_output = R::spare0;
            state.stages.push_back(negate);
            CHECK(shown<M>(state, inputs<M>(grey(e)))[0] == std::max(-mapped_byte(map, e), 0));
        }
}

TEMPLATE_TEST_CASE("C04 the bias is -128, so 255 becomes 127 and twice that 254", "[hard][C04]",
                   Nv2x, Nv17) {
    using M = TestType;
    for (int e = 0; e < 256; ++e) {
        const auto in = inputs<M>(grey(e));
        const auto biased = one_stage({rgb(R::primary_color), one}, CombinerScale::one, true);
        CHECK(shown<M>(biased, in)[0] == std::max(e - 128, 0));
        const auto twice = one_stage({rgb(R::primary_color), one}, CombinerScale::two, true);
        CHECK(shown<M>(twice, in)[0] == std::max(2 * e - 256, 0));
        const auto half = one_stage({rgb(R::primary_color), one}, CombinerScale::one_half);
        CHECK(shown<M>(half, in)[0] == (e + 1) / 2);
    }
    CHECK(M::scale_and_bias(255, CombinerScale::one, true) == 127);
    CHECK(M::scale_and_bias(255, CombinerScale::two, true) == 254);
    CHECK(M::scale_and_bias(0, CombinerScale::two, true) == -255);
}

TEMPLATE_TEST_CASE("C02 a stage saturates after its scale, for sums up to 510", "[hard][C02]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    const std::array scales{CombinerScale::one, CombinerScale::two, CombinerScale::four};
    for (int e = 0; e < 256; ++e)
        for (std::size_t s = 0; s < 3; ++s) {
            const auto single = one_stage({rgb(R::primary_color), one}, scales[s]);
            CHECK(shown<M>(single, inputs<M>(grey(e)))[0] == std::min(255, e << s));
            const auto twice =
                one_stage({rgb(R::primary_color), one, rgb(R::primary_color), one}, scales[s]);
            CHECK(shown<M>(twice, inputs<M>(grey(e)))[0] == std::min(255, 2 * e << s));
        }
}

TEMPLATE_TEST_CASE("C03 AB + CD reaches 510 and is clamped once, after the scale", "[hard][C03]",
                   Ideal64, Float32, Gl13, Nv2x, Nv17, Custom) {
    using M = TestType;
    const std::array<CombinerInput, 4> sum{rgb(R::primary_color), one, rgb(R::secondary_color),
                                           one};
    for (int a = 0; a < 256; a += 5)
        for (int b = 0; b < 256; b += 5) {
            const auto in = inputs<M>(grey(a), grey(b));
            CHECK(shown<M>(one_stage(sum), in)[0] == std::min(255, a + b));
            if (!M::is_integer && (a + b) % 2 == 1)
                continue;  // a tie that real numbers only nearly hit
            CHECK(shown<M>(one_stage(sum, CombinerScale::one_half), in)[0] == (a + b + 1) / 2);
        }
}

TEMPLATE_TEST_CASE("AB + CD is rounded once, AB and CD alone each for itself", "[combiner]", Nv2x,
                   Nv17) {
    using M = TestType;
    // 15 x 15 = 225 is 0.88; twice that is 1.76 and rounds to 2; 11 x 11 = 121 is 0.47, twice 0.95.
    const std::array<CombinerInput, 4> squares{rgb(R::primary_color), rgb(R::primary_color),
                                               rgb(R::primary_color), rgb(R::primary_color)};
    CHECK(shown<M>(one_stage(squares), inputs<M>(grey(11)))[0] == 1);
    CHECK(shown<M>(one_stage({squares[0], squares[1]}), inputs<M>(grey(11)))[0] == 0);
}

TEST_CASE("the two portions run apart and read what the stage before left", "[combiner]") {
    CombinerStage swap;
    swap.rgb.input = {alpha(R::spare0), one};
    swap.rgb.ab_output = R::spare0;
    swap.alpha.input = {CombinerInput{R::primary_color, Part::blue, Map::unsigned_identity}, one};
    swap.alpha.ab_output = R::spare0;
    RegisterCombiners state{{swap, swap}, {}};
    state.final_stage.d = rgb(R::spare0);
    state.final_stage.g = alpha(R::spare0);
    const auto in = inputs<Nv17>({10, 20, 30, 40}, {}, grey(0, 99));
    CHECK(shown<Nv17>(state, in) == std::array{30, 30, 30, 30});
    state.stages.pop_back();  // spare0's alpha starts as texture 0's
    CHECK(shown<Nv17>(state, in) == std::array{99, 99, 99, 30});
}

TEST_CASE("an alpha portion reads alpha or blue, and calls blue what RGB calls rgb", "[combiner]") {
    const auto in = inputs<Nv17>({10, 20, 30, 40});
    for (const auto& [component, expected] :
         {std::pair{Part::rgb, 30}, std::pair{Part::blue, 30}, std::pair{Part::alpha, 40}}) {
        RegisterCombiners state;
        state.final_stage.g = {R::primary_color, component, Map::unsigned_identity};
        CHECK(shown<Nv17>(state, in)[3] == expected);
    }
}

TEST_CASE("mux takes AB below one half of spare0's alpha and CD from there", "[combiner]") {
    auto state = one_stage({rgb(R::primary_color), one, rgb(R::secondary_color), one});
    state.stages[0].rgb.mux = true;
    const auto with_alpha = [&](int a) {
        return shown<Nv2x>(state, inputs<Nv2x>(grey(10), grey(20), grey(0, a)))[0];
    };
    for (int a = 0; a < 256; ++a) CHECK(with_alpha(a) == (a < 128 ? 10 : 20));
    const auto ideal = inputs<Ideal64>(grey(10), grey(20), grey(0, 128));
    CHECK(shown<Ideal64>(state, ideal)[0] == 20);
}

TEST_CASE("a dot product goes to all three channels, and by blue to alpha", "[combiner]") {
    CombinerStage stage;
    stage.rgb.input = {rgb(R::primary_color, Map::expand_normal),
                       rgb(R::secondary_color, Map::expand_normal)};
    stage.rgb.ab_dot_product = true;
    stage.rgb.ab_blue_to_alpha = true;
    stage.rgb.ab_output = R::spare1;
    RegisterCombiners state{{stage}, {}};
    state.final_stage.d = rgb(R::spare1);
    state.final_stage.g = alpha(R::spare1);
    const auto in = inputs<Nv2x>({255, 128, 0, 0}, {255, 200, 128, 0});
    // 255 x 255 + 1 x 145 - 255 x 1 = 64915, which is 254.57 of 255
    CHECK(shown<Nv2x>(state, in) == std::array{255, 255, 255, 255});
    const auto opposite = inputs<Nv2x>({0, 0, 0, 0}, {255, 255, 0, 0});
    CHECK(shown<Nv2x>(state, opposite) == std::array{0, 0, 0, 0});
    const auto weak = inputs<Nv2x>({200, 128, 128, 0}, {200, 0, 0, 0});
    CHECK(shown<Nv2x>(state, weak)[0] == (2 * (145 * 145 - 255 - 255) + 255) / 510);
}

TEST_CASE("an output that is not set is discarded", "[combiner]") {
    auto state = one_stage({rgb(R::primary_color), one});
    state.stages[0].rgb.sum_output.reset();
    CHECK(shown<Nv17>(state, inputs<Nv17>(grey(10))) == std::array{0, 0, 0, 0});
}

TEST_CASE("constants belong to their stage", "[combiner]") {
    CombinerStage first, second;
    first.constant_color0 = Vec4{0.2, 0.4, 0.6, 0.8};
    first.rgb.input = {rgb(R::constant_color0), one};
    first.rgb.ab_output = R::spare0;
    second.constant_color1 = Vec4{0.2};
    second.rgb.input = {rgb(R::spare0), one, rgb(R::constant_color1), one};
    second.rgb.sum_output = R::spare0;
    RegisterCombiners state{{first, second}, {}};
    state.final_stage.d = rgb(R::spare0);
    state.final_stage.constant_color0 = Vec4{2.0};
    state.final_stage.g = alpha(R::constant_color0);
    CHECK(shown<Nv17>(state, inputs<Nv17>(grey(0))) == std::array{102, 153, 204, 255});
}

TEMPLATE_TEST_CASE("the final combiner mixes B and C by A and adds D", "[combiner]", Ideal64, Gl13,
                   Nv2x, Nv17) {
    using M = TestType;
    RegisterCombiners state;
    state.final_stage.a = rgb(R::texture0);
    state.final_stage.b = rgb(R::primary_color);
    state.final_stage.c = rgb(R::secondary_color);
    state.final_stage.g = alpha(R::texture0, Map::unsigned_invert);
    for (int a = 0; a < 256; a += 3) {
        const auto in = inputs<M>(grey(200), grey(31), grey(a, a));
        state.final_stage.d = rgb(R::zero);
        const int mixed = sum_rn(a, 200, 255 - a, 31);
        CHECK(shown<M>(state, in) == std::array{mixed, mixed, mixed, 255 - a});
        state.final_stage.d = rgb(R::primary_color);
        CHECK(shown<M>(state, in)[0] == std::min(255, mixed + 200));
    }
}

TEST_CASE("E F is a register of the final combiner", "[combiner]") {
    RegisterCombiners state;
    state.final_stage.e = rgb(R::primary_color);
    state.final_stage.f = rgb(R::secondary_color, Map::unsigned_invert);
    state.final_stage.d = rgb(R::e_times_f);
    for (int e = 0; e < 256; ++e)
        CHECK(shown<Nv17>(state, inputs<Nv17>(grey(e), grey(55)))[0] == mul_rn(e, 200));
}

TEST_CASE("spare0 + secondary reaches 510 unless the sum is clamped, and inverts each",
          "[combiner]") {
    CombinerStage stage;
    stage.rgb.input = {rgb(R::primary_color), one};
    stage.rgb.ab_output = R::spare0;
    RegisterCombiners state{{stage}, {}};
    state.final_stage.a = rgb(R::constant_color0);
    state.final_stage.b = rgb(R::spare0_plus_secondary_color);
    state.final_stage.constant_color0 = Vec4{127.0 / 255.0};
    const auto white = inputs<Nv2x>(grey(255), grey(255));
    CHECK(shown<Nv2x>(state, white)[0] == 254);
    state.final_stage.clamp_sum = true;
    CHECK(shown<Nv2x>(state, white)[0] == 127);
    state.final_stage.constant_color0 = Vec4{1.0};
    state.final_stage.clamp_sum = false;
    const auto in = inputs<Nv2x>(grey(191), grey(10));
    CHECK(shown<Nv2x>(state, in)[0] == 201);
    state.final_stage.invert_spare0 = true;
    CHECK(shown<Nv2x>(state, in)[0] == 64 + 10);
    state.final_stage.invert_secondary = true;
    CHECK(shown<Nv2x>(state, in)[0] == 255);
}

TEST_CASE("a stage on coarse8 stores no negative number and loses with white", "[combiner]") {
    auto state = one_stage({rgb(R::primary_color, Map::signed_negate), one});
    CombinerStage negate;
    negate.rgb.input = {rgb(R::spare0, Map::signed_negate), one};
    negate.rgb.ab_output = R::spare0;
    state.stages.push_back(negate);
    CHECK(shown<Coarse8>(state, inputs<Coarse8>(grey(200)))[0] == 0);
    CHECK(shown<Nv17>(state, inputs<Nv17>(grey(200)))[0] == 200);
    const auto white = one_stage({rgb(R::primary_color), one});
    CHECK(shown<Coarse8>(white, inputs<Coarse8>(grey(200)))[0] == 199);
}
