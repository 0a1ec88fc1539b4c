#pragma once
#include <string>
#include <vector>

#include "raster/renderer.hpp"
#include "texunit/error.hpp"
#include "texunit/preset.hpp"

/// The program's commands. Each prints results to stdout, messages to stderr, and returns the exit
/// code; errors are exceptions that main() turns into a message and a code.
namespace twofold {

struct CommonOptions {
    bool json = false;
    bool quiet = false;
    int threads = 0;                     ///< 0 = all of the machine
    std::vector<std::string> overrides;  ///< path=value changes to the scene
    std::string command_line;            ///< for the report
};

/// The preset that --preset names.
/// @throws Error with the names that there are
Preset preset_or_error(const std::string& name);

/// The pipeline that --pipeline names.
/// @throws Error with the names that there are
Pipeline pipeline_or_error(const std::string& name);

struct RunOptions {
    std::string scene;
    std::string output = "out";
    std::string pipeline = "fast";
};
ExitCode run_command(const RunOptions& options, const CommonOptions& common);

struct FactorOptions {
    std::string scene;
    std::string output;
    std::string solver;  ///< empty = the scene's
};
ExitCode factor_command(const FactorOptions& options, const CommonOptions& common);

struct RenderOptions {
    std::string scene;
    std::string output;
    std::string preset;  ///< empty = the first that the scene names
    std::string pipeline = "fast";
};
ExitCode render_command(const RenderOptions& options, const CommonOptions& common);

struct CompareOptions {
    std::string a, b;
    std::string diff;  ///< empty = no difference picture
    bool covered = false;
};
ExitCode compare_command(const CompareOptions& options, const CommonOptions& common);

struct StudyOptions {
    std::string scene;
    std::string output;
    std::string study;                 ///< a study file; empty = a shipped one
    bool quick = false, full = false;  ///< which shipped one; neither = quick
    std::string shard;                 ///< PART/PARTS; empty = all cells
    std::vector<std::string> merge;    ///< folders whose cells are taken over; nothing is measured
    std::string checks;                ///< result file of the project's tests; empty = none
    bool list = false;                 ///< only print the cells
};
ExitCode study_command(const StudyOptions& options, const CommonOptions& common);

struct ExplainOptions {
    std::string scene;
    std::string preset;
    bool cost = false;  ///< measure the scene's effects instead
};
ExitCode explain_command(const ExplainOptions& options, const CommonOptions& common);

}  // namespace twofold
