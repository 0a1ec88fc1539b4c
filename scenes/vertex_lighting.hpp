#pragma once
#include "scenes/assets.hpp"
#include "scenes/lighting.hpp"

/// The alternatives that need no texture: light at the vertices, colours between them. One pass an
/// object; colours beyond white are cut at the vertices, as OpenGL does.
namespace twofold {

/// Equation (1) at every vertex, over all the lights.
Frame make_vertex_sum_frame(const Scene& scene, const SceneAssets& assets,
                            const SampledScene& sampled, double white, int threads);

/// OpenGL's lighting by at most `lights` directional lights with local viewer, the environment
/// averaged to them. Diffuse is k_d / pi of each light; the highlight (n.h)^s stands for a Phong
/// lobe with s = 4 N, for Beckmann's with s = 2 / m^2 of the lobes' mean m^2, at most 128, of the
/// same value at n = h as the lobe's, Fresnel and masking left out.
/// @throws Error for a measured material, which has no such form
/// @source OpenGL 1.3, 2.13.1; which material stands for which BRDF is chosen
Frame make_vertex_lights_frame(const Scene& scene, const SceneAssets& assets,
                               const SampledScene& sampled, double white, int lights);

}  // namespace twofold
