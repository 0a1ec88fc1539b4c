#include "tests/evidence/comparison.hpp"

#include <catch2/catch.hpp>

#include "tests/evidence/results.hpp"

namespace {

using namespace twofold;
using namespace twofold::evidence;
using Pixels = std::vector<std::pair<int, int>>;

ByteImage black(int width, int height) {
    return {width, height,
            std::vector<Rgba8>(static_cast<std::size_t>(width * height), Rgba8{0, 0, 0, 255})};
}

const CompareRegion everywhere{{{0, 0, 4, 3}}, {}, {true, true, true, true}};

/// A test whose pixels (0, 0) ... are wrong, and what its description says of it.
TestResult result_with(int wrong, std::optional<Expectation> expectation) {
    TestResult result;
    result.id = "Suite/Test";
    result.comparison.compared = 1000;
    result.expectation = std::move(expectation);
    for (int x = 0; x < wrong; ++x) {
        result.comparison.wrong.emplace_back(x, 0);
        result.comparison.wrong_beyond.emplace_back(x, 0);
    }
    return result;
}

}  // namespace

TEST_CASE("a difference of one step in one channel is a wrong pixel", "[evidence]") {
    const ByteImage capture = black(4, 3);
    ByteImage ours = capture;
    ours.pixels[6].a = 254;
    const Comparison c = compare(ours, capture, everywhere, {});
    CHECK(c.compared == 12);
    CHECK(c.max_difference == 1);
    CHECK(c.wrong == Pixels{{2, 1}});
    CHECK(c.wrong_beyond == c.wrong);
}

TEST_CASE("only included pixels, but for excluded ones, and named channels are compared",
          "[evidence]") {
    const ByteImage capture = black(4, 3);
    ByteImage ours = capture;
    for (Rgba8& pixel : ours.pixels) pixel = {1, 0, 0, 0};
    const CompareRegion some{{{0, 0, 2, 3}, {1, 0, 2, 3}}, {{-5, 1, 100, 1}}, {1, 0, 0, 0}};
    const Comparison c = compare(ours, capture, some, {});
    CHECK(c.compared == 6);  // the overlap counts once
    CHECK(c.wrong == Pixels{{0, 0}, {1, 0}, {2, 0}, {0, 2}, {1, 2}, {2, 2}});
    CHECK(compare(ours, capture, {some.include, {}, {0, 1, 1, 0}}, {}).wrong.empty());
}

TEST_CASE("a wrong pixel that was expected is wrong, but not beyond what was expected",
          "[evidence]") {
    const ByteImage capture = black(4, 3);
    ByteImage ours = capture;
    ours.pixels[0].r = 255;
    ours.pixels[1].r = 255;
    const Comparison c = compare(ours, capture, everywhere, {{1, 0}, {3, 2}});
    CHECK(c.wrong == Pixels{{0, 0}, {1, 0}});
    CHECK(c.wrong_beyond == Pixels{{0, 0}});
}

TEST_CASE("pictures of different sizes and regions outside are errors", "[evidence]") {
    CHECK_THROWS_AS(compare(black(4, 3), black(3, 4), everywhere, {}), Error);
    CHECK_THROWS_AS(compare(black(3, 3), black(3, 3), everywhere, {}), Error);
}

TEST_CASE("the difference picture marks wrong pixels within the region alone", "[evidence]") {
    const ByteImage capture = black(2, 1);
    ByteImage ours = capture;
    for (Rgba8& pixel : ours.pixels) pixel.g = 2;
    const ByteImage picture =
        difference_picture(ours, capture, {{{1, 0, 1, 1}}, {}, {true, true, true, true}});
    CHECK(picture.pixels == std::vector<Rgba8>{{0, 0, 0, 255}, {255, 16, 0, 255}});
}

TEST_CASE("the verdict forgives only what the independent renderer got wrong too", "[evidence]") {
    const Expectation reproduced;
    Expectation deviates;
    deviates.reproduced = false;
    deviates.pixels_wrong = 2;
    Expectation hopeless = deviates;
    hopeless.pixels_wrong = 500;
    CHECK(verdict({result_with(0, reproduced)}) == ExitCode::ok);
    CHECK(verdict({result_with(1, reproduced)}) == ExitCode::failure);
    CHECK(verdict({result_with(1, std::nullopt)}) == ExitCode::failure);
    CHECK(verdict({result_with(2, deviates)}) == ExitCode::ok);
    CHECK(verdict({result_with(3, deviates)}) == ExitCode::failure);
    CHECK(verdict({result_with(11, hopeless)}) == ExitCode::failure);
    TestResult unreadable = result_with(0, reproduced);
    unreadable.error = "no such file";
    CHECK(verdict({result_with(1, reproduced), unreadable}) == ExitCode::bad_file);
}

TEST_CASE("a tally counts passed, reproduced and unreadable tests apart", "[evidence]") {
    TestResult listed = result_with(1, std::nullopt);
    listed.comparison.wrong_beyond.clear();
    TestResult unreadable;
    unreadable.error = "no such file";
    const Tally t =
        tally_of({result_with(0, std::nullopt), listed, unreadable, result_with(2, std::nullopt)});
    CHECK(t.tests == 4);
    CHECK(t.passed == 2);
    CHECK(t.reproduced == 1);
    CHECK(t.unreadable == 1);
    CHECK(t.compared == 3000);
    CHECK(t.wrong == 3);
    CHECK(t.wrong_beyond == 2);
}
