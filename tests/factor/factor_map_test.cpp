#include "factor/factor_map.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "factor/scale.hpp"
#include "texunit/error.hpp"

using namespace twofold;

namespace {

using Catch::Matchers::Contains;

const MapShape shape{32, 0.875};

std::size_t centre_texel() { return texel_index({1, 16, 15}, shape); }

bool visible(std::size_t j) { return is_opaque(texel_at(j, shape), shape); }

/// A channel whose visible texels spread evenly over [0.01, 1], but for one that is `peak`.
std::vector<double> one_peak(double peak) {
    double count = 0.0;
    for (std::size_t j = 0; j < shape.texels(); ++j) count += visible(j) ? 1.0 : 0.0;
    std::vector<double> texels(shape.texels());
    double rank = 0.0;
    for (std::size_t j = 0; j < texels.size(); ++j) {
        if (visible(j)) texels[j] = (0.01 + 0.99 * (rank++ + 0.5) / count) / peak;
    }
    texels[centre_texel()] = 1.0;
    return texels;
}

}  // namespace

TEST_CASE("F07 a factor is divided by its largest visible texel", "[hard][F07]") {
    std::vector<double> logs(shape.texels(), 1.0);
    logs[centre_texel()] = 3.0;
    logs[0] = 50.0;  // a corner, which no pass shows
    const NormalisedChannel channel = normalised(logs, shape, "t1 red");
    CHECK(channel.log_maximum == 3.0);
    CHECK(channel.texel[centre_texel()] == 1.0);
    CHECK(channel.texel[0] == 1.0);
    CHECK(channel.texel[1] == Approx(std::exp(-2.0)));
}

TEST_CASE("logarithms far outside the range of exp still make texels") {
    std::vector<double> logs(shape.texels(), 2000.0);
    logs[centre_texel()] = 2001.0;
    const NormalisedChannel channel = normalised(logs, shape, "t1 red");
    CHECK(channel.texel[1] == Approx(std::exp(-1.0)));
    CHECK(normalised(std::vector<double>(shape.texels(), -4000.0), shape, "t1 red").texel[5] ==
          1.0);
}

TEST_CASE("T01 an image has front and back face, binary alpha and one rounding", "[hard][T01]") {
    NormalisedChannel red = black_channel(shape);
    NormalisedChannel green = black_channel(shape);
    red.texel[texel_index({1, 16, 15}, shape)] = 1.0;
    green.texel[texel_index({0, 7, 9}, shape)] = 0.25;
    const FactorMap map = make_factor_map({red, green, black_channel(shape)}, shape, "t1");

    const auto& front = std::get<std::vector<Rgba8>>(map.bytes[0].texels);
    const auto& back = std::get<std::vector<Rgba8>>(map.bytes[1].texels);
    CHECK(back[15 * 32 + 16] == Rgba8{255, 0, 0, 255});
    CHECK(front[9 * 32 + 7] == Rgba8{0, 64, 0, 255});
    CHECK(front[0] == Rgba8{0, 0, 0, 0});
    const auto& real = std::get<std::vector<Rgba32f>>(map.real[0].texels);
    CHECK(real[9 * 32 + 7] == Rgba32f{0.0F, 0.25F, 0.0F, 1.0F});
    CHECK(real[0][3] == 0.0F);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const auto i = static_cast<std::size_t>(y * 32 + x);
            REQUIRE(front[i].a == (texel_is_opaque(x, y, 32, 0.875) ? 255 : 0));
            REQUIRE(back[i].a == front[i].a);
        }
    }
}

TEST_CASE("Q01 a maximum of 0 needs no division", "[hard][Q01]") {
    const FactorMap map = make_factor_map(
        {black_channel(shape), black_channel(shape), black_channel(shape)}, shape, "t1");
    CHECK(map.loss[0].levels == 0);
    CHECK(map.loss[0].zero_share == 1.0);
    const ScaleSplit split = split_scale(Rgb(0.0));
    CHECK(split.color == Rgb(0.0));
    CHECK(split.combiner_scale == 1);
    CHECK(split.warnings.empty());
}

TEST_CASE("Q02 the levels and zeros that one large texel leaves are counted", "[hard][Q02]") {
    // 255 v / 100 rounds to 0 below v = 0.196: (0.196 - 0.01) / 0.99 = 18.8 % of the rest.
    const ByteLoss hundred = byte_loss(one_peak(100.0), shape);
    CHECK(hundred.levels == 4);
    CHECK(hundred.zero_share == Approx(0.188).margin(1e-3));
    const ByteLoss ten_thousand = byte_loss(one_peak(1e4), shape);
    CHECK(ten_thousand.levels == 1);
    CHECK(ten_thousand.zero_share > 0.999);
}

TEST_CASE("Q03 the constant is split between colour, combiner and passes", "[hard][Q03]") {
    struct Case {
        double c;
        int combiner_scale;
        int doubling_passes;
        std::size_t warnings;
    };
    for (const Case& expected :
         {Case{0x1p-140, 1, 0, 1}, Case{1.5e-6, 1, 0, 1}, Case{0.5, 1, 0, 0}, Case{1.0, 1, 0, 0},
          Case{1.0 + 0x1p-52, 2, 0, 0}, Case{3.0, 4, 0, 0}, Case{4.0, 4, 0, 0}, Case{11.4, 4, 2, 1},
          Case{16.0, 4, 2, 1}, Case{300.0, 4, 7, 1}, Case{1e30, 4, 98, 1}}) {
        CAPTURE(expected.c);
        // The other channels keep up, so that only the stated one warns.
        const ScaleSplit split =
            split_scale(expected.c < 1.0 / 510.0 ? Rgb(expected.c, 1.0, 1.0) : Rgb(expected.c));
        CHECK(split.combiner_scale == expected.combiner_scale);
        CHECK(split.doubling_passes == expected.doubling_passes);
        CHECK(split.warnings.size() == expected.warnings);
        CHECK(max_component(split.color) <= 1.0);
        const double scale = std::ldexp(split.combiner_scale, split.doubling_passes);
        CHECK(split.color.x * scale == Approx(expected.c).epsilon(1e-15));
    }
    CHECK_THAT(split_scale({1.0, 1e-6, 1.0}).warnings.front(), Contains("green"));
    CHECK_THROWS_WITH(split_scale({1.0, 1.0, std::numeric_limits<double>::infinity()}),
                      Contains("blue"));
}

TEST_CASE("Q04 a half step rounds up, once", "[hard][Q04]") {
    for (int k = 0; k < 255; ++k) {
        const double tie = (k + 0.5) / 255.0;
        const double product = 255.0 * tie;
        CHECK(to_byte(tie) == (product >= k + 0.5 ? k + 1 : k));
        CHECK(to_byte(k / 255.0) == k);
        // Below the tie by less than a float can tell: rounding to float first would raise it.
        CHECK(to_byte((k + 0.5 - 1e-9) / 255.0) == k);
    }
    CHECK(to_byte(0.5) == 128);
    CHECK(to_byte(1.0) == 255);
    CHECK(to_byte(2.0) == 255);
    CHECK(to_byte(-1.0) == 0);
}

TEST_CASE("Q06 a value that is not finite never reaches a byte", "[hard][Q06]") {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        std::vector<double> logs(shape.texels(), 0.0);
        logs[texel_index({1, 3, 7}, shape)] = bad;
        CHECK_THROWS_WITH(normalised(logs, shape, "t2 green"),
                          Contains("t2 green") && Contains("(3, 7)") && Contains("back"));

        NormalisedChannel channel = black_channel(shape);
        channel.texel[texel_index({0, 5, 6}, shape)] = bad;
        CHECK_THROWS_WITH(
            make_factor_map({black_channel(shape), black_channel(shape), channel}, shape, "t1"),
            Contains("t1 blue") && Contains("(5, 6)") && Contains("front"));
    }
}
