#pragma once
#include "factor/brdf.hpp"
#include "factor/directions.hpp"
#include "factor/environment.hpp"
#include "factor/lighting.hpp"
#include "tests/platforms/named_hash.hpp"

/// Materials and lights of the factor stages, small enough for an emulated processor.
namespace twofold::platforms {

/// A gradient with two discs, 32 x 16 texels.
inline DistantLights sky() {
    const PaintedEnvironment painted{
        {0.2, 0.3, 0.5},
        {{{0.3, 0.8, -0.5}, 25.0, {3.0, 2.5, 2.0}}, {{-0.7, 0.2, 0.4}, 40.0, {0.5, 1.0, 1.5}}}};
    EnvironmentSettings settings;
    settings.cells = 512;
    return environment_of(paint(painted, 32, 16), settings, "sky").lights;
}

inline Brdf phong() { return ModifiedPhong{{0.3, 0.4, 0.5}, {0.5, 0.4, 0.3}, 20.0}; }

inline Brdf cook_torrance() {
    return CookTorrance{
        {0.2, 0.1, 0.1}, {0.8, 0.7, 0.6}, {0.9, 0.6, 0.3}, {{0.2, 0.6}, {0.5, 0.4}}};
}

inline LightingSamples samples(const Brdf& brdf, int count, std::uint64_t sequence, int threads) {
    std::vector<SurfaceView> at = surface_views(count, sequence);
    std::vector<Rgb> radiance = outgoing_radiance(brdf, sky(), at, threads);
    return {std::move(at), std::move(radiance)};
}

}  // namespace twofold::platforms
