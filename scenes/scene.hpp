#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/environment.hpp"
#include "factor/settings.hpp"
#include "raster/pass.hpp"
#include "texunit/custom.hpp"
#include "texunit/preset.hpp"

/// A scene file as a value. `scene_file` reads and writes it; `build` makes a Frame of it.
/// The JSON form of every field is described in scenes/scene.schema.json.
namespace twofold {

struct ImageSpec {
    int width = 1024;     ///< pixels
    int height = 768;     ///< pixels
    Rgb background{0.0};  ///< displayed value 0..1, alpha 0
    ColorFormat color_format = ColorFormat::rgba8888;
    int depth_bits = 24;  ///< 16 or 24
    double clear_depth = 1.0;
};

struct Camera {
    Vec3 eye{0.0, 0.0, 3.0};
    Vec3 target{0.0};
    Vec3 up{0.0, 1.0, 0.0};
    double vertical_fov_degrees = 40.0;
    double near_plane = 0.1;  ///< distance, > 0
    double far_plane = 100.0;
};

/// An environment picture (.hdr, .exr); the path is relative to the scene file.
struct EnvironmentFile {
    std::string path;
    EnvironmentForm form = EnvironmentForm::latlong;
    bool repair =
        false;  ///< texels that are not finite become 0 and are counted, instead of an error
    double guard = 1.0;  ///< of dual_paraboloid
    EnvironmentPlacement placement;
};

/// Area lights painted onto a constant background (types of factor/environment.hpp), rendered to a
/// latitude-longitude picture of this size.
struct PaintedLatLong {
    PaintedEnvironment environment;
    int width = 512;
    int height = 256;
};

struct DirectionalLights {
    std::vector<DirectionalLight> lights;
};

struct EnvironmentSpec {
    std::variant<EnvironmentFile, PaintedLatLong, DirectionalLights> source;
    int cells =
        8192;  ///< the picture is averaged to at most so many lights; no effect on directional ones
};

/// The radiance that is displayed as 1.0: a number, or a percentile of the samples' largest
/// channel.
struct WhitePoint {
    std::optional<double> radiance;
    double percentile = 99.0;
};

struct MeshFile {
    std::string path;  ///< .obj or .ply, relative to the scene file
};
struct SphereMesh {
    int subdivisions = 41;  ///< n: 12 n^2 triangles
};
struct QuadMesh {};
/// Vertices written out in the scene file.
struct InlineMesh {
    Mesh mesh;
};
using MeshSpec = std::variant<MeshFile, SphereMesh, QuadMesh, InlineMesh>;

/// A mesh shaded by the paper's method: its material's lighting function, factored and drawn in
/// passes.
struct FactoredObject {
    std::string mesh;
    std::string material;
    Vec3 translation{0.0};
    double scale = 1.0;
    double rotate_y_degrees = 0.0;  ///< applied before the translation
};

/// A mesh shaded by a factor set of McCool's group, p(l) q(h) p(v), as its own renderer showed it:
/// under one directional light, factors as 8-bit textures, in two passes of two units.
struct HistoricalObject {
    std::string mesh;
    std::string factors;        ///< the set's text file, relative to the scene file
    Vec3 light{0.0, 0.0, 1.0};  ///< towards the light, world space, not zero
    Rgb irradiance{1.0};
    double diffuse = 5.0;  ///< the group's own display constants
    double specular = 0.5;
    Vec3 translation{0.0};
    double scale = 1.0;
    double rotate_y_degrees = 0.0;
};

/// Images of explicit passes' textures: a PNG file, a checkerboard, or texels as they are stored.
struct TextureFile {
    std::string path;  ///< relative to the scene file
};
struct Checkerboard {
    int width = 8;
    int height = 8;
    int cell = 1;     ///< texels along the edge of one field
    Vec4 first{1.0};  ///< texel (0, 0)
    Vec4 second{0.0, 0.0, 0.0, 1.0};
};
/// Written out in the scene file, so that a scene can say every bit of a texture.
struct InlineTexels {
    int width = 0;
    int height = 0;
    PackedTexels texels;
};
using TextureImageSpec = std::variant<TextureFile, Checkerboard, InlineTexels>;

/// Where the levels below the base image come from; `box` averages 2 x 2 texels, down to one texel.
enum class Mipmaps { none, box };

struct TextureSpec {
    std::vector<TextureImageSpec> images;  ///< one, or the faces +x, -x, +y, -y, +z, -z of a cube
    BaseFormat base_format = BaseFormat::rgba;
    Mipmaps mipmaps = Mipmaps::none;  ///< of every face
    int border = 0;                   ///< texels around every image that its size counts: 0 or 1
};

/// An explicit pass. `state.units[i].texture` is not used: `textures[i]` names the texture instead.
/// Without `own_matrices` the modelview and projection are the camera's.
struct ScenePass {
    std::string mesh;
    std::array<std::string, max_units> textures;  ///< a name in Scene::textures; empty = none
    bool own_matrices = false;
    PassState state;
};

/// The presets of a scene that names none: the truth, floats, and the paper's card between them.
inline constexpr std::array usual_presets{Preset::ideal64, Preset::float32, Preset::gl13,
                                          Preset::nv17};

struct Scene {
    std::string title;
    std::string
        directory;  ///< where relative paths start: that of the scene file, unless it names one
    ImageSpec image;
    Camera camera;
    std::optional<EnvironmentSpec> environment;  ///< needed when there are objects
    WhitePoint white;
    FactorSettings factorization;
    std::map<std::string, Brdf> materials;
    std::map<std::string, MeshSpec> meshes;
    std::map<std::string, TextureSpec> textures;
    std::vector<FactoredObject> objects;       ///< drawn first, in order
    std::vector<HistoricalObject> historical;  ///< drawn after the objects, in order
    std::vector<ScenePass> passes;             ///< drawn last, in order
    std::vector<Preset> presets;               ///< at least one
    CustomSettings custom;                     ///< of the preset `custom`
    std::string file{};                        ///< stands for the scene in error texts
};

}  // namespace twofold
