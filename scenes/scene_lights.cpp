#include "scenes/scene_lights.hpp"

#include <filesystem>

#include "factor/directions.hpp"
#include "scenes/material_samples.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

/// Views over which the averaging of the environment is judged; each sums over every texel.
constexpr int averaging_views = 64;

EnvironmentSettings settings_of(const EnvironmentSpec& spec) {
    EnvironmentSettings settings{.cells = spec.cells};
    if (const auto* file = std::get_if<EnvironmentFile>(&spec.source)) {
        settings.repair = file->repair;
        settings.form = file->form;
        settings.guard = file->guard;
    }
    return settings;
}

SceneLights averaged(FloatImage picture, EnvironmentSettings settings, const std::string& name) {
    Environment environment = environment_of(picture, settings, name);
    return {std::move(environment.lights), std::move(picture), environment.report, {}};
}

struct LightsMaker {
    const Scene& scene;

    SceneLights operator()(const EnvironmentFile& file) const {
        const auto path = std::filesystem::path(scene.directory) / file.path;
        ReadImage read = read_float_image(path);
        SceneLights lights =
            averaged(std::move(read.image), settings_of(*scene.environment), path.string());
        lights.lights = placed(std::move(lights.lights), file.placement);
        lights.notes = std::move(read.notes);
        return lights;
    }
    SceneLights operator()(const PaintedLatLong& painted) const {
        return averaged(paint(painted.environment, painted.width, painted.height),
                        settings_of(*scene.environment), "painted environment");
    }
    SceneLights operator()(const DirectionalLights& directional) const {
        return {bound_blocks(directional_lights(directional.lights)), std::nullopt, {}, {}};
    }
};

}  // namespace

SceneLights make_lights(const Scene& scene) {
    if (!scene.environment)
        throw Error(ExitCode::failure, "environment: needed by the scene's objects, but missing");
    return std::visit(LightsMaker{scene}, scene.environment->source);
}

double averaging_cost(const Scene& scene, const SceneLights& lights, const Brdf& brdf,
                      int threads) {
    if (!lights.picture) return 0.0;
    EnvironmentSettings settings = settings_of(*scene.environment);
    settings.repair = true;
    const auto views = surface_views(averaging_views, averaging_sequence);
    return averaging_cost(brdf, *lights.picture, settings, views, threads);
}

}  // namespace twofold
