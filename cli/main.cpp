#include <execinfo.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "study/results_json.hpp"
#include "texunit/self_check.hpp"

namespace {

using namespace twofold;

struct Options {
    CommonOptions common;
    RunOptions run;
    FactorOptions factor;
    RenderOptions render;
    CompareOptions compare;
    ExplainOptions explain;
    StudyOptions study;
};

void add_common(CLI::App& command, CommonOptions& common, bool reads_scene) {
    command.add_flag("--json", common.json, "Print results as JSON");
    command.add_flag("-q,--quiet", common.quiet, "No progress");
    if (!reads_scene) return;
    command
        .add_option("-D,--define", common.overrides, "Change a scene field: path.to.field=value")
        ->allow_extra_args(false);
    command
        .add_option("-j,--threads", common.threads, "Threads; 0 = all. Results do not depend on it")
        ->check(CLI::Range(0, 1024));
}

void add_pipeline(CLI::App& command, std::string& pipeline) {
    command
        .add_option("--pipeline", pipeline,
                    "fast, or reference: the same bytes, and with --json its counted work")
        ->capture_default_str();
}

void define_run(CLI::App& app, Options& o) {
    auto* c = app.add_subcommand(
        "run", "Factor a scene, draw it in every preset it names, compare, report");
    c->add_option("SCENE", o.run.scene, "Scene file")->required();
    c->add_option("-o,--output", o.run.output, "Folder for report.html, pictures, manifest.json")
        ->capture_default_str();
    add_pipeline(*c, o.run.pipeline);
    add_common(*c, o.common, true);
    c->footer("Example: twofold run scenes/gold-suzanne.json -o out -D image.width=512");
}

void define_factor(CLI::App& app, Options& o) {
    auto* c =
        app.add_subcommand("factor", "Factor a scene's lighting functions into two textures each");
    c->add_option("SCENE", o.factor.scene, "Scene file")->required();
    c->add_option("-o,--output", o.factor.output, "Folder for the maps and factors.json")
        ->required();
    c->add_option("--solver", o.factor.solver,
                  "qmr, lsmr, cgls or qmr_augmented; without it the scene's");
    add_common(*c, o.common, true);
    c->footer("Example: twofold factor scenes/sphere-lobe.json -o maps --json");
}

void define_render(CLI::App& app, Options& o) {
    auto* c = app.add_subcommand("render", "Draw a scene under one preset");
    c->add_option("SCENE", o.render.scene, "Scene file")->required();
    c->add_option("-o,--output", o.render.output, "Picture: .png (8 bits) or .exr (binary32)")
        ->required();
    c->add_option("--preset", o.render.preset, "Numeric preset; without it the scene's first");
    add_pipeline(*c, o.render.pipeline);
    add_common(*c, o.common, true);
    c->footer("Example: twofold render scenes/two-passes.json -o quad.png --preset nv17");
}

void define_compare(CLI::App& app, Options& o) {
    auto* c = app.add_subcommand(
        "compare", "Compare two pictures exactly; exit code 0 only if they are equal");
    c->add_option("A", o.compare.a, "Picture")->required();
    c->add_option("B", o.compare.b, "Picture")->required();
    c->add_option("--diff", o.compare.diff, "Write a heat map of the differences (.png)");
    c->add_flag("--covered", o.compare.covered,
                "Only colours of pixels whose alpha is not 0 in both");
    add_common(*c, o.common, false);
    c->footer("Example: twofold compare golden.png out/nv17.png --diff diff.png");
}

void define_explain(CLI::App& app, Options& o) {
    auto* c = app.add_subcommand("explain",
                                 "Which stages run, why and at what cost; or a preset's table");
    c->add_option("SCENE", o.explain.scene, "Scene file");
    c->add_option("--preset", o.explain.preset, "Print the table of this numeric preset");
    c->add_flag("--cost", o.explain.cost,
                "Measure what each effect that is on adds to the scene's frame, in percent");
    add_common(*c, o.common, true);
    c->footer("Example: twofold explain --preset nv17");
}

void define_study(CLI::App& app, Options& o) {
    auto* c = app.add_subcommand("study", "What accuracy costs in time: a sweep and its report");
    c->add_option("SCENE", o.study.scene, "Scene file")->required();
    c->add_option("-o,--output", o.study.output, "Folder for cells, tables, figures, report.html")
        ->required();
    auto* file = c->add_option("--study", o.study.study, "Study file: the cells to be measured");
    auto* quick = c->add_flag("--quick", o.study.quick, "The shipped quick study: the default");
    quick->excludes(file);
    c->add_flag("--full", o.study.full, "The shipped full study")->excludes(file)->excludes(quick);
    auto* shard = c->add_option("--shard", o.study.shard,
                                "PART/PARTS: measure every PARTS-th cell, and write no report");
    c->add_option("--merge", o.study.merge, "Folders of shards: collect their cells, and report")
        ->excludes(shard);
    c->add_option("--checks", o.study.checks,
                  "Result file of this version's tests (ctest --output-junit), for the report");
    c->add_flag("--list", o.study.list, "Only print the cells and whether they are measured");
    add_common(*c, o.common, true);
    c->footer(
        "Example: twofold study scenes/gold-suzanne.json -o study-out\n"
        "Measured cells are kept: after an interruption the same command goes on.");
}

ExitCode dispatch(const CLI::App& app, const Options& o) {
    if (app.got_subcommand("run")) return run_command(o.run, o.common);
    if (app.got_subcommand("factor")) return factor_command(o.factor, o.common);
    if (app.got_subcommand("render")) return render_command(o.render, o.common);
    if (app.got_subcommand("compare")) return compare_command(o.compare, o.common);
    if (app.got_subcommand("study")) return study_command(o.study, o.common);
    return explain_command(o.explain, o.common);
}

/// Called where memory is out or the message cannot be written: neither may end the program before
/// it has given its code.
int complain(ExitCode code, std::string_view text) noexcept {
    print_message("twofold: ");
    print_message(text);
    print_message("\n");
    return static_cast<int>(code);
}

/// A closed standard descriptor would be given to the next file that is opened, and what is printed
/// would land in that file. Opened for reading only, so that lost output is an error.
void occupy_standard_descriptors() {
    int file = STDIN_FILENO;
    while (file >= 0 && file <= STDERR_FILENO) file = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (file >= 0) ::close(file);
}

constexpr std::string_view lost_output = "standard output: cannot be written";

std::string joined(int argc, char** argv) {
    std::string line = "twofold";
    for (int i = 1; i < argc; ++i) line += fmt::format(" {}", argv[i]);
    return line;
}

/// glibc loads its unwinder when an exception first passes through C code, and aborts if memory is
/// out by then.
void load_unwinder() {
    void* frame = nullptr;
    ::backtrace(&frame, 1);
}

/// Tells of the exception that is being handled.
int complain_of_exception() noexcept try { throw; } catch (const Error& e) {
    return complain(e.code(), e.what());
} catch (const std::bad_alloc&) {
    return complain(ExitCode::failure,
                    "out of memory: ask for a smaller picture, map or sample count");
} catch (const std::system_error& e) {
    return complain(ExitCode::bad_file, std::ferror(stdout) != 0 ? lost_output : e.what());
} catch (const std::exception& e) {
    return complain(ExitCode::failure, e.what());
} catch (...) {
    return complain(ExitCode::failure, "ended by an unknown exception");
}

/// Memory may end inside a destructor, which no exception may leave: those of nlohmann's JSON
/// allocate. Files are whole at any moment, so the program can end anywhere.
[[noreturn]] void end_at_once() {
    if (!std::current_exception()) std::abort();
    std::_Exit(complain_of_exception());
}

}  // namespace

int main(int argc, char** argv) try {
    std::set_terminate(end_at_once);
    occupy_standard_descriptors();
    load_unwinder();
    if (const std::string defects = floating_point_defects(); !defects.empty())
        return complain(ExitCode::inexact_build, "this build or process is not exact: " + defects);
    CLI::App app{"twofold: lighting functions as two textures, drawn bit-exactly to named presets",
                 "twofold"};
    app.set_version_flag("--version", "twofold " + program_version());
    app.require_subcommand(1);
    app.footer(
        "Example: twofold run scenes/gold-suzanne.json -o out\n"
        "Exit codes: 0 ok, 1 done with warnings, 2 difference, usage or scene error, out of\n"
        "memory, 3 sizes differ, 4 unreadable or bad file, 5 the solver did not converge, 6 "
        "arithmetic is not exact");
    Options options;
    options.common.command_line = joined(argc, argv);
    define_run(app, options);
    define_factor(app, options);
    define_render(app, options);
    define_compare(app, options);
    define_explain(app, options);
    define_study(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::failure);
    }
    const ExitCode code = dispatch(app, options);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return complain(ExitCode::bad_file, lost_output);
    return static_cast<int>(code);
} catch (const std::bad_alloc&) {
    end_at_once();  // OpenImageIO's tables may be half made, and abort when they are destroyed
} catch (...) {
    return complain_of_exception();
}
