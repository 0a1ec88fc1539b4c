#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "raster/color_format.hpp"
#include "raster/reference.hpp"
#include "scenes/assets.hpp"
#include "scenes/frame.hpp"
#include "tests/scenes/scene_text.hpp"
#include "texunit/byte_arithmetic.hpp"

/// The probe scenes of docs/probes.md: each draws what its page predicts, and its hypotheses give
/// different pictures.

using namespace twofold;
using namespace twofold::scene_text;

namespace {

const std::vector<std::string> probes{
    "color-ramp",     "magnified-texture", "product-table", "sum-of-products", "blend-table",
    "snap-staircase", "dither-ramp",       "dxt1-blocks",   "add-signed",      "vertex-colors"};

/// A probe's picture under one preset, rows from the bottom as glReadPixels returns them.
struct Picture {
    int width, height;
    std::vector<Rgba8> pixels;

    Rgba8 at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

Scene probe(const std::string& name, const std::vector<std::string>& changes = {}) {
    return read_scene(folder / "probes" / (name + ".json"), changes);
}

Picture draw(const Scene& scene, Preset preset) {
    const Frame frame = make_frame(scene, load_assets(scene), {}, preset);
    const Framebuffer drawn = render_reference(frame, preset, scene.custom);
    Picture picture{drawn.width, drawn.height, {}};
    for (int y = drawn.height - 1; y >= 0; --y) {
        const auto row = drawn.bytes.begin() + static_cast<std::ptrdiff_t>(y) * drawn.width;
        picture.pixels.insert(picture.pixels.end(), row, row + drawn.width);
    }
    return picture;
}

Picture draw(const std::string& name, Preset preset) { return draw(probe(name), preset); }

/// nv17 with one stage changed.
Picture draw_custom(const std::string& name, const std::string& setting) {
    return draw(probe(name, {"custom." + setting}), Preset::custom);
}

int differing(const Picture& a, const Picture& b) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] == b.pixels[i] ? 0 : 1;
    return count;
}

/// Pixels whose red is not `expected(x, y)`, y from the bottom.
template <class F>
int wrong_reds(const Picture& picture, F expected) {
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            count += picture.at(x, y).r == expected(x, y) ? 0 : 1;
    return count;
}

}  // namespace

TEST_CASE("every probe is read, is the same after being written, and draws in its presets") {
    for (const std::string& name : probes) {
        INFO(name);
        const Scene scene = probe(name);
        const std::string text = scene_to_json(scene);
        CHECK(scene_to_json(parse_scene(text, "y.json", "/")) == text);
        CHECK(scene.image.width <= 256);
        CHECK(scene.image.height <= 256);
        for (const Preset preset : scene.presets) {
            const Picture picture = draw(scene, preset);
            CHECK(differing(picture, Picture{picture.width, picture.height,
                                             std::vector<Rgba8>(picture.pixels.size())}) > 0);
        }
    }
}

TEST_CASE("probe 1: the colour iterators differ") {
    const Picture nv17 = draw("color-ramp", Preset::nv17);
    CHECK(differing(nv17, draw("color-ramp", Preset::nv2x)) == 0);
    CHECK(differing(nv17, draw("color-ramp", Preset::gl13)) == 5155);
    CHECK(differing(nv17, draw("color-ramp", Preset::coarse8)) == 7902);
}

TEST_CASE("probe 2: each filter step rounds, with weights of eight bits") {
    const Picture nv17 = draw("magnified-texture", Preset::nv17);
    // Red is 0, 255 below and 255, 0 above; weights are odd 256ths between the texels' centres.
    CHECK(wrong_reds(nv17, [](int x, int y) {
              const auto weight = [](int i) { return i < 64 ? 0 : (i >= 192 ? 255 : 2 * i - 127); };
              const auto outside = [](int i) { return i >= 192; };
              const int w = weight(x), lower = outside(x) ? 255 : flerp(0, 255, w),
                        upper = outside(x) ? 0 : flerp(255, 0, w);
              return outside(y) ? upper : flerp(lower, upper, weight(y));
          }) == 0);
    const auto changed = [&](const std::string& setting) {
        return differing(nv17, draw_custom("magnified-texture", setting));
    };
    CHECK(changed("filter_rounding=once") == 6880);
    CHECK(changed("filter_rounding=floor") == 44145);
    CHECK(changed("filter_weight_bits=7") == 46139);
    CHECK(changed("filter_weight_bits=5") == 48896);
    CHECK(differing(nv17, draw("magnified-texture", Preset::coarse8)) == 48805);
}

TEST_CASE("probe 3: the roundings of a product differ in as many pairs as they are known to") {
    const Picture nv17 = draw("product-table", Preset::nv17);
    CHECK(wrong_reds(nv17, [](int x, int y) { return mul_rn(x, y); }) == 0);
    CHECK(differing(nv17, draw("product-table", Preset::gl13)) == 0);
    CHECK(wrong_reds(draw("product-table", Preset::coarse8),
                     [](int x, int y) { return x * y >> 8; }) == 0);
    CHECK(differing(nv17, draw("product-table", Preset::coarse8)) == 47056);
    CHECK(differing(nv17, draw_custom("product-table", "product_rounding=floor")) == 31770);
}

TEST_CASE("probe 4: one rounding of A B + C D and two differ in 14,450 pixels") {
    const Picture nv17 = draw("sum-of-products", Preset::nv17);
    CHECK(wrong_reds(nv17, [](int x, int y) { return rounded_255th(85 * (x + y)); }) == 0);
    CHECK(wrong_reds(nv17, [](int x, int y) { return mul_rn(x, 85) + mul_rn(y, 85); }) == 14450);
    CHECK(differing(nv17, draw("sum-of-products", Preset::gl13)) == 0);
    CHECK(differing(nv17, draw("sum-of-products", Preset::coarse8)) == 65365);
}

TEST_CASE("probe 5: one rounding of a blend and two differ in 14,450 pixels") {
    const Picture nv17 = draw("blend-table", Preset::nv17);
    CHECK(wrong_reds(nv17, [](int x, int y) { return sum_rn(y, 85, x, 170); }) == 0);
    CHECK(wrong_reds(nv17, [](int x, int y) { return mul_rn(y, 85) + mul_rn(x, 170); }) == 14450);
    CHECK(wrong_reds(draw("blend-table", Preset::coarse8),
                     [](int x, int y) { return y * 85 / 255 + x * 170 / 255; }) == 0);
    CHECK(differing(nv17, draw("blend-table", Preset::coarse8)) == 43520);
}

namespace {

/// The last of the 64 steps whose edge leaves its first pixel covered, and the same for top edges.
std::array<int, 2> last_covered(const Picture& picture) {
    std::array<int, 2> last{-1, -1};
    for (int k = 0; k < 64; ++k) {
        if (picture.at(4 * k, 7).a != 0) last[0] = k;
        if (picture.at(4 * k, 3).a != 0) last[1] = k;
    }
    return last;
}

}  // namespace

TEST_CASE("probe 6: the last covered step tells the snap") {
    const auto last = [](Preset preset) { return last_covered(draw("snap-staircase", preset)); };
    const auto biased = [](const std::string& bias) {
        return last_covered(draw_custom("snap-staircase", "snap_bias=" + bias));
    };
    CHECK(last(Preset::nv17) == std::array{33, 33});
    CHECK(last(Preset::ideal64) == std::array{32, 32});
    CHECK(last(Preset::gl13) == std::array{32, 32});
    CHECK(last(Preset::coarse8) == std::array{35, 35});
    CHECK(biased("0") == std::array{35, 35});
    CHECK(biased("-0.03125") == std::array{37, 37});
}

TEST_CASE("probe 7: the dither is the named matrix, and its absence shows") {
    const Picture nv17 = draw("dither-ramp", Preset::nv17);
    // Row y from the bottom is row 15 - y of the picture.
    CHECK(wrong_reds(nv17, [](int x, int y) {
              const int n =
                  bayer[static_cast<std::size_t>((15 - y) & 3)][static_cast<std::size_t>(x & 3)];
              return std::min(x + n / 2, 255) / 8 * 8;
          }) == 0);
    const Picture plain = draw(probe("dither-ramp", {"passes.0.dither=false"}), Preset::nv17);
    CHECK(wrong_reds(plain, [](int x, int) { return x / 8 * 8; }) == 0);
    CHECK(differing(nv17, plain) == 2132);
}

TEST_CASE("probe 8: DXT1 with rounded means, exact ones, and dithered") {
    const Picture nv17 = draw("dxt1-blocks", Preset::nv17);
    CHECK(nv17.at(0, 0) == Rgba8{132, 113, 99, 255});
    CHECK(differing(nv17, draw("dxt1-blocks", Preset::nv2x)) == 887);
    CHECK(differing(nv17, draw("dxt1-blocks", Preset::gl13)) == 392);
    CHECK(differing(nv17, draw("dxt1-blocks", Preset::coarse8)) == 892);
}

TEST_CASE("probe 9: scale 4 of ADD_SIGNED is 2 on the chip and 4 in the text") {
    const auto byte = [](int v) { return std::clamp(v, 0, 255); };
    const Picture nv17 = draw("add-signed", Preset::nv17);
    CHECK(wrong_reds(nv17, [&](int x, int y) { return byte(2 * (x + y - 128)); }) == 0);
    const Picture gl13 = draw("add-signed", Preset::gl13);
    CHECK(wrong_reds(gl13, [&](int x, int y) { return byte(4 * (x + y) - 510); }) == 0);
    CHECK(differing(nv17, gl13) == 24640);
}

TEST_CASE("probe 10: the conversions of a vertex colour turn over at different fractions") {
    const Picture nv17 = draw("vertex-colors", Preset::nv17);
    CHECK(differing(nv17, draw("vertex-colors", Preset::nv2x)) == 35);
    CHECK(differing(nv17, draw_custom("vertex-colors", "vertex_color=nearest")) == 59);
    const Picture gl13 = draw("vertex-colors", Preset::gl13);
    // The upper row of .5 is the second from the top: to nearest turns over there.
    CHECK(gl13.at(3, 7) == Rgba8{55, 55, 55, 55});
    CHECK(gl13.at(3, 5) == Rgba8{56, 56, 56, 56});
    CHECK(wrong_reds(draw("vertex-colors", Preset::coarse8),
                     [](int x, int) { return 16 * x + 7; }) == 0);
}
