// The proof that the fast pipeline gives the reference's bytes, on random states:
//   fast_equals_reference [--seed S] [--first N] [--count M] [--all-options] [--levels]
//                         [--simd WIDTH] [--trace] [-o DIR]
// Exit code 0 only if every byte and every bit of every value is the same.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

#include "raster/lanes.hpp"
#include "raster/vector_width.hpp"
#include "tests/raster/random/proof.hpp"

namespace {

using namespace twofold;
using namespace twofold::test;

struct Settings {
    std::uint64_t seed = 1;
    std::uint64_t first = 0;
    std::uint64_t count = 1000;
    bool all_options = false;
    bool levels = false;
    bool trace = false;
    std::uint64_t most_failures = 10;
    std::string folder = "fast_failures";
    std::string simd;  ///< empty: as wide as the processor has them
};

struct Totals {
    std::map<std::string_view, std::uint64_t> states;  ///< by preset
    std::uint64_t drawings = 0, failures = 0, passes = 0;
    std::uint64_t by_vectors = 0, joined = 0;                            ///< passes, see FastShare
    std::uint64_t triangles = 0, fragments = 0, written = 0, empty = 0;  ///< of the reference
};

/// Those of the state, or all of them.
std::vector<FastOptions> options_of(const Settings& settings, const RandomState& state) {
    if (!settings.all_options) return {state.options};
    std::vector<FastOptions> all;
    for (const bool fuse : {true, false})
        for (const int threads : {1, 2, 7}) all.push_back({threads, fuse});
    return all;
}

/// The reference, whose counters say whether the states are worth drawing.
Framebuffer counted(const RandomState& state, Totals& totals) {
    Framebuffer picture = by_reference(state);
    const DrawCounters& c = picture.counters;
    totals.triangles += c.set_up;
    totals.fragments += c.fragments;
    totals.written += c.written;
    totals.empty += c.written == 0 ? 1 : 0;
    return picture;
}

void check_state(const Settings& settings, std::uint64_t number, Totals& totals) {
    if (settings.trace) fmt::print(stderr, "state {}\n", number);
    RandomState state = settings.levels ? random_state_with_levels(settings.seed, number)
                                        : random_state(settings.seed, number);
    ++totals.states[name_of(state.preset)];
    totals.passes += state.frame.passes.size();
    const FastShare share = fast_share(state);
    totals.by_vectors += share.by_vectors;
    totals.joined += share.joined;
    for (const FastOptions& options : options_of(settings, state)) {
        state.options = options;
        ++totals.drawings;
        const auto mismatch = difference(
            state, [&](const RandomState& s) { return counted(s, totals); }, by_fast);
        if (!mismatch) continue;
        ++totals.failures;
        fmt::print("{}", failure_report(settings.seed, number, state, *mismatch, by_fast,
                                        settings.folder));
        return;
    }
}

Settings parsed(int argc, char** argv, CLI::App& app) {
    Settings s;
    app.add_option("--seed", s.seed, "of the sequence of states");
    app.add_option("--first", s.first, "number of the first state");
    app.add_option("--count", s.count, "how many states");
    app.add_option("--most-failures", s.most_failures, "stop after so many");
    app.add_flag("--all-options", s.all_options, "threads 1, 2, 7 x fused or not for every state");
    app.add_flag("--levels", s.levels, "textures have mipmaps, and units choose among them");
    app.add_flag("--trace", s.trace, "print each state's number before it is drawn");
    app.add_option("--simd", s.simd, "vectors at most so wide: baseline, sse4, avx2, avx3");
    app.add_option("-o", s.folder, "where failing states are written as scenes");
    app.parse(argc, argv);
    return s;
}

void print(const Totals& totals) {
    std::uint64_t states = 0;
    for (const auto& [preset, n] : totals.states) states += n;
    fmt::print("{} states of {} passes ({} by vectors, {} fused to the one before), {} drawings:",
               states, totals.passes, totals.by_vectors, totals.joined, totals.drawings);
    for (const auto& [preset, n] : totals.states) fmt::print(" {} {}", preset, n);
    fmt::print("; {} triangles, {} fragments, {} written, {} pictures with none\n",
               totals.triangles, totals.fragments, totals.written, totals.empty);
    fmt::print("{} states differ from the reference ({})\n", totals.failures,
               lanes::instruction_set());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("fast pipeline against the reference on random states");
    try {
        const Settings settings = parsed(argc, argv, app);
        if (!settings.simd.empty()) limit_vectors(settings.simd);
        Totals totals;
        for (std::uint64_t i = 0; i < settings.count; ++i)
            if (totals.failures < settings.most_failures)
                check_state(settings, settings.first + i, totals);
        print(totals);
        return totals.failures == 0 ? 0 : 2;
    } catch (const CLI::ParseError& e) {
        return app.exit(e);
    } catch (const std::exception& e) {
        fmt::print(stderr, "fast_equals_reference: {}\n", e.what());
        return 2;
    }
}
