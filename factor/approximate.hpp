#pragma once
#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/factorize.hpp"

namespace twofold {

/// A material's lighting function by the model that the settings name, in closed form where they
/// want that and there is one. A surface light field is no matter of the material alone and has a
/// call of its own (factor/surface_light_field.hpp).
/// @param lights in the frame of the maps, as the samples are
/// @throws Error as the models do
FactoredLighting approximate(const Brdf& brdf, const DistantLights& lights,
                             const MaterialSamples& samples, const FactorSettings& settings,
                             double white, int threads);

/// The same where the model is the product of two maps, for samples that were added in batches.
/// @param judged pairs for the error figures
FactoredLighting approximate_product(const Brdf& brdf, const DistantLights& lights, FitSamples fit,
                                     const LightingSamples& judged, double white, int threads);

}  // namespace twofold
