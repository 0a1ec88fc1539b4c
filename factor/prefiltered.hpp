#pragma once
#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/factorize.hpp"

namespace twofold {

/// `prefilter`: two environment maps, each filtered by a part of the material beforehand, are
/// added: L_o(v, n) ~ D(n) + S(r_v). D is the radiance of the diffuse part, k_d E(n) / pi, and
/// exact. S is that of the rest seen head on, v = n = r_v: for modified Phong k_s (N + 2) / (2 pi)
/// (r_v.l)^N with r_v in place of n in the cosine. Nothing is fitted. Both maps are in units of
/// white and clipped there, as the picture is: no scale is needed.
/// @return one term, sum_of_maps
/// @param settings map_form, map_size and guard are used
/// @throws Error if the material is a measured one, which has no parts
/// @source Heidrich & Seidel, Realistic, Hardware-accelerated Shading and Lighting, 1999; Kautz &
///         McCool, Approximation of Glossy Reflection with Prefiltered Environment Maps, 2000
FactoredLighting prefilter(const Brdf& brdf, const DistantLights& lights,
                           const MaterialSamples& samples, const FactorSettings& settings,
                           double white, int threads);

}  // namespace twofold
