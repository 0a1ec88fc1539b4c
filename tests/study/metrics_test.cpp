#include "study/metrics.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "texunit/error.hpp"

using namespace twofold;

namespace {

constexpr Rgba8 grey{100, 100, 100, 255};
constexpr Rgba8 empty{0, 0, 0, 0};

ByteImage picture(int width, int height, Rgba8 fill) {
    return {width, height,
            std::vector<Rgba8>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                               fill)};
}

template <typename Image>
ExitCode code_of_difference(const Image& a, const Image& b) {
    try {
        static_cast<void>(difference(a, b));
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::ok;
}

int luminance(Rgba8 c) { return 2126 * c.r + 7152 * c.g + 722 * c.b; }

}  // namespace

TEST_CASE("equal pictures have no difference and an infinite PSNR") {
    const ByteImage a = picture(3, 2, grey);
    const PictureDifference d = difference(a, a);
    CHECK(d.pixels_compared == 6);
    CHECK(d.differing_pixels == 0);
    CHECK_FALSE(d.first_difference.has_value());
    CHECK(d.rms_steps == 0.0);
    CHECK(std::isinf(d.psnr_db));
    CHECK(d.histogram[0] == 6);
}

TEST_CASE("one changed channel is found, placed and measured") {
    const ByteImage a = picture(4, 2, grey);
    ByteImage b = a;
    b.pixels[6].g = 108;
    const PictureDifference d = difference(a, b);
    CHECK(d.differing_pixels == 1);
    CHECK(d.first_difference == std::pair(2, 1));
    CHECK(d.max_steps == 8);
    CHECK(d.max_per_channel == std::array{0, 8, 0, 0});
    CHECK(d.histogram[0] == 7);
    CHECK(d.histogram[8] == 1);
    CHECK(d.rms_steps == std::sqrt(64.0 / 32.0));
    CHECK(d.psnr_db == Approx(20.0 * std::log10(255.0 / std::sqrt(2.0))));
}

TEST_CASE("the difference is the same from both sides") {
    ByteImage a = picture(2, 2, grey);
    ByteImage b = picture(2, 2, {90, 120, 100, 0});
    a.pixels[3] = empty;
    const PictureDifference ab = difference(a, b), ba = difference(b, a);
    CHECK(ab.rms_steps == ba.rms_steps);
    CHECK(ab.histogram == ba.histogram);
    CHECK(ab.coverage_differs == ba.coverage_differs);
}

TEST_CASE("black against white is the largest difference: 255 steps, 0 dB") {
    const PictureDifference d =
        difference(picture(5, 5, empty), picture(5, 5, {255, 255, 255, 255}));
    CHECK(d.max_steps == 255);
    CHECK(d.rms_steps == 255.0);
    CHECK(d.psnr_db == 0.0);
    CHECK(d.histogram[255] == 25);
}

TEST_CASE("where covered, neither background nor outline counts as a difference of colour") {
    ByteImage a = picture(4, 1, grey), b = a;
    a.pixels[0] = {1, 2, 3, 0}, b.pixels[0] = {9, 9, 9, 0};  // background in both
    b.pixels[1] = empty;                                     // outline
    b.pixels[3] = {102, 100, 100, 7};  // alpha differs too, but is not compared
    const PictureDifference d = difference_where_covered(a, b);
    CHECK(d.pixels_compared == 2);
    CHECK(d.coverage_differs == 1);
    CHECK(d.differing_pixels == 1);
    CHECK(d.first_difference == std::pair(3, 0));
    CHECK(d.max_steps == 2);
    CHECK(d.max_per_channel == std::array{2, 0, 0, 0});
    CHECK(d.rms_steps == std::sqrt(4.0 / 6.0));
}

TEST_CASE("pictures without a common covered pixel compare nothing") {
    const PictureDifference d = difference_where_covered(picture(2, 2, grey), picture(2, 2, empty));
    CHECK(d.pixels_compared == 0);
    CHECK(d.coverage_differs == 4);
    CHECK(d.rms_steps == 0.0);
}

TEST_CASE("pictures of no pixels are equal") {
    CHECK(difference(ByteImage{}, ByteImage{}).pixels_compared == 0);
    CHECK(difference(FloatImage{}, FloatImage{}).samples_compared == 0);
    CHECK(heat_map(ByteImage{}, ByteImage{}, 8).pixels.empty());
}

TEST_CASE("pictures of different size are refused with exit code 3") {
    CHECK(code_of_difference(picture(2, 3, grey), picture(3, 2, grey)) == ExitCode::sizes_differ);
    const FloatImage one{1, 1, 1, {0.0f}}, two{1, 1, 2, {0.0f, 0.0f}};
    CHECK(code_of_difference(one, two) == ExitCode::sizes_differ);
    CHECK_THROWS_WITH(heat_map(picture(2, 3, grey), picture(3, 2, grey), 8),
                      Catch::Contains("2 x 3") && Catch::Contains("3 x 2"));
}

TEST_CASE("float pictures: largest, RMS and PSNR against a peak of 1") {
    const FloatImage a{2, 1, 2, {0.0f, 0.5f, 1.0f, 0.25f}};
    const FloatImage b{2, 1, 2, {0.0f, 0.5f, 0.5f, 0.25f}};
    const FloatDifference d = difference(a, b);
    CHECK(d.samples_compared == 4);
    CHECK(d.differing_samples == 1);
    CHECK(d.differing_pixels == 1);
    CHECK(d.first_difference == std::pair(1, 0));
    CHECK(d.max_abs == 0.5);
    CHECK(d.rms == 0.25);
    CHECK(d.psnr_db == Approx(12.0411998));
}

TEST_CASE("float samples that are not finite differ without spoiling the figures") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const FloatImage a{4, 1, 1, {nan, nan, inf, 0.0f}};
    const FloatImage b{4, 1, 1, {nan, 0.0f, inf, -0.0f}};
    const FloatDifference d = difference(a, b);
    CHECK(d.differing_samples == 1);
    CHECK(d.without_distance == 1);
    CHECK(d.first_difference == std::pair(1, 0));
    CHECK(d.max_abs == 0.0);
    CHECK(d.rms == 0.0);
}

TEST_CASE("float pictures where covered need an alpha channel and leave it out") {
    const FloatImage a{2, 1, 4, {0.5f, 0.5f, 0.5f, 1.0f, 9.0f, 9.0f, 9.0f, 0.0f}};
    const FloatImage b{2, 1, 4, {0.5f, 0.5f, 0.0f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f}};
    const FloatDifference d = difference_where_covered(a, b);
    CHECK(d.samples_compared == 3);
    CHECK(d.differing_samples == 1);
    CHECK(d.coverage_differs == 1);
    const FloatImage no_alpha{1, 1, 3, {0.0f, 0.0f, 0.0f}};
    CHECK_THROWS_AS(difference_where_covered(no_alpha, no_alpha), Error);
}

TEST_CASE("heat colours grow brighter with every step of difference") {
    ByteImage a = picture(64, 1, grey), b = a;
    for (std::size_t i = 0; i < 64; ++i) b.pixels[i].r = static_cast<std::uint8_t>(100 + i);
    const ByteImage heat = heat_map(a, b, 63);
    CHECK(heat.pixels.front() == heat_colors.front());
    CHECK(heat.pixels[1] == heat_colors[1]);
    CHECK(heat.pixels.back() == heat_colors.back());
    for (std::size_t i = 1; i < 64; ++i) {
        CAPTURE(i);
        CHECK(luminance(heat.pixels[i]) > luminance(heat.pixels[i - 1]));
    }
}

TEST_CASE("a heat map saturates at its full scale and stands any scale") {
    const ByteImage a = picture(1, 1, grey), b = picture(1, 1, {140, 100, 100, 255});
    for (const int scale : {-5, 0, 1, 2, 40})
        CHECK(heat_map(a, b, scale).pixels[0] == heat_colors.back());
    CHECK(heat_map(a, b, 41).pixels[0] != heat_colors.back());
    CHECK(heat_map(a, b, 100000).pixels[0].a == 255);
}

TEST_CASE("a heat map marks coverage apart and leaves equal background transparent") {
    ByteImage a = picture(3, 1, empty), b = a;
    b.pixels[1] = grey;
    b.pixels[2].r = 4;
    const ByteImage heat = heat_map(a, b, 8);
    CHECK(heat.pixels[0] == empty);
    CHECK(heat.pixels[1] == coverage_color);
    CHECK(heat.pixels[2].a == 255);
}
