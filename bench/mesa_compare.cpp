#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "bench/deviations.hpp"
#include "bench/gl_context.hpp"
#include "bench/gl_frame.hpp"
#include "bench/report.hpp"
#include "bench/tables.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

/// Draws the same frames with our reference pipeline and with OpenGL's fixed function and says how
/// far the pictures are apart.
namespace twofold::bench {
namespace {

struct Options {
    std::string json;      ///< file of the report for machines
    std::string only;      ///< part of the names of the checks to run
    std::string pictures;  ///< folder for the pictures of failed rows
};

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// llvmpipe filters 8-bit textures with 8-bit weights unless its own switch turns that off.
Driver describe(const GlContext& context) {
    const std::string renderer = context.renderer();
    Driver driver{renderer.substr(0, renderer.find_first_of(" (")), false};
    const bool switched = environment("GALLIVM_PERF").find("no_aos_sampling") != std::string::npos;
    driver.filters_in_float = driver.name == "softpipe" || (driver.name == "llvmpipe" && switched);
    return driver;
}

void write_file(const std::string& path, const void* data, std::size_t size) {
    std::ofstream file(path, std::ios::binary);
    file.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    if (!file) throw Error(ExitCode::bad_file, path + ": cannot be written");
}

void write_picture(const std::string& path, const ByteImage& picture) {
    const auto png = encode_png(picture);
    write_file(path, png.data(), png.size());
}

Row judged(const Driver& driver, const Check& check, Preset preset) {
    Row row{check.name, preset, {}, check.bound, ""};
    if (!driver.filters_in_float) row.bound.steps += check.filter_slack;
    if (const auto deviation = known_deviation(driver, check.name, preset)) {
        row.bound = deviation->bound;
        row.reason = deviation->reason;
    }
    return row;
}

/// The frame that first leaves the bound, both ways.
void keep_pictures(const Options& options, const Row& row, const ByteImage& ours,
                   const ByteImage& theirs) {
    std::string name = row.name;
    for (char& c : name)
        if (c == ' ' || c == ':' || c == ',') c = '-';
    const std::string path = fmt::format("{}/{}-{}", options.pictures, name, name_of(row.preset));
    write_picture(path + "-ours.png", ours);
    write_picture(path + "-theirs.png", theirs);
}

std::vector<Row> run(const Driver& driver, const Check& check, const Options& options) {
    std::vector<Row> rows;
    for (const Preset preset : check.presets) rows.push_back(judged(driver, check, preset));
    for (const Frame& frame : check.frames()) {
        const ByteImage theirs = draw_with_gl(frame);
        const std::vector<bool> left_out =
            check.left_out ? check.left_out(frame) : std::vector<bool>{};
        for (Row& row : rows) {
            const Framebuffer drawn = render_reference(frame, row.preset);
            const ByteImage ours{drawn.width, drawn.height, drawn.bytes};
            const bool passed = row.passed();
            compare_pictures(ours, theirs, key_color, left_out, row.result);
            if (passed && !row.passed() && !options.pictures.empty())
                keep_pictures(options, row, ours, theirs);
        }
    }
    return rows;
}

std::vector<Check> all_checks() {
    std::vector<Check> checks = four_pass_checks();
    for (auto* more : {&environment_checks, &lookup_checks, &fragment_checks, &primitive_checks})
        for (Check& check : more()) checks.push_back(std::move(check));
    return checks;
}

int compare(const Options& options) {
    const GlContext context;
    const Driver driver = describe(context);
    std::cout << fmt::format("{}, OpenGL {}, filters in {}\n{}\n", context.renderer(),
                             context.version(), driver.filters_in_float ? "float" : "8 bits",
                             heading());
    std::vector<Row> rows;
    for (const Check& check : all_checks()) {
        if (check.name.find(options.only) == std::string::npos) continue;
        if (!check.driver.empty() && check.driver != driver.name) continue;
        for (const Row& row : run(driver, check, options)) {
            std::cout << text_of(row) << std::endl;
            rows.push_back(row);
        }
    }
    const auto failed =
        std::count_if(rows.begin(), rows.end(), [](const Row& r) { return !r.passed(); });
    std::cout << fmt::format("{} rows, {} failed\n", rows.size(), failed);
    if (!options.json.empty()) {
        const std::string json = json_of(driver, context.version(), rows);
        write_file(options.json, json.data(), json.size());
    }
    return static_cast<int>(failed == 0 ? ExitCode::ok : ExitCode::failure);
}

}  // namespace
}  // namespace twofold::bench

int main(int argc, char** argv) {
    twofold::bench::Options options;
    CLI::App app{"Compares the reference pipeline with an OpenGL driver's fixed function."};
    app.add_option("--json", options.json, "write all rows to this file");
    app.add_option("--only", options.only, "run the checks whose name holds this text");
    app.add_option("--pictures", options.pictures, "write the pictures of failed rows here");
    CLI11_PARSE(app, argc, argv);
    try {
        return twofold::bench::compare(options);
    } catch (const twofold::Error& error) {
        std::cerr << "mesa_compare: " << error.what() << "\n";
        return static_cast<int>(error.code());
    }
}
