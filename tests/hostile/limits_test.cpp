#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <string>

#include "scenes/json_text.hpp"
#include "scenes/scene_file.hpp"
#include "study/sweep/study_file.hpp"
#include "tests/refusal.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

using namespace twofold;
using Catch::Contains;
using twofold::cases::refusal;

namespace {

const std::string smallest = R"({"meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})";

std::string scene_refusal(const std::string& change) {
    return refusal(ExitCode::failure, [&] { parse_scene(smallest, "x.json", "", {change}); });
}

std::string study_refusal(const std::string& text) {
    return refusal(ExitCode::failure, [&] { parse_study(text, "s.json"); });
}

std::string repeated(const std::string& part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
}

/// The most memory that this process has had, KiB.
long peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

const std::string one_axis = R"({"name": "a", "path": "white", "values": [1]})";

}  // namespace

TEST_CASE("1e9 pixels and 1e12 samples are refused by field and value, without their memory",
          "[hostile]") {
    const long before = peak_memory();
    CHECK(scene_refusal("image.width=1000000000") ==
          "x.json: image.width: 1000000000 is not in 1..16384");
    CHECK(scene_refusal("image.height=1e9") ==
          "x.json: image.height: 1000000000.0 is not in 1..16384");
    CHECK(scene_refusal("factorization.samples=1000000000000") ==
          "x.json: factorization.samples: 1000000000000 is not in 1..10000000");
    CHECK(scene_refusal("factorization.held_out=1e12") ==
          "x.json: factorization.held_out: 1000000000000.0 is not in 1..10000000");
    CHECK(scene_refusal("factorization.map_size=65536") ==
          "x.json: factorization.map_size: 65536 is not in 4..512");
    CHECK(scene_refusal("environment={\"painted\":{\"width\":1000000,\"height\":1000000}}") ==
          "x.json: environment.painted.width: 1000000 is not in 4..4096");
    CHECK(scene_refusal("meshes.q={\"sphere\":{\"subdivisions\":100000}}") ==
          "x.json: meshes.q.sphere.subdivisions: 100000 is not in 1..256");
    CHECK(scene_refusal("textures.t.checkerboard.width=2147483648") ==
          "x.json: textures.t.checkerboard.width: 2147483648 is not in 1..4096");
    CHECK(peak_memory() - before < 16 * 1024);
}

TEST_CASE("counts of a scene beyond every integer type are refused", "[hostile]") {
    for (const char* value :
         {"0", "-1", "-2147483648", "2147483648", "4294967297", "9223372036854775808",
          "-9223372036854775809", "18446744073709551616", "1e308", "-1e308", "1.5"})
        for (const char* field : {"image.width", "image.height", "factorization.samples"}) {
            CAPTURE(field, value);
            CHECK_THAT(scene_refusal(std::string(field) + "=" + value),
                       Contains(std::string("x.json: ") + field + ": "));
        }
    for (const char* value : {"null", "true", "[]", "{}", "nan", "inf", "-", "0x10", "1e999"})
        CHECK_THAT(scene_refusal(std::string("image.width=") + value),
                   Contains("x.json: image.width: ") && Contains("is not a number"));
}

TEST_CASE("a study file is held to the same limits as a scene", "[hostile]") {
    CHECK(study_refusal("{\"axes\": [" + one_axis + "]}") == "accepted");
    CHECK_THAT(study_refusal(repeated("[", 100)), Contains("nested deeper than 32 levels"));
    CHECK_THAT(study_refusal("{\"title\": \"a\", \"title\": \"b\"}"),
               Contains("s.json: title: is written twice"));
    CHECK_THAT(study_refusal("{\"title\": \"\xff\"}"), Contains("ill-formed UTF-8"));
    CHECK_THAT(study_refusal("{\"axes\": 1e999}"),
               Contains("s.json: axes: the number is too large"));
    CHECK_THAT(study_refusal("{}"), Contains("s.json: the field 'axes' is missing"));
    CHECK_THAT(study_refusal("{\"axes\": []}"),
               Contains("s.json: axes: has 0 elements, not 1..64"));
    CHECK_THAT(study_refusal("{\"axes\": [" + repeated(one_axis + ",", 64) + one_axis + "]}"),
               Contains("s.json: axes: has 65 elements, not 1..64"));
    CHECK_THAT(study_refusal("{\"axes\": [" + one_axis + "," + one_axis + "]}"),
               Contains("s.json: axes: two axes are named 'a'"));
    const std::string many = repeated("1,", 256) + "1";
    CHECK_THAT(
        study_refusal(R"({"axes": [{"name": "a", "path": "white", "values": [)" + many + "]}]}"),
        Contains("s.json: axes.0.values: has 257 elements, not 1..256"));
    for (const char* rounds : {"0", "-1", "2147483648", "9223372036854775808", "1.5"})
        CHECK_THAT(study_refusal(std::string("{\"timing\": {\"least_rounds\": ") + rounds + "}}"),
                   Contains("s.json: timing.least_rounds: "));
    CHECK_THAT(
        study_refusal(
            R"({"axes": [{"name": "a", "scenes": ["../x.json"], "path": "white", "values": [1]}]})"),
        Contains("s.json: axes.0.scenes.0: '../x.json' is not the name of a file"));
}

TEST_CASE("every shipped study cut short at any byte is an error", "[hostile][long]") {
    for (const char* name : {"quick.json", "claim.json"}) {
        const std::string text = read_text_file(
            std::filesystem::path(TWOFOLD_SOURCE_DIR) / "study" / name, scene_io::max_json_bytes);
        REQUIRE(study_refusal(text) == "accepted");
        for (std::size_t length = 0; length < text.rfind('}'); ++length)
            if (const auto error = study_refusal(text.substr(0, length));
                error.rfind("s.json: ", 0) != 0)
                FAIL(name << " cut to " << length << " bytes: " << error);
    }
}
