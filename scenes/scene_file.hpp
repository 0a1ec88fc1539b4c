#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.hpp"

/// Scene files: JSON with comments, described by scenes/scene.schema.json.
namespace twofold {

/// The scene in the file at `path`, whose `directory` is the file's own, made absolute.
///
/// @param overrides changes `path.to.field=value` applied before reading, in order; list elements
/// by
///        index, as in `objects.0.scale=2`. The value is JSON, or else taken as a text.
/// @throws Error `bad_file` if the file cannot be read; `failure` for everything wrong in it,
/// naming the
///         file, the path of the field and its value, and for a wrong name the nearest known one
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The scene that `text` describes.
///
/// @param name stands for the file in error texts
/// @param directory where relative paths start, unless the text has the field `directory`, which is
///        itself relative to this one
Scene parse_scene(std::string_view text, const std::string& name,
                  const std::filesystem::path& directory,
                  const std::vector<std::string>& overrides = {});

/// `scene` as a scene file in which every field is written out, `directory` too, so that the text
/// means the same in any folder; parse_scene gives the same scene back, numbers to the bit.
std::string scene_to_json(const Scene& scene);

}  // namespace twofold
