#pragma once
#include <functional>
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

/// The lights that a view sums over; what it refers to stays as it is until the next call.
using LightsOfView = std::function<const DistantLights&(const SurfaceView&)>;

/// The same where each view has lights of its own. @param begin gives each thread its LightsOfView
std::vector<Rgb> outgoing_radiance(const Brdf& brdf, const std::function<LightsOfView()>& begin,
                                   std::span<const SurfaceView> at, int threads);

}  // namespace twofold
