#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.hpp"
#include "tests/raster/random/random_state.hpp"

/// A random state as a scene file, so that the program can draw what the tester found.
namespace twofold::test {

inline constexpr std::string_view floats_became_bytes = "texels of floats became bytes";
inline constexpr std::string_view background_is_rounded =
    "what the picture holds at the start is rounded as the preset's texels and pixels are";

/// The frame as explicit passes over inline meshes and textures. What the picture holds at the
/// start becomes a first pass, which draws the texture `background` (a file beside the scene) as it
/// is, but for custom's roundings of texels and pixels. Texels of floats that are no chequer become
/// bytes; `notes` says what was changed.
struct StateScene {
    Scene scene;
    std::optional<ByteImage> background;  ///< what the file `background` is to hold
    std::vector<std::string> notes;
};

StateScene scene_of(const RandomState& state, const std::string& background_file);

/// Writes FOLDER/NAME.json, and FOLDER/NAME-background.png where it is needed.
/// @return what a reader should know, one sentence each
std::vector<std::string> write_state(const RandomState& state, const std::filesystem::path& folder,
                                     const std::string& name);

/// The state that the scene file written by write_state describes.
RandomState read_state(const RandomState& written, const std::filesystem::path& scene);

}  // namespace twofold::test
