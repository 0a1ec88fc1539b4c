#pragma once
#include <optional>
#include <string>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/environment.hpp"
#include "scenes/scene.hpp"

namespace twofold {

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

}  // namespace twofold
