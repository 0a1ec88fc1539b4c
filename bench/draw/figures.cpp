#include "bench/draw/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "bench/draw/child.hpp"
#include "bench/draw/drawing.hpp"
#include "bench/draw/peers.hpp"

namespace twofold::bench {
namespace {

/// One step of a series: which inputs, and how many units they are.
struct Amount {
    int squares, size;
};

double units_of(const std::string& unit, const Frame& frame) {
    if (unit == "triangle") return static_cast<double>(frame.meshes[0].indices.size()) / 3.0;
    return covered_pixels(render_fast(frame, Preset::nv17).bytes);
}

Series measure(const Settings& settings, const std::string& title, const std::string& drawing,
               const std::string& unit, const std::vector<Amount>& amounts) {
    Series series{title, unit, {}};
    Contest contest{title, 1.0, {}, {}, settings.rounds};
    for (const auto& [squares, size] : amounts) {
        const Source source = make_source(settings, drawing, squares, size).source;
        const auto frame = std::make_shared<const Frame>(frame_of(load(source)));
        const std::string name = fmt::format("{} {}", squares, size);
        contest.contestants.push_back(
            fast_contestant(name, frame, Preset::nv17, {}, settings.seconds));
        contest.duels.push_back({name, ""});
        series.steps.push_back({units_of(unit, *frame), 0.0});
    }
    const std::vector<Row> rows = hold(contest);
    for (std::size_t i = 0; i < rows.size(); ++i) series.steps[i].seconds = median(rows[i].ours);
    return series;
}

/// The least of several runs.
template <class Run>
double least_of(int runs, Run run) {
    double least = run();
    for (int i = 1; i < runs; ++i) least = std::min(least, run());
    return least;
}

}  // namespace

double Series::slope(std::size_t i) const {
    return (steps[i].seconds - steps[i - 1].seconds) / (steps[i].units - steps[i - 1].units);
}

std::vector<Series> measure_growth(const Settings& settings) {
    const std::vector<Amount> quads{{0, 512}, {0, 1024}, {0, 2048}};
    const std::vector<Amount> pictures{{sphere_20k, 512}, {sphere_20k, 1024}, {sphere_20k, 2048}};
    const std::vector<Amount> meshes{{sphere_2k, 1024}, {sphere_20k, 1024}, {sphere_200k, 1024}};
    return {measure(settings, "two textures, perspective quad", "tex2-persp", "pixel", quads),
            measure(settings, "four passes fused, 20k triangles", "para4", "pixel", pictures),
            measure(settings, "two textures, 1024 x 1024", "tex2-persp", "triangle", meshes),
            measure(settings, "four passes fused, 1024 x 1024", "para4", "triangle", meshes)};
}

std::vector<Figure> measure_first_picture(const Settings& settings) {
    constexpr int runs = 20, peer_runs = 3;
    const double ours = least_of(runs, [&] {
        return run_child({settings.self.string(), "--first-picture"}).wall;
    });
    std::vector<Figure> figures{{"process start to first 64 x 64 picture, wall",
                                 "ms",
                                 1e3 * ours,
                                 {5.0, 2.0},
                                 "start and end of the process included"}};
    if (!settings.peers) return figures;
    const double theirs = least_of(peer_runs, [&] {
        return time_peer(*settings.peers, {"llvmpipe", "tex2-persp", 0, 64}, 0.0).first_cpu;
    });
    figures.push_back({"llvmpipe's first 64 x 64 picture, processor time",
                       "ms",
                       1e3 * theirs,
                       {},
                       "without the start of the process"});
    return figures;
}

std::vector<Figure> measure_memory(const Settings& settings) {
    constexpr int size = 2048;
    constexpr double framebuffer = 8.0 * size * size / (1 << 20);
    const Source source = make_source(settings, "para4", sphere_200k, size).source;
    std::istringstream printed(
        run_child(child_command(settings, source, Preset::nv17, 0.0)).output);
    FrameTimes times;
    double before = 0.0, peak = 0.0;
    printed >> times.cpu >> times.cpu_median >> times.wall >> before >> peak;
    return {{"peak memory less the framebuffer, 2048 x 2048, 200k triangles, fused",
             "MiB",
             peak - framebuffer,
             {64.0, {}},
             fmt::format("the whole process; {:.0f} MiB before drawing", before)}};
}

}  // namespace twofold::bench
