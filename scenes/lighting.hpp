#pragma once
#include <functional>
#include <map>
#include <string>

#include "factor/surface_light_field.hpp"
#include "scenes/frame.hpp"
#include "scenes/material_samples.hpp"
#include "scenes/scene_lights.hpp"

/// The work before anything is drawn: the environment becomes a list of lights, each material's
/// lighting function is sampled, the white point found, and the samples factored.
namespace twofold {

/// Told the name of each step as it begins.
using StepListener = std::function<void(const std::string& step)>;

/// What precedes every fit: lights, BRDFs and samples of the lighting functions.
struct SampledScene {
    SceneLights lights;
    DistantLights about_maps;           ///< the same in the frame of the maps
    std::map<std::string, Brdf> brdfs;  ///< those that objects use, measured ones loaded
    std::map<std::string, MaterialSamples> samples;
    std::map<std::string, ClusterReport> clustered;  ///< materials that the clustered sum sampled
    std::map<std::string, SurfaceField> surfaces;    ///< slf: the same samples, and where they lie
};

/// Samples the materials that objects use, as many times as the scene's factorization says.
SampledScene sample_scene(const Scene& scene, int threads, const StepListener& listen);

/// The first `count` samples of each fit: those that a scene with that many has itself.
SampledScene first_samples(const SampledScene& sampled, int count);

/// A scene that is ready to be drawn.
struct LitScene {
    SceneLights lights;
    double white = 1.0;
    std::map<std::string, Brdf> brdfs;  ///< those that objects use, measured ones loaded
    FactoredMaterials materials;
    std::map<std::string, ClusterReport> clustered{};  ///< materials that the clustered sum sampled
};

/// Factors what was sampled by the scene's settings.
/// @param white radiance that pictures show as 1
LitScene factor_scene(const Scene& scene, const SampledScene& sampled, double white, int threads,
                      const StepListener& listen);

/// Runs all of it for the materials that objects use. Samples of products are placed in the maps as
/// they are made (MaterialSampler::placed).
LitScene light_scene(const Scene& scene, int threads, const StepListener& listen);

}  // namespace twofold
