#pragma once
#include <optional>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/factorize.hpp"

namespace twofold {

/// The factors where the lighting function is known to be a product, evaluated at the texels
/// instead of fitted: `diffuse`, any diffuse material (t1 is the radiance, t2 is 1), and `one Phong
/// lobe`, modified Phong under one directional light, (n.l)+ x W [k_d/pi + k_s (N+2)/(2 pi)
/// (r_v.l)+^N]. Exact but for the filtering between texels.
/// @param held_out pairs for the error figures
/// @param settings map_size, guard and scale are used
/// @return nothing for all other materials and lights
std::optional<FactoredLighting> closed_form(const Brdf& brdf, const DistantLights& lights,
                                            const LightingSamples& held_out,
                                            const FactorSettings& settings, double white,
                                            int threads);

}  // namespace twofold
