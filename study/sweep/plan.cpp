#include "study/sweep/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>

#include "texunit/error.hpp"
#include "texunit/fnv1a.hpp"

namespace twofold {
namespace {

using Changes = std::vector<std::string>;

Changes joined(Changes a, const Changes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Collects cells, each once.
struct PlanMaker {
    InputHashes inputs{};
    int white_samples = 0;
    std::vector<PlannedCell> cells{};
    std::map<std::string, std::size_t> known{};

    std::size_t add(const SceneSource& source, const Changes& changes) {
        Cell cell = make_cell(source, changes);
        if (white_samples == 0) white_samples = cell.white_samples;
        cell.white_samples = white_samples;
        const std::string id = id_of(cell, inputs);
        const auto [place, is_new] = known.emplace(id, cells.size());
        if (is_new) cells.push_back({id, std::move(cell)});
        return place->second;
    }
};

/// The scenes of an axis: those that it names and that lie beside the study's, or the study's.
std::vector<SceneSource> scenes_of(const StudyAxis& axis, const SceneSource& source) {
    std::vector<SceneSource> scenes;
    for (const std::string& name : axis.scenes)
        if (std::filesystem::exists(source.directory / name))
            scenes.push_back(read_source(source.directory / name));
    if (scenes.empty()) scenes.push_back(source);
    return scenes;
}

PlannedAxis planned_axis(PlanMaker& maker, const StudyAxis& axis, const SceneSource& source,
                         const Changes& base) {
    PlannedAxis planned{axis.name, axis.title, axis.plot, axis.against, axis.linear, {}};
    const Changes common = joined(base, axis.base);
    for (const SceneSource& scene : scenes_of(axis, source))
        for (const StudyPoint& point : axis.points)
            planned.points.push_back(
                {point.label, point.value,
                 axis.scenes.empty() ? "" : std::filesystem::path(scene.name).filename().string(),
                 maker.add(scene, joined(common, point.changes))});
    return planned;
}

std::string hash_of(const SceneSource& source, const std::string& inputs) {
    Fnv1a hash;
    hash.text(source.text).text(inputs);
    return fmt::format("{:016x}", hash.value());
}

/// Numbers texts in the order in which they are first met.
class Ranks {
  public:
    std::size_t of(const std::string& text) {
        return known_.emplace(text, known_.size()).first->second;
    }

  private:
    std::map<std::string, std::size_t> known_;
};

/// Cells that share the exact picture, then factors, then ideal64's picture next to each other, the
/// common cell's first.
void sort_by_shared_work(StudyPlan& plan, InputHashes& inputs) {
    Ranks truths, factors, ideals;
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const CellKeys keys = keys_of(plan.cells[i].cell, inputs);
        order.emplace_back(truths.of(keys.truth), factors.of(keys.factors), ideals.of(keys.ideal),
                           i);
    }
    std::stable_sort(order.begin(), order.end());
    std::vector<std::size_t> place(order.size());
    std::vector<PlannedCell> sorted;
    for (const auto& entry : order) {
        place[std::get<3>(entry)] = sorted.size();
        sorted.push_back(std::move(plan.cells[std::get<3>(entry)]));
    }
    plan.cells = std::move(sorted);
    plan.base = place[plan.base];
    for (PlannedAxis& axis : plan.axes)
        for (PlannedPoint& point : axis.points) point.cell = place[point.cell];
}

}  // namespace

StudyPlan make_plan(const Study& study, const std::filesystem::path& scene,
                    const std::vector<std::string>& overrides) {
    const SceneSource source = read_source(scene);
    PlanMaker maker;
    const Changes base = joined(study.base, overrides);
    StudyPlan plan;
    plan.base = maker.add(source, base);
    plan.scene_hash = hash_of(source, maker.inputs.of(maker.cells[0].cell.scene));
    const bool has_objects = !maker.cells[0].cell.scene.objects.empty();
    for (const StudyAxis& axis : study.axes)
        if (has_objects || !axis.needs_objects)
            plan.axes.push_back(planned_axis(maker, axis, source, base));
    plan.study_title = study.title;
    plan.scene_title = maker.cells[0].cell.scene.title;
    plan.scene_file = scene.filename().string();
    plan.timing = study.timing;
    plan.cells = std::move(maker.cells);
    for (const PlannedCell& c : plan.cells)
        plan.samples = std::max(plan.samples, c.cell.scene.factorization.samples);
    sort_by_shared_work(plan, maker.inputs);
    return plan;
}

Shard shard_of(const std::string& text) {
    Shard shard{0, 0};
    const char *begin = text.data(), *end = begin + text.size();
    const auto part = std::from_chars(begin, end, shard.part);
    if (part.ec == std::errc{} && part.ptr != end && *part.ptr == '/') {
        const auto parts = std::from_chars(part.ptr + 1, end, shard.parts);
        if (parts.ec == std::errc{} && parts.ptr == end && shard.part >= 1 &&
            shard.part <= shard.parts && shard.parts <= 10000)
            return shard;
    }
    throw Error(ExitCode::failure,
                fmt::format("--shard: '{}' is not PART/PARTS, such as 1/4", text));
}

std::vector<std::size_t> cells_of(const StudyPlan& plan, const Shard& shard) {
    std::vector<std::size_t> cells;
    for (auto i = static_cast<std::size_t>(shard.part - 1); i < plan.cells.size();
         i += static_cast<std::size_t>(shard.parts))
        cells.push_back(i);
    return cells;
}

}  // namespace twofold
