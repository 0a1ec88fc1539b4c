#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/samples.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// How a latitude-longitude picture becomes lights.
struct EnvironmentSettings {
    int cells = 8192;     ///< most lights wanted, >= 1
    bool repair = false;  ///< a NaN or infinity becomes 0 and is counted, instead of being an error
};

/// What was found in the picture and done to it.
struct EnvironmentReport {
    int width = 0, height = 0;       ///< of the picture, texels
    int box = 1;                     ///< k: k x k texels were averaged to a cell
    int split = 1;                   ///< m: a texel was cut into m x m cells (small pictures)
    int cells = 0;                   ///< lights made
    int ignored_channels = 0;        ///< alpha and others beyond the third
    std::int64_t non_finite = 0;     ///< values repaired to 0
    std::int64_t negative = 0;       ///< values raised to 0
    double negative_share = 0.0;     ///< of all values read
    double least_value = 0.0;        ///< lowest finite value met, before it was raised
    double solid_angle = 0.0;        ///< sum over the cells; 4 pi up to rounding
    std::array<int, 2> brightest{};  ///< texel (x, y) that carries most energy; row 0 on top
    double brightest_share =
        0.0;  ///< of the energy of all texels and channels; 0 in a black picture
};

struct Environment {
    DistantLights lights;
    EnvironmentReport report;
};

/// The lights of a latitude-longitude picture: its centre column is forward (-z), its top row is up
/// (y). Cells are boxes of k x k texels, k the smallest that leaves at most `cells` of them (boxes
/// at the right and lower edge may be partial); a picture of few texels is cut finer instead, each
/// texel constant. A cell becomes one light in the middle of its angular extent with W = sum of
/// radiance * solid angle, so the energy is kept. Lights are ordered by tiles of 16 x 16 cells: a
/// block is a compact patch of sky.
/// @param image 1 channel (grey), or 3 and more (red, green, blue, the rest ignored); linear
/// radiance
/// @param name of the picture, for the text of an error
/// @throws Error(bad_file) where sizes make no sense or, without repair, a value is not finite
/// @source docs/method.md, section 4
Environment latitude_longitude(const FloatImage& image, const EnvironmentSettings& settings,
                               std::string_view name);

/// A disc of even radiance on the sphere.
struct DiscLight {
    Vec3 direction;           ///< to its centre, world space, not zero
    double half_angle = 1.0;  ///< degrees, 0 < half_angle <= 180
    Rgb radiance{1.0};
};

/// An even background with discs on it; a later disc covers an earlier one.
struct PaintedEnvironment {
    Rgb background{0.0};
    std::vector<DiscLight> discs;
};

/// The painted environment as a latitude-longitude picture of three channels. A texel is inside a
/// disc where its centre is: edges are as coarse as the texels.
/// @throws Error(failure) where a disc has no direction or covers no texel centre
FloatImage paint(const PaintedEnvironment& environment, int width, int height);

/// A light so far away that its rays are parallel.
struct DirectionalLight {
    Vec3 direction;       ///< towards the light, world space, not zero
    Rgb irradiance{1.0};  ///< on a surface that faces it, >= 0
};

/// One light each, in the order given.
/// @throws Error(failure) where a direction is zero or an irradiance negative or not finite
DistantLights directional_lights(std::span<const DirectionalLight> lights);

/// The same radiance from everywhere, in at most `cells` lights.
DistantLights constant_environment(Rgb radiance, int cells);

/// Root mean square of the difference of L_o over that of `full`, all views and channels together:
/// what averaging cost. A diffuse material gives the cost in irradiance. 0 where both are black.
double relative_rms_difference(const Brdf& brdf, const DistantLights& averaged,
                               const DistantLights& full, std::span<const SurfaceView> at,
                               int threads);

/// relative_rms_difference of the lights that `settings` gives against one light a texel.
double averaging_cost(const Brdf& brdf, const FloatImage& image,
                      const EnvironmentSettings& settings, std::span<const SurfaceView> at,
                      int threads);

}  // namespace twofold
