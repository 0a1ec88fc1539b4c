#pragma once
#include <string_view>

#include "scenes/json_reader.hpp"
#include "scenes/scene.hpp"

/// The parts of a scene file, read one by one; `parse_scene` puts them together.
namespace twofold::scene_io {

/// Positions and distances: far beyond use, yet squares and products of a few stay finite.
inline constexpr Range coordinates{.low = -1e9, .high = 1e9};
inline constexpr Range unit_interval{.low = 0.0, .high = 1.0};
inline constexpr std::size_t max_named = 256;  ///< meshes, textures, materials, objects, passes
inline constexpr std::size_t max_lights = 4096;
inline constexpr std::size_t max_indices = std::size_t{1} << 20;  ///< a file has no room for more

inline constexpr std::size_t max_inline_texels = 4096;
/// The most bytes a list of texels holds: four for each.
inline constexpr std::size_t max_inline_bytes = 4 * max_inline_texels;

/// A scale of a texture environment: 1, 2 or 4.
int read_scale(const JsonValue& value);
EnvironmentSpec read_environment(const JsonValue& value);
WhitePoint read_white(const JsonValue& value);
Brdf read_material(const JsonValue& value);
FactorSettings read_factorization(const JsonValue& value);
MeshSpec read_mesh(const JsonValue& value);
TextureSpec read_texture(const JsonValue& value);
HistoricalObject read_historical(const JsonValue& value);
ScenePass read_pass(const JsonValue& value);
std::vector<Preset> read_presets(const JsonValue& value);
CustomSettings read_custom(const JsonValue& value);
/// The texture units of a pass and the names of their textures.
void read_units(const JsonValue& value, ScenePass& pass);
RegisterCombiners read_combiners(const JsonValue& value);

/// What no single field can tell: names that must exist, matrices that must have an inverse, paths.
/// @param may_be_absolute whether paths may be absolute
/// @throws Error naming `file` and the field
void check_scene(const Scene& scene, std::string_view file, bool may_be_absolute);

}  // namespace twofold::scene_io
