#pragma once
#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/factorize.hpp"

namespace twofold {

/// Lights that `mccool` draws at most: each is a pass of its own.
inline constexpr std::size_t most_point_lights = 64;

/// `mccool`: the BRDF itself, not the lighting function, is the product, f(l, v) ~ alpha p(l) q(h)
/// p(v), and each light is drawn: L = alpha p(v) sum of W (n.l)+ p(l) q(h). Measured materials
/// that are filled by their product give theirs, others are sampled and factored
/// (factor/product_brdf.hpp). T1 is p and T2 is q, in 8 bits over one paraboloid in the frame of
/// the surface.
/// @return one term, whose constant is that of the brightest light, and the lights
/// @param settings map_size and samples are used
/// @throws Error if there are more than most_point_lights
/// @source McCool, Ang & Ahmad, Homomorphic Factorization of BRDFs for High-Performance Rendering,
///         2001
FactoredLighting factor_point_lit(const Brdf& brdf, const DistantLights& lights,
                                  const MaterialSamples& samples, const FactorSettings& settings,
                                  double white, int threads);

}  // namespace twofold
