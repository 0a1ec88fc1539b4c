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

/// Forms of environment pictures. All but the strips show the sphere from inside, forward (-z) in
/// the middle and up (+y) above it, before they are turned.
enum class EnvironmentForm {
    latlong,          ///< latitude_longitude()
    probe,            ///< angular map: a disc, forward in its centre, backward on its rim
    cube_cross,       ///< 4 x 3 faces, backward on the right, or 3 x 4, backward below, upside down
    cube_strip,       ///< six faces +x to -z, laid out as OpenGL's cube maps are
    cube_openexr,     ///< six faces +x to -z, laid out as OpenEXR has them
    dual_paraboloid,  ///< front (+z) and back maps side by side or one above the other
};

/// How an environment picture becomes lights.
struct EnvironmentSettings {
    int cells = 8192;     ///< most lights wanted, >= 1
    bool repair = false;  ///< a NaN or infinity becomes 0 and is counted, instead of being an error
    EnvironmentForm form = EnvironmentForm::latlong;
    double guard = 1.0;  ///< of dual_paraboloid: radius of the disc over half the edge of a map
};

/// How the picture lies in the world and what its values are worth (D07).
struct EnvironmentPlacement {
    Vec3 forward{0.0, 0.0, -1.0};  ///< where the picture's -z looks
    Vec3 up{0.0, 1.0, 0.0};        ///< what is above it; only its part across `forward` matters
    bool mirror = false;           ///< left and right are exchanged first
    double scale = 1.0;            ///< radiance of the value 1
    bool operator==(const EnvironmentPlacement&) const = default;
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

/// The lights of a picture of any form. Forms other than latlong consist of square maps: cells are
/// boxes of k x k texels, k the smallest that leaves at most `cells` of them, and become one light
/// in the mean direction of their texels. A texel whose centre shows no direction (outside the disc
/// of a probe or of a paraboloid) is not looked at, whatever it holds (D06). Solid angles are those
/// of texel centres, scaled together to 4 pi.
/// @throws Error as latitude_longitude(), and Error(bad_file) where the form has another shape
/// @source docs/method.md, section 4
Environment environment_of(const FloatImage& image, const EnvironmentSettings& settings,
                           std::string_view name);

/// The lights turned and scaled.
/// @throws Error(failure) where `forward` is zero or parallel to `up`
DistantLights placed(DistantLights lights, const EnvironmentPlacement& placement);

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
