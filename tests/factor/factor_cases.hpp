#pragma once
#include <cmath>
#include <vector>

#include "factor/directions.hpp"
#include "factor/parametrization.hpp"
#include "factor/samples.hpp"
#include "factor/settings.hpp"
#include "texunit/exact_math.hpp"

/// Lighting functions in closed form, sampled for the tests of the factorisation.
namespace twofold::cases {

/// A modified Phong material under directional lights of irradiance 1.
struct Phong {
    double diffuse = 0.5;
    double specular = 0.5;
    double exponent = 50.0;
    std::vector<Vec3> lights{normalized(Vec3{1.0, 1.0, 1.0})};
};

inline double radiance(const Phong& phong, const SurfaceView& at) {
    const Vec3 r = pi_2(at);
    double sum = 0.0;
    for (const Vec3 l : phong.lights) {
        const double cosine = dot(at.n, l);
        if (cosine <= 0.0) continue;
        const double lobe = dot(r, l) > 0.0 ? exact::pow(dot(r, l), phong.exponent) : 0.0;
        sum += cosine * (phong.diffuse / exact::pi +
                         phong.specular * (phong.exponent + 2.0) / (2.0 * exact::pi) * lobe);
    }
    return sum;
}

/// `count` samples, the same in all three channels.
inline LightingSamples samples_of(const Phong& phong, int count, std::uint64_t sequence) {
    LightingSamples samples{surface_views(count, sequence), {}};
    for (const SurfaceView& at : samples.at) samples.radiance.push_back(Rgb(radiance(phong, at)));
    return samples;
}

/// Samples of a function of the pair.
template <class Function>
LightingSamples samples_of_function(int count, std::uint64_t sequence,
                                    const Function& radiance_at) {
    LightingSamples samples{surface_views(count, sequence), {}};
    for (const SurfaceView& at : samples.at) samples.radiance.push_back(radiance_at(at));
    return samples;
}

/// Lights that stand in for a sky and three lamps: enough of them that nothing is separable.
inline std::vector<Vec3> many_lights() {
    std::vector<Vec3> lights;
    for (int i = 0; i < 24; ++i) {
        const double z = -0.2 + 1.1 * i / 23.0;
        const double phi = 2.4 * i;
        const double radius = std::sqrt(1.0 - z * z);
        lights.push_back({radius * exact::cos(phi), radius * exact::sin(phi), z});
    }
    return lights;
}

/// A Phong-like material of exponent 20 under a sky gradient and three lamps: never black.
inline double sky_and_lamps(const SurfaceView& at) {
    const Phong lamps{0.3,
                      0.7,
                      20.0,
                      {normalized(Vec3{0.3, 0.5, 0.8}), normalized(Vec3{-0.8, 0.1, 0.4}),
                       normalized(Vec3{0.2, -0.9, -0.1})}};
    return 0.15 * (1.0 + 0.6 * at.n.z) + 0.25 * (1.0 + 0.8 * pi_2(at).z) + radiance(lamps, at);
}

/// The plain system of the paper: no rows but the samples', every weight 1.
inline FactorSettings unregularised(int map_size, double guard) {
    FactorSettings settings;
    settings.map_size = map_size;
    settings.guard = guard;
    settings.smoothness = 0.0;
    settings.seam = 0.0;
    settings.row_weight = 0.0;
    settings.cap = 0.0;
    return settings;
}

}  // namespace twofold::cases
