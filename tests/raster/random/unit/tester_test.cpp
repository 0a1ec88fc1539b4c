#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "tests/raster/random/proof.hpp"
#include "tests/raster/random/shrink.hpp"
#include "tests/raster/random/state_scene.hpp"
#include "tests/temporary_folder.hpp"
#include "texunit/error.hpp"

/// The tester itself: it sees what is planted, makes it small and writes it down.
namespace {
using namespace twofold;
using namespace twofold::test;

constexpr std::uint64_t seed = 7;

/// The state's passes that blend.
RandomState blending_part(RandomState state) {
    std::erase_if(state.frame.passes, [](const Pass& pass) { return !pass.state.blend; });
    return state;
}

/// The reference with one value changed in the last bit where a pass that blends draws something.
Framebuffer planted(const RandomState& state) {
    Framebuffer picture = by_reference(state);
    if (by_reference(blending_part(state)).counters.fragments > 0)
        picture.values.back()[2] = std::nextafter(picture.values.back()[2], 2.0);
    return picture;
}

/// The first state of the sequence in which the planted fault shows.
std::uint64_t first_fault() {
    for (std::uint64_t i = 0;; ++i)
        if (difference(random_state(seed, i), by_reference, planted)) return i;
}

/// The state as its scene file describes it; none if a scene file cannot.
std::optional<RandomState> through_a_file(const RandomState& state, const TemporaryFolder& folder) {
    try {
        for (const std::string& note : write_state(state, folder.path(), "state"))
            if (note == floats_became_bytes || note == background_is_rounded) return std::nullopt;
        return read_state(state, folder / "state.json");
    } catch (const Error&) {
        return std::nullopt;
    }
}

Framebuffer small_picture() {
    Framebuffer picture{3, 2, {}, {}, {}};
    picture.bytes.resize(6, {1, 2, 3, 4});
    picture.values.resize(6, {0.25, 0.5, 0.75, 1.0});
    return picture;
}

}  // namespace

TEST_CASE("pictures are the same only if every byte and every bit is") {
    const Framebuffer a = small_picture();
    Framebuffer b = a;
    CHECK_FALSE(mismatch_of(a, b));
    b.counters.fragments = 9;
    CHECK_FALSE(mismatch_of(a, b));

    b.bytes[4].g = 0;
    b.bytes[5].a = 0;
    const auto bytes = mismatch_of(a, b);
    REQUIRE(bytes);
    CHECK(bytes->pixels == 2);
    CHECK(bytes->x == 1);
    CHECK(bytes->y == 1);
    CHECK(bytes->text.find("(1 0 3 4)") != std::string::npos);
}

TEST_CASE("pictures differ by the sign of a zero and by a size") {
    Framebuffer a = small_picture(), b = a;
    a.values[0][0] = 0.0;
    b.values[0][0] = -0.0;
    CHECK(mismatch_of(a, b));
    a.values[0][0] = b.values[0][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(mismatch_of(a, b));
    b.height = 1;
    CHECK(mismatch_of(a, b));
}

TEST_CASE("random states depend on seed and number alone and take turns") {
    CHECK_FALSE(
        mismatch_of(by_reference(random_state(seed, 5)), by_reference(random_state(seed, 5))));
    std::set<std::pair<int, bool>> options;
    std::set<Preset> presets;
    for (std::uint64_t i = 0; i < 7 * 12; ++i) {
        const RandomState state = random_state(seed, i);
        presets.insert(state.preset);
        if (state.preset == Preset::nv17)
            options.insert({state.options.threads, state.options.fuse});
    }
    CHECK(presets.size() == 7);
    CHECK(options.size() == 6);
}

TEST_CASE(
    "a planted fault is found, shrunk to one pass and one primitive, and its scene shows it") {
    const std::uint64_t number = first_fault();
    const RandomState state = random_state(seed, number);
    const auto fails = [](const RandomState& s) {
        return difference(s, by_reference, planted).has_value();
    };
    const RandomState small = shrunk(state, fails);
    REQUIRE(fails(small));
    CHECK(small.frame.passes.size() == 1);
    CHECK(small.frame.meshes.size() == 1);
    CHECK(small.frame.meshes[0].indices.size() <= 4);
    CHECK(small.frame.textures.empty());
    CHECK(small.frame.passes[0].state.blend);
    CHECK_FALSE(small.frame.passes[0].state.depth_test);

    const TemporaryFolder folder;
    const std::string report = failure_report(
        seed, number, state, *difference(state, by_reference, planted), planted, folder.path());
    CHECK(report.find("seed 7, state " + std::to_string(number)) == 0);
    CHECK(report.find("-small.json (fails as well)") != std::string::npos);
    CHECK(report.find("(does NOT fail") == std::string::npos);
}

TEST_CASE("the scene of a random state draws the state's own picture", "[long]") {
    const TemporaryFolder folder;
    int compared = 0;
    for (std::uint64_t i = 0; i < 280; ++i) {
        const RandomState state = random_state(seed, i);
        const auto again = through_a_file(state, folder);
        if (!again) continue;
        const auto mismatch = mismatch_of(by_reference(state), by_reference(*again));
        INFO("state " << i << ": " << (mismatch ? mismatch->text : ""));
        CHECK_FALSE(mismatch);
        ++compared;
    }
    CHECK(compared > 200);
}
