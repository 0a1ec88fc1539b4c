#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "bench/draw/drawing.hpp"
#include "bench/draw/machine.hpp"
#include "bench/draw/report.hpp"
#include "bench/draw/scratch_folder.hpp"
#include "raster/vector_width.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

/// Draws the same inputs with twofold and with its peers, in turn, and says how fast each is.
namespace twofold::bench {
namespace {

struct Options {
    std::string peers, json, markdown;
    bool quick = false, baseline = false, first_picture = false;
    int rounds = 5;
    double seconds = 0.3, enforce = 0.0;
    std::vector<std::string> child;
};

/// What --child is asked for: one drawing in a process of its own. Prints seconds of a frame
/// (processor, its median, wall) and the most MiB that the process held before it drew and ever.
void draw_as_child(const std::vector<std::string>& arguments) {
    const auto integer = [&](std::size_t i) {
        return static_cast<int>(parse_integer(arguments[i]).value_or(0));
    };
    const Source source{arguments[0], integer(1), integer(2),
                        arguments.size() > 5 ? arguments[5] : ""};
    const Frame frame = frame_of(load(source));
    const double before = peak_mebibytes();
    const FastFrame fast = prepare_fast(frame, preset_named(arguments[3]).value_or(Preset::nv17));
    const FrameTimes times = time_frames(fast.draw, parse_real(arguments[4]).value_or(0.0), 3);
    fmt::print("{:.9e} {:.9e} {:.9e} {:.1f} {:.1f}\n", times.cpu, times.cpu_median, times.wall,
               before, peak_mebibytes());
}

void draw_first_picture() {
    const Frame frame = frame_of(make_inputs("tex2-persp", 0, 64));
    if (covered_pixels(render_fast(frame, Preset::nv17).bytes) != 64.0 * 64.0)
        throw Error(ExitCode::failure, "the first picture is not covered");
}

void say(const std::string& line) { std::cout << line << std::endl; }

void measure_works(const Settings& settings, const std::vector<Work>& works, DrawReport& report) {
    say(row_heading());
    for (const Work& work : works) {
        const PreparedWork prepared = prepare(settings, work);
        for (const PictureCheck& check : prepared.pictures) {
            std::cerr << line_of(check) << "\n";
            report.pictures.push_back(check);
        }
        for (const Row& row : hold(prepared.contest)) {
            say(line_of(row));
            report.rows.push_back(row);
        }
    }
}

void measure_figures(const Settings& settings, bool quick, DrawReport& report) {
    report.figures = measure_first_picture(settings);
    if (!quick) {
        for (const Figure& figure : measure_memory(settings)) report.figures.push_back(figure);
        report.growth = measure_growth(settings);
    }
    for (const Figure& figure : report.figures) say(line_of(figure));
    for (const Series& series : report.growth) std::cout << lines_of(series) << std::flush;
}

void write_outputs(const Options& options, const DrawReport& report) {
    if (!options.json.empty()) write_file_atomically(options.json, json_of(report));
    if (options.markdown.empty()) return;
    const std::string document = read_text_file(options.markdown, 1 << 20);
    write_file_atomically(options.markdown,
                          with_table(document, markdown_of(report), options.markdown));
}

Settings settings_of(const Options& options, const fs::path& scratch) {
    Settings settings{{},
                      scratch,
                      fs::read_symlink("/proc/self/exe"),
                      options.seconds,
                      options.rounds,
                      options.baseline};
    if (options.peers.empty())
        std::cerr << "bench_draw: NO PEERS: neither --peers nor TWOFOLD_PEERS names the folder of "
                     "their programs, so there are only our own figures, of inputs made here\n";
    else
        settings.peers = fs::absolute(options.peers);
    return settings;
}

/// Wrong pictures always fail; slow rows only if asked.
ExitCode outcome(const Options& options, const DrawReport& report) {
    ExitCode code = ExitCode::ok;
    for (const PictureCheck& check : report.pictures)
        if (!check.passed()) code = ExitCode::failure;
    for (const Row& row : report.rows)
        if (options.enforce > 0.0 && !meets_floor(row, options.enforce)) {
            std::cerr << fmt::format("bench_draw: below {} of the floor: {}\n", options.enforce,
                                     line_of(row));
            code = ExitCode::failure;
        }
    return code;
}

ExitCode bench(const Options& options) {
    const ScratchFolder scratch;
    const Settings settings = settings_of(options, scratch.path());
    DrawReport report{processor_name(), {}, {}, {}, {}};
    measure_works(settings, options.quick ? quick_works() : all_works(), report);
    measure_figures(settings, options.quick, report);
    write_outputs(options, report);
    return outcome(options, report);
}

ExitCode run(const Options& options) {
    if (options.first_picture) {
        draw_first_picture();
        return ExitCode::ok;
    }
    if (!options.child.empty()) {
        draw_as_child(options.child);
        return ExitCode::ok;
    }
    return bench(options);
}

void declare(CLI::App& app, Options& options) {
    app.add_option("--peers", options.peers, "folder of the peers' programs")
        ->envname("TWOFOLD_PEERS");
    app.add_option("--json", options.json, "write everything to this file");
    app.add_option("--markdown", options.markdown, "replace the table in this file");
    app.add_option("--rounds", options.rounds, "of contestants drawing in turn")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "that a contestant draws in a round")
        ->check(CLI::Range(0.0, 60.0))
        ->capture_default_str();
    app.add_option("--enforce", options.enforce, "fail below this share of a floor; 0: never")
        ->check(CLI::Range(0.0, 1.0));
    app.add_flag("--quick", options.quick, "the most telling works only, at most a minute");
    app.add_flag("--baseline", options.baseline, "plain x86-64 too (TWOFOLD_SIMD=baseline)");
    app.add_flag("--first-picture", options.first_picture, "draw one picture of 64 x 64 and end");
    app.add_option("--child", options.child,
                   "draw in this process: DRAWING SQUARES SIZE PRESET SECONDS [DUMP]")
        ->expected(5, 6);
}

}  // namespace
}  // namespace twofold::bench

int main(int argc, char** argv) {
    twofold::bench::Options options;
    CLI::App app{"Measures how fast frames are drawn, against peers drawing the same inputs."};
    twofold::bench::declare(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        if (const char* widest = std::getenv("TWOFOLD_SIMD")) twofold::limit_vectors(widest);
        return static_cast<int>(twofold::bench::run(options));
    } catch (const twofold::Error& error) {
        std::cerr << "bench_draw: " << error.what() << "\n";
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::cerr << "bench_draw: " << error.what() << "\n";
        return static_cast<int>(twofold::ExitCode::bad_file);
    }
}
