#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "raster/fast.hpp"
#include "raster/lane_rounding.hpp"
#include "tests/raster/builders.hpp"
#include "tests/raster/random/dice.hpp"

using namespace twofold;
using namespace twofold::test;

namespace {

constexpr std::array product_roundings{ProductRounding::nearest, ProductRounding::floor,
                                       ProductRounding::shift};
constexpr std::array filter_roundings{FilterRounding::half_up, FilterRounding::floor,
                                      FilterRounding::once};
using Batch = lanes::RealBatch<double>;

/// Settings that round nowhere after the registers, so that a result shows every bit of them.
CustomSettings open_settings(int register_bits) {
    CustomSettings s;
    s.register_bits = register_bits;
    s.framebuffer_bits = 0;
    return s;
}

/// One unit that reads a row of texels without surroundings, `stride` apart.
lanes::RoundedShader shader_of(const lanes::Rounding& rule,
                               const std::vector<Color<double>>& texels, int stride, bool linear) {
    lanes::RoundedShader s{};
    s.units = 1;
    s.unit[0].image = {texels.data(), static_cast<int>(texels.size()), 1, stride};
    s.unit[0].linear = linear;
    s.unit[0].rgb_scale = s.unit[0].alpha_scale = 1;
    s.rounding = rule;
    return s;
}

Color<double> gray(int x) {
    const double v = x;
    return {v, v, v, v};
}

/// The fragments' greys times the texel, on vectors.
std::vector<double> products(const Custom& m, int texel, const std::vector<int>& colors) {
    const std::vector<Color<double>> texels{gray(texel)};
    const auto batch = std::make_unique<Batch>();
    batch->size = colors.size();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        batch->fine[0].offset[i] = 0;
        batch->color[i] = gray(colors[i]);
    }
    lanes::shade(shader_of(rounding_of(m), texels, 1, false), *batch);
    std::vector<double> result;
    for (std::size_t i = 0; i < colors.size(); ++i) result.push_back(batch->color[i][i % 4]);
    return result;
}

/// The least product that gives the quotient n.
std::int64_t first_product(ProductRounding rounding, std::int64_t one, std::int64_t n) {
    if (rounding == ProductRounding::floor) return n * one;
    if (rounding == ProductRounding::shift) return n * (one / 255 * 256);
    return (2 * n * one - one + 1) / 2;
}

}  // namespace

TEST_CASE("A product's quotient is exact where it changes, at every width", "[raster]") {
    for (const auto rounding : product_roundings)
        for (int fraction_bits = 0; fraction_bits <= 15; ++fraction_bits) {
            const std::int64_t one = std::int64_t{255} << fraction_bits;
            const auto q = quotient_of(rounding, static_cast<double>(one));
            const auto quotient = [&](std::int64_t x) {
                return std::floor((static_cast<double>(x) + q.add) * q.factor);
            };
            std::int64_t wrong = 0;
            for (std::int64_t n = 1; n <= one; ++n) {
                const std::int64_t x = first_product(rounding, one, n);
                const auto whole = static_cast<double>(n);
                wrong += quotient(x) != whole || quotient(x - 1) != whole - 1.0;
            }
            CHECK(wrong == 0);
            wrong = 0;
            for (std::int64_t a = 0; a <= one; a += one / 255)
                wrong +=
                    quotient(a * static_cast<std::int64_t>(q.identity)) != static_cast<double>(a);
            CHECK(wrong == 0);
        }
}

TEST_CASE("Vectors multiply all bytes as custom does", "[raster]") {
    std::vector<int> bytes;
    for (int k = 0; k < 256; ++k) bytes.push_back(k);
    for (const auto rounding : product_roundings) {
        CustomSettings settings = open_settings(9);
        settings.product_rounding = rounding;
        const Custom m(settings);
        int wrong = 0;
        for (int a = 0; a < 256; ++a) {
            const auto found = products(m, a, bytes);
            for (int b = 0; b < 256; ++b)
                wrong += found[static_cast<std::size_t>(b)] != m.finish(m.modulate(a, b));
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("Vectors multiply registers of every width as custom does", "[raster]") {
    Dice dice(47, 0);
    for (const auto rounding : product_roundings)
        for (int bits = 8; bits <= 24; ++bits) {
            CustomSettings settings = open_settings(bits);
            settings.product_rounding = rounding;
            if (bits % 2 == 0) settings.framebuffer_bits = 8;
            const Custom m(settings);
            int wrong = 0;
            for (int k = 0; k < 100; ++k) {
                const int texel = k == 0 ? m.one() : dice.integer(0, m.one());
                std::vector<int> colors{0, 1, m.one() - 1, m.one()};
                while (colors.size() < 250) colors.push_back(dice.integer(0, m.one()));
                const auto found = products(m, texel, colors);
                for (std::size_t i = 0; i < colors.size(); ++i)
                    wrong += found[i] != m.finish(m.modulate(texel, colors[i]));
            }
            CHECK(wrong == 0);
        }
}

namespace {

/// A batch of lookups with LINEAR in 2 x 2 texels each, for one preset.
template <NumericModel M>
int wrong_filters(Dice& dice, const M& m) {
    constexpr std::size_t size = 250;
    const int one = m.one();
    const auto batch = std::make_unique<Batch>();
    batch->size = size;
    std::vector<Color<double>> texels;
    for (std::size_t i = 0; i < 4 * size; ++i)
        texels.push_back(gray(dice.chance(0.2) ? dice.one_of({0, one}) : dice.integer(0, one)));
    for (std::size_t i = 0; i < size; ++i) {
        batch->fine[0].offset[i] = static_cast<int>(2 * i);
        batch->fine[0].a[i] = dice.chance(0.1) ? dice.one_of({0.0, 1.0, 0.5}) : dice.unit();
        batch->fine[0].b[i] = dice.chance(0.1) ? dice.one_of({0.0, 1.0, 0.5}) : dice.unit();
        batch->color[i] = gray(one);
    }
    const auto a = batch->fine[0].a, b = batch->fine[0].b;
    lanes::shade(shader_of(rounding_of(m), texels, 2 * size, true), *batch);
    int wrong = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const auto texel = [&](std::size_t k) { return static_cast<int>(texels[2 * i + k][0]); };
        const int filtered =
            m.filter(texel(0), texel(1), texel(2 * size), texel(2 * size + 1), a[i], b[i]);
        wrong += batch->color[i][i % 4] != m.finish(m.modulate(filtered, one));
    }
    return wrong;
}

}  // namespace

TEST_CASE("Vectors filter as custom and coarse8 do, at every width", "[raster]") {
    Dice dice(47, 1);
    int wide = 0;
    for (const auto rounding : filter_roundings)
        for (int weights = 1; weights <= 16; ++weights)
            for (int registers = 8; registers <= 24; ++registers) {
                CustomSettings settings = open_settings(registers);
                settings.filter_weight_bits = weights;
                settings.filter_rounding = rounding;
                const Custom m(settings);
                if (filter_is_exact(rounding_of(m)))
                    CHECK(wrong_filters(dice, m) == 0);
                else
                    ++wide;
            }
    CHECK(wide == 2);  // once, 16 bits of weight, registers of 23 and 24
    CHECK(wrong_filters(dice, Coarse8()) == 0);
}

TEST_CASE("A framebuffer of fewer bits cuts what is drawn without a blend", "[raster]") {
    CustomSettings settings;
    settings.framebuffer_bits = 4;
    PassState state;
    state.color = {0.7, 0.3, 0.99, 1.0};
    const Frame frame = pixel_frame(8, 8, rectangle(0, 0, 8, 8), state);
    const Framebuffer expected = render_reference(frame, Preset::custom, settings);
    CHECK(expected.bytes[0] == Rgba8{0xb0, 0x40, 0xf0, 0xff});
    CHECK(render_fast(frame, Preset::custom, settings).bytes == expected.bytes);
}

TEST_CASE("Colour weights of a huge triangle are quotients of integers on vectors too",
          "[raster]") {
    // In 1/4096 pixel. At the only pixel's centre 256 times the doubled area opposite the first
    // vertex is 255 A - 1, A being the triangle's, so that the weight is 254; the quotient in
    // binary64 is 255.
    constexpr double unit = 1.0 / 4096.0;
    Mesh mesh = triangles({{unit * -44102, unit * -15951, 0.5},
                           {unit * 16695881, unit * -537219, 0.5},
                           {unit * 2958708, unit * 13767306, 0.5}});
    mesh.colors = {{1, 1, 1, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}};
    CustomSettings settings;
    settings.snap_bits = 12;
    settings.snap_bias = 0.0;
    PassState state;
    state.window_space = true;
    const Frame frame = pixel_frame(1, 1, mesh, state);
    const Framebuffer expected = render_reference(frame, Preset::custom, settings);
    CHECK(expected.bytes[0] == Rgba8{253, 253, 253, 253});
    CHECK(render_fast(frame, Preset::custom, settings).bytes == expected.bytes);
}
