#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "scenes/json_text.hpp"
#include "tests/evidence/drawing.hpp"
#include "tests/evidence/results.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"
#include "texunit/parallel.hpp"
#include "texunit/self_check.hpp"

/// Draws what captures of real silicon show and counts the pixels that differ.
namespace {

using namespace twofold;
using namespace twofold::evidence;
namespace fs = std::filesystem;

struct Options {
    std::string pack;
    std::string preset = "nv2x";
    std::string json;
    std::string diff;
    std::string only;
    int threads = 0;
};

void define(CLI::App& app, Options& options) {
    app.add_option("DIR", options.pack, "Pack: SUITE/TEST.json and the captures they name")
        ->required();
    app.add_option("--preset", options.preset, "Numeric preset")->capture_default_str();
    app.add_option("--json", options.json, "Write the results to this file too");
    app.add_option(
        "--diff", options.diff,
        "For each failing test write ours.png, capture.png and diff.png below this folder");
    app.add_option("--only", options.only, "Only tests whose SUITE/TEST begins so");
    app.add_option("-j,--threads", options.threads, "Threads; 0 = all")->check(CLI::Range(0, 1024));
    app.footer(
        "Example: evidence captures --only Texgen --diff out\n"
        "Exit codes: 0 every test that its description calls reproduced is, 2 wrong pixels,\n"
        "4 a description or capture that cannot be read or drawn");
}

Preset preset_of(const std::string& name) {
    if (const auto preset = preset_named(name)) return *preset;
    throw Error(ExitCode::failure, "--preset: unknown preset '" + name + "'");
}

/// Every SUITE/TEST.json below the pack's folder, sorted.
std::vector<fs::path> descriptions_in(const fs::path& pack, const std::string& prefix) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const auto& suite : fs::directory_iterator(pack, failed)) {
        if (!suite.is_directory() || suite.path().filename() == "results") continue;
        for (const auto& file : fs::directory_iterator(suite.path()))
            if (file.path().extension() == ".json") files.push_back(file.path());
    }
    if (failed) throw Error(ExitCode::bad_file, pack.string() + ": " + failed.message());
    files.erase(std::remove_if(files.begin(), files.end(),
                               [&](const fs::path& file) {
                                   const std::string id =
                                       (file.parent_path().filename() / file.stem()).string();
                                   return id.compare(0, prefix.size(), prefix) != 0;
                               }),
                files.end());
    if (files.empty()) throw Error(ExitCode::bad_file, pack.string() + ": no description to draw");
    std::stable_sort(files.begin(), files.end());
    return files;
}

void write_pictures(const fs::path& folder, const ByteImage& ours, const ByteImage& capture,
                    const CompareRegion& region) {
    fs::create_directories(folder);
    write_file_atomically(folder / "ours.png", encode_png(ours));
    write_file_atomically(folder / "capture.png", encode_png(capture));
    write_file_atomically(folder / "diff.png",
                          encode_png(difference_picture(ours, capture, region)));
}

/// The two sides count the compared pixels independently, so a wrong rectangle is noticed.
void check_count(const TestResult& result) {
    if (result.expectation && result.expectation->pixels_compared != result.comparison.compared)
        throw Error(ExitCode::failure,
                    fmt::format("check.pixels_compared: {} is not the {} pixels of 'compare'",
                                result.expectation->pixels_compared, result.comparison.compared));
}

void run_test(const fs::path& file, const Options& options, Preset preset, TestResult& result) {
    const Description description =
        parse_description(read_text_file(file, scene_io::max_json_bytes), result.id + ".json");
    if (description.id != result.id)
        throw Error(ExitCode::failure, "id: '" + description.id + "' is not the file's place");
    result.expectation = description.expectation;
    const ByteImage capture = read_png(fs::path(options.pack) / description.capture);
    const ByteImage ours = draw(description, preset);
    result.comparison = compare(ours, capture, description.region,
                                description.expectation ? description.expectation->deviating_pixels
                                                        : std::vector<std::pair<int, int>>{});
    if (!options.diff.empty() && !passed(result))
        write_pictures(fs::path(options.diff) / result.id, ours, capture, description.region);
    check_count(result);
}

TestResult result_of(const fs::path& file, const Options& options, Preset preset) {
    TestResult result;
    result.id = (file.parent_path().filename() / file.stem()).string();
    try {
        run_test(file, options, preset, result);
    } catch (const Error& e) {
        result.error = e.what();
        result.comparison = {};  // of what is wrong in itself no pixel counts
    }
    return result;
}

ExitCode run(const Options& options) {
    const Preset preset = preset_of(options.preset);
    const auto files = descriptions_in(options.pack, options.only);
    std::vector<TestResult> results(files.size());
    parallel_for(files.size(), options.threads,
                 [&](std::size_t i) { results[i] = result_of(files[i], options, preset); });
    fmt::print("{}", text_of(results));
    if (!options.json.empty())
        write_file_atomically(options.json, scene_io::to_text(json_of(results, options.preset)));
    return verdict(results);
}

int complain(ExitCode code, const std::string& text) {
    fmt::print(stderr, "evidence: {}\n", text);
    return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) try {
    if (const std::string defects = floating_point_defects(); !defects.empty())
        return complain(ExitCode::inexact_build, "this build or process is not exact: " + defects);
    CLI::App app{"Draws what captures of real silicon show and counts the pixels that differ",
                 "evidence"};
    Options options;
    define(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::failure);
    }
    return static_cast<int>(run(options));
} catch (const twofold::Error& e) {
    return complain(e.code(), e.what());
} catch (const std::exception& e) {
    return complain(ExitCode::failure, e.what());
}
