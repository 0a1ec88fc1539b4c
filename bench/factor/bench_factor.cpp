#include <CLI/CLI.hpp>
#include <iostream>

#include "bench/draw/machine.hpp"
#include "bench/draw/report.hpp"
#include "bench/draw/scratch_folder.hpp"
#include "bench/factor/measure.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"

/// Times sampling, solve and factor step, against NumPy and SciPy where they are installed.
namespace twofold::bench {
namespace {

struct Options {
    std::string json, markdown, scene, python = "python3";
    int largest = 10000000;
};

void add(std::vector<FactorFigure>& all, const std::vector<FactorFigure>& more) {
    for (const FactorFigure& figure : more) {
        std::cout << line_of(figure) << std::endl;
        all.push_back(figure);
    }
}

std::vector<FactorFigure> measure(const Options& options) {
    const ScratchFolder scratch;
    const Peer peer{options.python, scratch.path()};
    std::vector<FactorFigure> all;
    add(all, measure_growth(options.largest));  // first: no thread runs yet
    add(all, measure_sampling(peer));
    add(all, measure_clustered());
    add(all, measure_solvers(peer));
    add(all, measure_threads());
    if (!options.scene.empty()) add(all, measure_scene(options.scene));
    return all;
}

void run(const Options& options) {
    const std::vector<FactorFigure> figures = measure(options);
    if (!options.json.empty())
        write_file_atomically(options.json, json_of(figures, processor_name()));
    if (options.markdown.empty()) return;
    const std::string document = read_text_file(options.markdown, 1 << 20);
    write_file_atomically(options.markdown, with_table(document, markdown_of(figures),
                                                       options.markdown, "bench_factor"));
}

}  // namespace
}  // namespace twofold::bench

int main(int argc, char** argv) {
    twofold::bench::Options options;
    CLI::App app{"Measures how fast lighting is sampled and factored, against NumPy and SciPy."};
    app.add_option("--json", options.json, "write everything to this file");
    app.add_option("--markdown", options.markdown, "replace the table in this file");
    app.add_option("--scene", options.scene, "time this scene's factor step too");
    app.add_option("--python", options.python, "the interpreter that has NumPy and SciPy")
        ->capture_default_str();
    app.add_option("--largest", options.largest, "samples of the largest fit")
        ->check(CLI::Range(100000, 10000000))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        twofold::bench::run(options);
        return 0;
    } catch (const twofold::Error& error) {
        std::cerr << "bench_factor: " << error.what() << "\n";
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::cerr << "bench_factor: " << error.what() << "\n";
        return static_cast<int>(twofold::ExitCode::bad_file);
    }
}
