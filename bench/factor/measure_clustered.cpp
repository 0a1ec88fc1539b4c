#include <fmt/format.h>

#include "bench/draw/timing.hpp"
#include "bench/factor/measure.hpp"
#include "factor/clustered_lighting.hpp"
#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "factor/lighting.hpp"
#include "texunit/random.hpp"

namespace twofold::bench {
namespace {

constexpr int width = 1024, height = 512, full_views = 64, merged_views = 4000;
constexpr double tolerance = 2e-3;

/// Patches of uneven brightness over all of the sphere, and a sun of one texel.
FloatImage uneven_sky() {
    FloatImage image{width, height, 3, std::vector<float>(std::size_t{3} * width * height)};
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        const std::size_t patch = i / (3 * width) / 8 * width + i / 3 % width / 8;
        const double value = random_unit(11, patch);
        image.samples[i] = static_cast<float>(0.1 + value * value);
    }
    for (std::size_t c = 0; c < 3; ++c) image.samples[3 * (120 * width + 300) + c] = 1e4F;
    return image;
}

double seconds_a_view(const std::function<void(std::span<const SurfaceView>)>& sum, int views) {
    const std::vector<SurfaceView> at = surface_views(views, 0);
    return time_frames([&] { sum(at); }, 0.5, 3).cpu / views;
}

}  // namespace

std::vector<FactorFigure> measure_clustered() {
    const CookTorrance material{Rgb(0.3), Rgb(0.7), Rgb(0.04), {{0.2, 1.0}}};
    const DistantLights lights =
        latitude_longitude(uneven_sky(), {.cells = width * height}, "sky").lights;
    const double before = wall_seconds();
    const ClusteredLighting clustered(material, lights, tolerance, 1);
    const double setup = wall_seconds() - before;
    const double full = seconds_a_view(
        [&](std::span<const SurfaceView> at) { outgoing_radiance(material, lights, at, 1); },
        full_views);
    const double merged = seconds_a_view(
        [&](std::span<const SurfaceView> at) { clustered.radiance(at, 1); }, merged_views);
    const ClusterReport& report = clustered.report();
    return {
        {fmt::format("L_o over merged lights, {:.0f} of {} a view", report.lights,
                     report.full_lights),
         fmt::format("{:.1f} us a view, {:.1f} s before", 1e6 * merged, setup),
         fmt::format("full sum: {:.0f} us", 1e6 * full), full / merged, "x", 10.0, std::nullopt},
        {fmt::format("its rms error over {} views", report.views),
         fmt::format("bound {:.2g} %", 100.0 * report.bound), "", 100.0 * report.relative_rms, "%",
         std::nullopt, 0.2}};
}

}  // namespace twofold::bench
