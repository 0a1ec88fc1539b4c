#include "scenes/lighting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "factor/approximate.hpp"
#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "scenes/camera.hpp"
#include "scenes/measured_file.hpp"
#include "scenes/surface_samples.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

/// Stretches of the direction sequence: no pair is in two of them.
constexpr std::uint64_t fit_sequence = 0, held_out_sequence = 1, averaging_sequence = 2;

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

LightingSamples sample(const Brdf& brdf, const DistantLights& lights, int count,
                       std::uint64_t sequence, int threads) {
    LightingSamples samples{surface_views(count, sequence), {}};
    samples.radiance = outgoing_radiance(brdf, lights, samples.at, threads);
    return samples;
}

/// Fewer lights are summed as they are.
constexpr std::size_t least_clustered_lights = 256;

struct Sampled {
    MaterialSamples samples;
    std::optional<ClusterReport> clustered;
};

/// Samples of the fit and pairs held out of it, by the sum that the settings name.
Sampled material_samples(const Brdf& brdf, const DistantLights& lights,
                         const FactorSettings& settings, int threads) {
    if (settings.lighting_sum == LightingSum::full || lights.size() <= least_clustered_lights)
        return {{sample(brdf, lights, settings.samples, fit_sequence, threads),
                 sample(brdf, lights, settings.held_out, held_out_sequence, threads)},
                std::nullopt};
    const ClusteredLighting clustered(brdf, lights, settings.lighting_tolerance, threads);
    const auto merged = [&](int count, std::uint64_t sequence) {
        LightingSamples samples{surface_views(count, sequence), {}};
        samples.radiance = clustered.radiance(samples.at, threads);
        return samples;
    };
    return {{merged(settings.samples, fit_sequence), merged(settings.held_out, held_out_sequence)},
            clustered.report()};
}

/// The materials that objects use, measured ones loaded.
std::map<std::string, Brdf> used_materials(const Scene& scene, int threads) {
    std::map<std::string, Brdf> used;
    for (const FactoredObject& object : scene.objects)
        if (!used.contains(object.material))
            used.emplace(object.material,
                         loaded(scene.materials.at(object.material), scene.directory, threads));
    return used;
}

/// Half width at half height of the narrowest lobe, radians.
double lobe_half_width(const Brdf& brdf) {
    if (const auto* phong = std::get_if<ModifiedPhong>(&brdf))
        return exact::acos(exact::pow(0.5, 1.0 / std::max(phong->exponent, 1.0)));
    if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf))
        return measured->model->report.lobe_half_width;
    double narrowest = exact::pi / 2.0;
    for (const BeckmannLobe& lobe : std::get<CookTorrance>(brdf).lobes)
        narrowest = std::min(narrowest, lobe.m);
    return narrowest;
}

/// A lobe narrower than a texel cannot be held by the second map (S03). Texels of one face span a
/// half turn.
std::vector<std::string> sampling_warnings(const Brdf& brdf, int map_size) {
    const double lobe = lobe_half_width(brdf), texel = exact::pi / map_size;
    if (lobe >= texel) return {};
    return {fmt::format(
        "undersampled: the lobe's half width is {:.3g} rad, a texel of the {} x {} map {:.3g} rad",
        lobe, map_size, map_size, texel)};
}

/// The lights in the frame of the maps: that of the world, and of sphere maps the eye's. Maps of
/// mccool are in the frame of the surface, whatever the form.
DistantLights lights_about_maps(const Scene& scene, const DistantLights& lights) {
    return scene.factorization.map_form == MapForm::sphere &&
                   scene.factorization.model != Model::mccool
               ? turned(lights, Mat3{view_matrix(scene.camera)})
               : lights;
}

/// Turns directions into the frame of the maps.
SurfaceSamples about_maps(SurfaceSamples samples, const Scene& scene) {
    if (scene.factorization.map_form != MapForm::sphere) return samples;
    const Mat3 turn{view_matrix(scene.camera)};
    for (SurfaceView& at : samples.lighting.at) at = {turn * at.n, turn * at.v};
    return samples;
}

/// The surface of the one object that has a material.
Surface surface_with(const std::string& material, const Scene& scene, const SceneAssets& assets) {
    const auto object =
        std::find_if(scene.objects.begin(), scene.objects.end(),
                     [&](const FactoredObject& one) { return one.material == material; });
    return {assets.meshes.at(object->mesh), object->mesh, model_matrix(*object)};
}

SurfaceField sample_surface(const Surface& surface, const Scene& scene, const Brdf& brdf,
                            const DistantLights& lights, int threads) {
    const FactorSettings& settings = scene.factorization;
    const auto samples = [&](int count, std::uint64_t sequence) {
        return about_maps(
            surface_samples(surface, brdf, lights, settings, count, sequence, threads), scene);
    };
    return {rows_of(surface, settings), samples(settings.samples, fit_sequence),
            samples(settings.held_out, held_out_sequence)};
}

/// Samples on the surfaces of the objects instead of over all directions.
SampledScene with_surfaces(SampledScene sampled, const Scene& scene, int threads,
                           const StepListener& listen) {
    const SceneAssets assets = load_assets(scene);
    for (const auto& [name, brdf] : sampled.brdfs) {
        listen("sample " + name);
        const SurfaceField field = sample_surface(surface_with(name, scene, assets), scene, brdf,
                                                  sampled.lights.lights, threads);
        sampled.samples[name] = {field.fit.lighting, field.held_out.lighting};
        sampled.surfaces[name] = field;
    }
    return sampled;
}

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

double white_radiance(const WhitePoint& white,
                      const std::map<std::string, MaterialSamples>& samples) {
    if (white.radiance) return *white.radiance;
    std::vector<double> largest;
    for (const auto& [name, s] : samples)
        for (const Rgb& radiance : s.fit.radiance) largest.push_back(max_component(radiance));
    if (largest.empty()) return 1.0;
    std::stable_sort(largest.begin(), largest.end());
    const double last = static_cast<double>(largest.size() - 1);
    const double value = largest[static_cast<std::size_t>(white.percentile / 100.0 * last)];
    return value > 0.0 ? value : 1.0;
}

SampledScene sample_scene(const Scene& scene, int threads, const StepListener& listen) {
    SampledScene sampled;
    if (scene.objects.empty()) return sampled;
    listen("environment");
    sampled.lights = make_lights(scene);
    sampled.about_maps = lights_about_maps(scene, sampled.lights.lights);
    const FactorSettings& settings = scene.factorization;
    listen("materials");
    sampled.brdfs = used_materials(scene, threads);
    if (settings.model == Model::slf)
        return with_surfaces(std::move(sampled), scene, threads, listen);
    for (const auto& [name, brdf] : sampled.brdfs) {
        listen("sample " + name);
        Sampled made = material_samples(brdf, sampled.about_maps, settings, threads);
        sampled.samples[name] = std::move(made.samples);
        if (made.clustered) sampled.clustered[name] = *made.clustered;
    }
    return sampled;
}

SampledScene first_samples(const SampledScene& sampled, int count) {
    SampledScene result = sampled;
    const auto wanted = static_cast<std::size_t>(count);
    for (auto& [name, samples] : result.samples) {
        samples.fit.at.resize(std::min(samples.fit.at.size(), wanted));
        samples.fit.radiance.resize(samples.fit.at.size());
    }
    for (auto& [name, surface] : result.surfaces) {
        surface.fit.lighting = result.samples.at(name).fit;
        surface.fit.rows.resize(surface.fit.lighting.at.size());
    }
    return result;
}

LitScene factor_scene(const Scene& scene, const SampledScene& sampled, double white, int threads,
                      const StepListener& listen) {
    LitScene lit{sampled.lights, white, sampled.brdfs, {}, sampled.clustered};
    const FactorSettings& settings = scene.factorization;
    for (const auto& [name, s] : sampled.samples) {
        listen("factor " + name);
        FactoredLighting lighting =
            settings.model == Model::slf
                ? factor_surface(sampled.surfaces.at(name), settings, lit.white, threads)
                : approximate(lit.brdfs.at(name), sampled.about_maps, s, settings, lit.white,
                              threads);
        for (std::string& w : sampling_warnings(lit.brdfs.at(name), settings.map_size))
            lighting.warnings.push_back(std::move(w));
        lit.materials.emplace(name, std::move(lighting));
    }
    return lit;
}

LitScene light_scene(const Scene& scene, int threads, const StepListener& listen) {
    const SampledScene sampled = sample_scene(scene, threads, listen);
    return factor_scene(scene, sampled, white_radiance(scene.white, sampled.samples), threads,
                        listen);
}

}  // namespace twofold
