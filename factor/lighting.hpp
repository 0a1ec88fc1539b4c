#pragma once
#include <span>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/evaluate.hpp"
#include "factor/samples.hpp"

namespace twofold {

/// The lighting function L_o(v, n) = sum_k f(l_k, v; n) max(0, n.l_k) W_k; 0 where n.v <= 0. One
/// thread forms the sum of a view, in the order of docs/exactness.md, section 3.
/// @return radiance, one value a channel
/// @throws Error(failure) where the material has no value
/// @source the paper's equation 1 over the finite environment of docs/method.md, section 2
Rgb outgoing_radiance(const Brdf& brdf, const DistantLights& lights, const SurfaceView& at);

/// The same for many views; result i belongs to at[i] and is the same at every number of threads.
std::vector<Rgb> outgoing_radiance(const Brdf& brdf, const DistantLights& lights,
                                   std::span<const SurfaceView> at, int threads);

}  // namespace twofold
