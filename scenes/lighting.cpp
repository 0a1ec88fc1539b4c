#include "scenes/lighting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "factor/approximate.hpp"
#include "scenes/camera.hpp"
#include "scenes/measured_file.hpp"
#include "scenes/surface_samples.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

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

/// What samples are made of: lights and materials.
SampledScene lights_and_materials(const Scene& scene, int threads, const StepListener& listen) {
    SampledScene sampled;
    if (scene.objects.empty()) return sampled;
    listen("environment");
    sampled.lights = make_lights(scene);
    sampled.about_maps = lights_about_maps(scene, sampled.lights.lights);
    listen("materials");
    sampled.brdfs = used_materials(scene, threads);
    return sampled;
}

/// Calls keep(name, sampler) for each material.
template <class Keep>
void sample_materials(SampledScene& sampled, const FactorSettings& settings, int threads,
                      const StepListener& listen, const Keep& keep) {
    for (const auto& [name, brdf] : sampled.brdfs) {
        listen("sample " + name);
        const MaterialSampler sampler(brdf, sampled.about_maps, settings, threads);
        keep(name, sampler);
        if (const auto report = sampler.report()) sampled.clustered[name] = *report;
    }
}

void add_material(LitScene& lit, const std::string& name, FactoredLighting lighting, int map_size) {
    for (std::string& w : sampling_warnings(lit.brdfs.at(name), map_size))
        lighting.warnings.push_back(std::move(w));
    lit.materials.emplace(name, std::move(lighting));
}

/// Samples are placed in the maps as they are made, and leave as they are fitted.
LitScene light_products(const Scene& scene, int threads, const StepListener& listen) {
    const FactorSettings& settings = scene.factorization;
    SampledScene sampled = lights_and_materials(scene, threads, listen);
    std::map<std::string, FitSamples> placed;
    sample_materials(sampled, settings, threads, listen,
                     [&](const std::string& name, const MaterialSampler& sampler) {
                         placed.emplace(name, sampler.placed());
                         sampled.samples[name].held_out = sampler.held_out();
                     });
    const double white = white_radiance(scene.white, placed);
    LitScene lit{sampled.lights, white, sampled.brdfs, {}, sampled.clustered};
    for (auto& [name, fit] : placed) {
        listen("factor " + name);
        add_material(lit, name,
                     approximate_product(lit.brdfs.at(name), sampled.about_maps, std::move(fit),
                                         sampled.samples.at(name).held_out, white, threads),
                     settings.map_size);
    }
    return lit;
}

}  // namespace

SampledScene sample_scene(const Scene& scene, int threads, const StepListener& listen) {
    SampledScene sampled = lights_and_materials(scene, threads, listen);
    if (scene.factorization.model == Model::slf && !sampled.brdfs.empty())
        return with_surfaces(std::move(sampled), scene, threads, listen);
    sample_materials(sampled, scene.factorization, threads, listen,
                     [&](const std::string& name, const MaterialSampler& sampler) {
                         sampled.samples[name] = {sampler.fitted(), sampler.held_out()};
                     });
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
        add_material(lit, name, std::move(lighting), settings.map_size);
    }
    return lit;
}

LitScene light_scene(const Scene& scene, int threads, const StepListener& listen) {
    if (scene.factorization.model == Model::product) return light_products(scene, threads, listen);
    const SampledScene sampled = sample_scene(scene, threads, listen);
    return factor_scene(scene, sampled, white_radiance(scene.white, sampled.samples), threads,
                        listen);
}

}  // namespace twofold
