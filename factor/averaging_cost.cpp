#include <algorithm>
#include <cmath>

#include "factor/environment.hpp"
#include "factor/lighting.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {

double relative_rms_difference(const Brdf& brdf, const DistantLights& averaged,
                               const DistantLights& full, std::span<const SurfaceView> at,
                               int threads) {
    const auto a = outgoing_radiance(brdf, averaged, at, threads);
    const auto b = outgoing_radiance(brdf, full, at, threads);
    const double squares =
        ordered_sum(at.size(), [&](std::size_t i) { return dot(a[i] - b[i], a[i] - b[i]); });
    const double reference = ordered_sum(at.size(), [&](std::size_t i) { return dot(b[i], b[i]); });
    return squares > 0.0 ? std::sqrt(squares / reference) : 0.0;
}

double averaging_cost(const Brdf& brdf, const FloatImage& image,
                      const EnvironmentSettings& settings, std::span<const SurfaceView> at,
                      int threads) {
    const auto averaged = environment_of(image, settings, "environment");
    EnvironmentSettings every_texel = settings;
    every_texel.cells = std::max(settings.cells, image.width * image.height);
    const auto full = environment_of(image, every_texel, "environment");
    return relative_rms_difference(brdf, averaged.lights, full.lights, at, threads);
}

}  // namespace twofold
