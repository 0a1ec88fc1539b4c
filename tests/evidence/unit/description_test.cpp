#include "tests/evidence/description.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/evidence/drawing.hpp"
#include "texunit/error.hpp"

namespace {

using namespace twofold;
using namespace twofold::evidence;

/// A 4 x 2 picture; its left half is drawn in a colour that a combiner passes on.
const std::string description_text = R"({
  "id": "Suite/Test", "capture": "results/Suite/Test.png",
  "framebuffer": {"width": 4, "height": 2, "format": "A8R8G8B8", "clear": [1, 2, 3, 4]},
  "textures": {}, "surfaces": {},
  "states": {"s": {"transform": {"mode": "screen"}, "cull": true, "shade": "smooth",
    "provoking": "last", "perspective": true, "units": [],
    "combiner": {"stages": [{}], "final": {
      "D": {"src": "v0", "chan": "rgb", "invert": false},
      "G": {"src": "v0", "chan": "alpha", "invert": false}}},
    "blend": {"enable": false}, "alpha_test": {"enable": false}, "color_mask": "rgba"}},
  "draws": [{"state": "s", "primitive": "quads", "common": {"diffuse8": [10, 20, 30, 40]},
    "vertices": [{"pos": [0, 0, 1, 1]}, {"pos": [2, 0, 1, 1]}, {"pos": [2, 2, 1, 1]},
                 {"pos": [0, 2, 1, 1]}]}],
  "compare": {"include": [[0, 0, 4, 2]], "exclude": [], "channels": "rgba"}
})";

std::string with(const std::string& from, const std::string& to) {
    std::string text = description_text;
    text.replace(text.find(from), from.size(), to);
    return text;
}

std::string error_of(const std::string& text) {
    try {
        parse_description(text, "t.json");
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a described quad is drawn where it lies and nowhere else", "[evidence]") {
    const ByteImage picture = draw(parse_description(description_text, "t.json"), Preset::gl13);
    const Rgba8 drawn{10, 20, 30, 40}, clear{1, 2, 3, 4};
    CHECK(picture.pixels ==
          std::vector<Rgba8>{drawn, drawn, clear, clear, drawn, drawn, clear, clear});
}

TEST_CASE("triangles that run counter-clockwise on the screen are dropped", "[evidence]") {
    const std::string turned = with(R"({"pos": [2, 0, 1, 1]}, {"pos": [2, 2, 1, 1]},
                 {"pos": [0, 2, 1, 1]})",
                                    R"({"pos": [0, 2, 1, 1]}, {"pos": [2, 2, 1, 1]},
                 {"pos": [2, 0, 1, 1]})");
    INFO(turned);
    const ByteImage picture = draw(parse_description(turned, "t.json"), Preset::gl13);
    CHECK(picture.pixels == std::vector<Rgba8>(8, Rgba8{1, 2, 3, 4}));
}

TEST_CASE("unknown fields and values are named with their place", "[evidence]") {
    CHECK_THAT(error_of(with(R"("cull")", R"("Cull")")),
               Catch::Contains("t.json: states.s.Cull: unknown field"));
    CHECK_THAT(error_of(with(R"("smooth")", R"("rough")")),
               Catch::Contains("states.s.shade: unknown value 'rough'"));
    CHECK_THAT(error_of(with(R"("state": "s")", R"("state": "t")")),
               Catch::Contains("draws.0: 't' is not there"));
    CHECK_THAT(error_of(with(R"("rgba"}},)", R"("abgr"}},)")),
               Catch::Contains("color_mask: 'abgr'"));
    CHECK_THAT(error_of(with("[10, 20, 30, 40]", "[10, 20, 30, 256]")),
               Catch::Contains("draws.0.common.diffuse8.3: 256 is not in 0..255"));
    CHECK_THAT(error_of(with(R"({"pos": [0, 0, 1, 1]})",
                             R"({"pos": [0, 0, 1, 1], "diffuse8": [0, 0, 0, 0]})")),
               Catch::Contains("is given in 'common' too"));
    CHECK_THAT(error_of(with("results/", "../")), Catch::Contains("not a path below"));
}

TEST_CASE("colours as bit patterns keep the sign of what is not a number", "[evidence]") {
    const std::string bits =
        with(R"("diffuse8": [10, 20, 30, 40])",
             R"("diffuse_bits": ["0xffc00000", "0x7fc00000", "0x3f800000", "0xff800000"])");
    const Description description = parse_description(bits, "t.json");
    const Vec4 color = std::get<DrawCommand>(description.commands[0].what).mesh.colors[0];
    CHECK((std::isnan(color.x) && std::signbit(color.x)));
    CHECK((std::isnan(color.y) && !std::signbit(color.y)));
    CHECK(color.z == 1.0);
    CHECK((std::isinf(color.w) && color.w < 0));
    CHECK_THAT(error_of(with(R"("diffuse8": [10, 20, 30, 40])",
                             R"("diffuse_bits": ["0xffc0000", "0x0", "0x0", "0x0"])")),
               Catch::Contains("'0xffc0000' is not 0x and 8 hexadecimal digits"));
}
