#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "factor/factorize.hpp"
#include "factor_cases.hpp"

/// What the tests of the whole factorisation share: short ways in, and the result as numbers.
namespace twofold::cases {

inline FactorSettings map_of(int size) {
    FactorSettings settings;
    settings.map_size = size;
    return settings;
}

/// One channel of a factor's float images, front then back.
inline std::vector<double> texels_of(const FactorMap& map, std::size_t channel) {
    std::vector<double> texels;
    for (const Texture& face : map.real) {
        for (const Rgba32f& texel : std::get<std::vector<Rgba32f>>(face.texels)) {
            texels.push_back(static_cast<double>(texel[channel]));
        }
    }
    return texels;
}

/// 99th percentile of a channel of samples.
inline double white_of(const LightingSamples& samples) {
    std::vector<double> values = channel_of(samples.radiance, 0);
    std::stable_sort(values.begin(), values.end());
    return values[values.size() * 99 / 100];
}

inline FactoredLighting factored_phong(const FactorSettings& settings, int samples,
                                       int threads = 2) {
    const LightingSamples held_out = samples_of({}, 20000, 2);
    return factorize(samples_of({}, samples, 1), held_out, settings, white_of(held_out), threads);
}

inline bool any_contains(const std::vector<std::string>& warnings, const std::string& part) {
    for (const std::string& warning : warnings) {
        if (warning.find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace twofold::cases
