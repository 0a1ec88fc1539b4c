#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "factor/clustered_lighting.hpp"
#include "factor/environment.hpp"
#include "factor/samples.hpp"
#include "factor/surface_light_field.hpp"
#include "scenes/frame.hpp"

/// The work before anything is drawn: the environment becomes a list of lights, each material's
/// lighting function is sampled, the white point found, and the samples factored.
namespace twofold {

/// Told the name of each step as it begins.
using StepListener = std::function<void(const std::string& step)>;

/// The scene's environment as lights. The averaged list *is* the environment: equation (1) over it
/// is the truth that pictures are compared with.
struct SceneLights {
    DistantLights lights;
    std::optional<FloatImage> picture;  ///< what was averaged; none for directional lights
    EnvironmentReport report;
    std::vector<std::string> notes;
};

/// @throws Error if the scene has no environment or its file cannot be used
SceneLights make_lights(const Scene& scene);

/// What averaging the environment cost the material: relative rms difference of L_o against one
/// light a texel, over a few views. 0 for directional lights.
double averaging_cost(const Scene& scene, const SceneLights& lights, const Brdf& brdf, int threads);

/// The radiance that is displayed as 1: given by the scene, or the percentile of the largest
/// channel over the samples of all materials; 1 if everything is black.
double white_radiance(const WhitePoint& white,
                      const std::map<std::string, MaterialSamples>& samples);

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

/// Runs all of it for the materials that objects use.
LitScene light_scene(const Scene& scene, int threads, const StepListener& listen);

}  // namespace twofold
