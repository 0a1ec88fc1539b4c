#pragma once
#include <string>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/factorize.hpp"

/// The cases of docs/method.md, section 9, and their figures at pairs that no fit has seen.
namespace twofold::quality {

/// "one", "three": directional lights; "constant"; "sky": a horizon between a gradient above and an
/// even ground.
DistantLights lights_named(const std::string& name);

/// The sky in all channels.
DistantLights grey_sky();

Brdf phong(double exponent);       ///< k_d = k_s = 1/2
Brdf cook_torrance(double slope);  ///< d .3, s .7, eta 1.5, pi1981
Brdf diffuse();

/// A method preset at a map size, as the table uses it: smoothness .3 for the preset paper.
FactorSettings settings_of(Method method, int map_size);

/// Samples of the red channel; green and blue are black, which costs no solve.
LightingSamples red_samples(const Brdf& brdf, const DistantLights& lights, int count,
                            std::uint64_t sequence);

struct Judged {
    FactoredLighting factors;
    double relative_rms = 0.0, log_rms = 0.0;
    double psnr = 0.0;           ///< dB of the displayed product, white = 99th percentile
    double byte_steps = 0.0;     ///< rms of the maps' 8 bits against their floats, of 255
    double largest_ratio = 0.0;  ///< largest texel over the median one, of either map
};

/// Fits `samples` pairs and judges 20,000 others. @param sequence of the fitted pairs
Judged judge(const Brdf& brdf, const DistantLights& lights, const FactorSettings& settings,
             int samples, std::uint64_t sequence = 0);

/// The same fit of all channels at once, for materials whose channels differ.
std::array<ChannelFit, 3> channel_fits(const Brdf& brdf, const DistantLights& lights,
                                       const FactorSettings& settings, int samples);

/// rms / sqrt 2 of the difference of what two results display at one set of pairs, of 255.
double mottle(const Judged& a, const Judged& b);

}  // namespace twofold::quality
