#include <catch2/catch.hpp>

#include "scenes/json_text.hpp"
#include "tests/scenes/scene_text.hpp"

using namespace twofold;
using namespace twofold::scene_text;
using namespace twofold::scene_io;

namespace {

bool starts_with(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

std::string repeated(const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
}

}  // namespace

TEST_CASE("wrong syntax is an error with line and column") {
    CHECK(error_of("{\n  \"title\": \"a\"\n  \"image\": {}\n}") ==
          "x.json: line 3, column 9: syntax error while parsing object - unexpected string "
          "literal; expected '}'");
    CHECK(starts_with(error_of(""), "x.json: line 1, column 1: syntax error"));
    CHECK(starts_with(error_of("{} {}"), "x.json: line 1, column 4: syntax error"));
    CHECK(starts_with(error_of("{\"image\": NaN}"), "x.json: line 1, column 11: syntax error"));
    CHECK(starts_with(error_of("{\"a\": 1 /* no end"), "x.json: line 1, column 18: syntax error"));
}

TEST_CASE("a key that is written twice is an error that names it") {
    CHECK(error_of(R"({"image": {"width": 1, "height": 2, "width": 3}})") ==
          "x.json: image.width: is written twice");
    CHECK(error_of(R"({"objects": [{}, {"mesh": "a", "mesh": "a"}]})") ==
          "x.json: objects.1.mesh: is written twice");
    CHECK(error_of(R"({"title": "a", "\u0074itle": "b"})") == "x.json: title: is written twice");
    CHECK(error_of(R"({"image": {"width": 1}, "camera": {"width": 1}})") ==
          "x.json: camera.width: unknown field; did you mean 'eye'?");
}

TEST_CASE("a number beyond binary64 is an error that names the field") {
    CHECK(error_of(R"({"image": {"height": 2, "width": 1e999}})") ==
          "x.json: image.width: the number is too large for binary64");
    CHECK(error_of(R"({"camera": {"eye": [0, -1e999]}})") ==
          "x.json: camera.eye.1: the number is too large for binary64");
    CHECK(error_of(smallest, {"camera.near=1e-400"}) ==
          "x.json: camera.near: 0.0 is not in 0..1000000000 (0 excluded)");
    CHECK(error_of(smallest, {"camera.near=1e999"}) ==
          "x.json: camera.near: '1e999' is not a number");
}

TEST_CASE("nesting and size have limits") {
    CHECK(error_of(repeated("[", max_json_depth + 1)).find("nested deeper than 32 levels") !=
          std::string::npos);
    CHECK(error_of(repeated("[", max_json_bytes)).find("nested deeper") != std::string::npos);
    CHECK(error_of(repeated("{\"a\":", 100'000)).find("nested deeper") != std::string::npos);
    CHECK(error_of(repeated(" ", max_json_bytes + 1)) == "x.json: is larger than 1048576 bytes");
    CHECK(error_of(smallest + repeated(" ", max_json_bytes - smallest.size())) == "accepted");
}

TEST_CASE("bytes that are no text are errors and do not reach the terminal") {
    CHECK(error_of(smallest + '\0' + "garbage") ==
          "x.json: line 1, column " + std::to_string(smallest.size() + 1) + ": a NUL byte");
    CHECK(error_of(std::string("{\n\n \0}", 6)) == "x.json: line 3, column 2: a NUL byte");
    for (const std::string bad :
         {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"}) {
        const std::string error = error_of("{\"title\": \"" + bad + "\"}");
        CHECK(error.find("ill-formed UTF-8") != std::string::npos);
        CHECK(printable(error, error.size()) == error);
    }
    CHECK(error_of(R"({"\u001b[31m": 1})") ==
          "x.json: ?[31m: unknown field; did you mean 'title'?");
}

TEST_CASE("a long name is shortened in the error") {
    const std::string error = error_of("{\"" + repeated("a", 500'000) + "\": 1}");
    CHECK(error.size() < 200);
    CHECK(starts_with(error, "x.json: aaaa"));
}

TEST_CASE("every shipped scene cut short at any byte is an error") {
    for (const std::string& name : shipped) {
        const std::string text = contents(folder / name);
        const std::size_t end = text.rfind('}');
        REQUIRE(end != std::string::npos);
        for (std::size_t length = 0; length <= end; ++length)
            if (const auto error = error_of(text.substr(0, length));
                !starts_with(error, "x.json: "))
                FAIL(name << " cut to " << length << " bytes: " << error);
        CHECK(error_of(text.substr(0, end + 1)) == "accepted");
    }
}

TEST_CASE("a shipped scene with any one byte changed is a scene or an error", "[long]") {
    const std::string text = contents(folder / "two-passes.json");
    for (std::size_t i = 0; i < text.size(); ++i)
        for (const char byte : {'\0', '"', '{', ']', '9', '-', '\\', '\n', '\x7f', '\xff'}) {
            std::string changed = text;
            changed[i] = byte;
            const std::string error = error_of(changed);
            if (error != "accepted" && !starts_with(error, "x.json: "))
                FAIL("byte " << i << ": " << error);
        }
}

TEST_CASE("an override that cannot be applied is an error") {
    CHECK(error_of(smallest, {"image.width"}) ==
          "x.json: override 'image.width' is not of the form path.to.field=value");
    CHECK(error_of(smallest, {"image..width=1"}) ==
          "x.json: override 'image..width=1' has an empty name in its path");
    CHECK(error_of(smallest, {"=1"}) == "x.json: override '=1' has an empty name in its path");
    CHECK(error_of(smallest, {"passes.1.mesh=q"}) ==
          "x.json: passes.1.mesh: override: '1' is not an index of a list of 1 elements");
    CHECK(error_of(smallest, {"passes.-1.mesh=q"}) ==
          "x.json: passes.-1.mesh: override: '-1' is not an index of a list of 1 elements");
    CHECK(error_of(smallest, {"passes.0.mesh.x=q"}) ==
          "x.json: passes.0.mesh.x: override: what holds 'x' is a plain value");
    CHECK(error_of(smallest, {"title=\xff"}) == "x.json: title: override: '?' is not UTF-8");
    CHECK(error_of(smallest, {"image={\"width\":1,\"width\":2}"}) ==
          "x.json: image: width: is written twice");
    CHECK(error_of(smallest, {repeated("a.", 5000) + "b=1"}).size() < 300);
}

TEST_CASE("overrides change fields that are there, add known ones and replace lists") {
    const Scene scene = parse(one_object, {"objects.0.scale=2", "camera.near=0.5", "title=a = b",
                                           "presets=[\"gl13\"]", "objects.0.scale=3", "white=2e0"});
    CHECK(scene.objects[0].scale == 3.0);
    CHECK(scene.camera.near_plane == 0.5);
    CHECK(scene.title == "a = b");
    CHECK(scene.presets == std::vector<Preset>{Preset::gl13});
    CHECK(scene.white.radiance == 2.0);
}
