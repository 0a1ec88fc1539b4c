#include "study/sweep/errors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "study/sweep/checks.hpp"
#include "study/sweep/drawing.hpp"
#include "study/sweep/figure.hpp"
#include "study/sweep/work.hpp"

using namespace twofold;

namespace {

using Bytes = std::array<int, 4>;

Framebuffer picture_of(const std::vector<Bytes>& pixels) {
    Framebuffer picture{static_cast<int>(pixels.size()), 1, {}, {}, {}};
    for (const Bytes& p : pixels) {
        const auto byte = [&](std::size_t c) { return static_cast<std::uint8_t>(p[c]); };
        picture.bytes.push_back({byte(0), byte(1), byte(2), byte(3)});
        picture.values.push_back({p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0});
    }
    return picture;
}

}  // namespace

TEST_CASE("errors of four pixels are those counted by hand") {
    const Framebuffer picture =
        picture_of({{255, 10, 0, 255}, {20, 30, 40, 255}, {0, 0, 0, 0}, {9, 9, 9, 255}});
    const Framebuffer reference =
        picture_of({{250, 10, 3, 255}, {20, 30, 40, 255}, {7, 7, 7, 255}, {9, 9, 209, 255}});
    const CellErrors e = errors_between(picture, reference, {false, false, false, true});
    CHECK(e.steps.pixels_compared == 2);  // one is not covered, one sees another surface
    CHECK(e.steps.coverage_differs == 2);
    CHECK(e.steps.max_steps == 5);
    CHECK(e.real_rms_steps == Approx(std::sqrt(34.0 / 6.0)).epsilon(1e-12));
    CHECK(e.steps.rms_steps == Approx(e.real_rms_steps).epsilon(1e-12));
    const double brightness = 250 * 250 + 10 * 10 + 3 * 3 + 20 * 20 + 30 * 30 + 40 * 40;
    CHECK(e.relative_rms == Approx(std::sqrt(34.0 / brightness)).epsilon(1e-12));
    CHECK(e.clipped_share == 0.5);
    CHECK(e.vanished_share == 0.5);
}

TEST_CASE("real values tell apart what bytes show alike") {
    Framebuffer a = picture_of({{100, 100, 100, 255}}), b = a;
    a.values[0][1] += 0.3 / 255.0;
    const CellErrors e = errors_between(a, b, {});
    CHECK(e.steps.rms_steps == 0.0);
    CHECK(e.real_rms_steps == Approx(0.3 / std::sqrt(3.0)).epsilon(1e-9));
}

TEST_CASE("the card's predicted time is the larger of its fill and its memory time") {
    Frame frame;
    frame.width = 100;
    frame.height = 10;
    FrameWork work;
    work.passes = 1;
    work.fragments = 5500;
    work.unit_cycles = 5500;
    work.written = 1000;
    work.alpha_failed = 500;
    const CardPrediction fill = predict(work, frame, mx440_8x);
    CHECK(fill.fill_seconds == Approx(5500.0 / 550e6).epsilon(1e-12));
    CHECK(fill.memory_seconds == Approx((1000 * 8 + 5000 * 4 + 1000 * 8) / 8e9).epsilon(1e-12));
    CHECK(fill.seconds == fill.fill_seconds);
    work.texture_reads = 1 << 20;
    work.blended = 2000;
    const CardPrediction memory = predict(work, frame, mx440_8x);
    CHECK(memory.seconds == Approx((36000 + (1 << 20) + 8000) / 8e9).epsilon(1e-12));
    CHECK(model_text(mx440_8x).find("not a measurement") != std::string::npos);
}

TEST_CASE("a filter is set in every unit, and trilinear comes with mipmaps") {
    Frame frame;
    frame.textures.push_back({4, 4, std::vector<Rgba8>(16)});
    Pass pass;
    pass.state.units[1] = TextureUnitState{};
    frame.passes = {pass};
    const auto unit = [](const Frame& f) { return *f.passes[0].state.units[1]; };
    CHECK(unit(with_filter(frame, TexelFilter::nearest)).min_filter == Filter::nearest);
    const Frame trilinear = with_filter(frame, TexelFilter::trilinear);
    CHECK(unit(trilinear).mip_filter == MipFilter::linear);
    CHECK(trilinear.textures[0].mipmaps.size() == 2);
    CHECK_FALSE(trilinear.passes[0].state.units[0]);
}

TEST_CASE("a figure has a button for every cell, and texts that cannot break out of it") {
    PointFigure figure{"f", "t", "<x>", "y'", true, true, {}, {{1, 2}, {3, 1}}};
    figure.series = {{"a & b", "axis", {{{1, 2}, "id1", "one \"1\""}, {{3, 1}, "", ""}}, true}};
    const std::string svg = svg_of(figure);
    CHECK(svg.find("data-cell='id1' tabindex='0' role='button'") != std::string::npos);
    CHECK(svg.find("&lt;x>") != std::string::npos);
    CHECK(svg.find("y&#39;") != std::string::npos);
    CHECK(svg.find("one &quot;1&quot;") != std::string::npos);
    CHECK(svg.find("class='front'") != std::string::npos);
    const std::string file = svg_file(svg, "text { fill: red }");
    CHECK(file.find("<style>text { fill: red }</style>") != std::string::npos);
    CHECK(svg_of(figure) == svg);
}

TEST_CASE("an axis is labelled at round numbers") {
    CHECK(axis_ticks(0.0, 16.0, false) == std::vector<double>{0, 2, 4, 6, 8, 10, 12, 14, 16});
    CHECK(axis_ticks(-0.1, 7.0, false).size() == 8);
    CHECK(axis_ticks(0.9, 1100.0, true).size() == 4);
    const auto few = axis_ticks(8.0, 64.0, true);
    CHECK(few.size() == 3);  // 10, 20, 50
    CHECK(axis_ticks(1.0, 1.0, false).empty());
}

TEST_CASE("outcomes are read from what ctest writes") {
    const auto checks = checks_of(
        "<testsuite tests=\"3\"><testcase name=\"raster: R01 a &lt; b\" classname=\"x\" "
        "status=\"run\"/><testcase name=\"R02 c\" status=\"fail\">"
        "</testcase><testcase name=\"scenes: d\" status=\"notrun\"/></testsuite>");
    CHECK(checks == std::map<std::string, std::string>{
                        {"R01 a < b", "passed"}, {"R02 c", "failed"}, {"d", "skipped"}});
}
