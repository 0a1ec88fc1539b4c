#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "study/sweep/study_page.hpp"
#include "study/write_run.hpp"

namespace twofold {
namespace {

Study study_of(const StudyOptions& options) {
    if (!options.study.empty()) return read_study(options.study);
    return shipped_study(options.full ? "full" : "quick");
}

std::string time_text(double seconds) {
    if (seconds < 0.0) return "";
    if (seconds < 90.0) return fmt::format(", about {:.0f} s left", seconds);
    return fmt::format(", about {:.0f} min left", seconds / 60.0);
}

void show(Console& console, const StudyProgress& p) {
    console.step(
        fmt::format("cell {} of {}: {}{}", p.number, p.count, p.step, time_text(p.seconds_left)));
}

void print_effort(const StudyEffort& e) {
    const double own = e.seconds - e.cell_seconds;
    fmt::print(
        "measured {} cells, kept {}; {:.1f} s, of which the study itself {:.2f} s ({:.1f} %)\n",
        e.measured, e.kept, e.seconds, own, e.seconds > 0.0 ? 100.0 * own / e.seconds : 0.0);
}

void print_cells(const StudyPlan& plan, const CellStore& store) {
    for (const PlannedAxis& axis : plan.axes)
        for (const PlannedPoint& point : axis.points) {
            const std::string& id = plan.cells[point.cell].id;
            fmt::print("{} {} {}: {}\n", id, store.result(id) ? "measured" : "missing ", axis.name,
                       point.label);
        }
}

/// Cells that a shard measured. Its folder is only read.
void take_over(const StudyPlan& plan, const std::string& folder, const CellStore& store) {
    const std::filesystem::path cells = std::filesystem::path(folder) / "cells";
    if (!std::filesystem::is_directory(cells))
        throw Error(ExitCode::bad_file, "--merge: " + cells.string() + ": there is no such folder");
    const CellStore other(cells);
    for (const PlannedCell& cell : plan.cells) store.take_over(cell.id, other);
}

ExitCode report(const StudyPlan& plan, const CellStore& store, const std::filesystem::path& folder,
                const StudyOrigin& origin) {
    const StudyResults results = collect(plan, store);
    const auto file = write_study(results, store, folder, origin);
    fmt::print("{}\nreport: {}\n", study_summary(results),
               std::filesystem::absolute(file).lexically_normal().string());
    ExitCode code = ExitCode::ok;
    for (const auto& [id, result] : results.cells)
        if (result.contains("failed")) {
            print_message(
                fmt::format("warning: {}: {}\n", id, result.at("failed").get<std::string>()));
            code = ExitCode::warning;
        }
    return code;
}

}  // namespace

ExitCode study_command(const StudyOptions& options, const CommonOptions& common) {
    const StudyPlan plan = make_plan(study_of(options), options.scene, common.overrides);
    const Shard shard = options.shard.empty() ? Shard{} : shard_of(options.shard);
    const OutputFolder folder(options.output);
    const CellStore store(folder.path() / "cells");
    if (options.list) {
        print_cells(plan, store);
        return ExitCode::ok;
    }
    Console console(common.quiet);
    for (const std::string& other : options.merge) take_over(plan, other, store);
    if (options.merge.empty()) {
        const StudyEffort effort = measure_cells(plan, shard, store, common.threads,
                                                 [&](const StudyProgress& p) { show(console, p); });
        console.finish();
        print_effort(effort);
    }
    if (!options.shard.empty()) return ExitCode::ok;
    return report(plan, store, folder.path(), {common.command_line, options.checks});
}

}  // namespace twofold
