#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

/// JSON as text: strict reading, changes by path, printing. Nothing here knows what a scene is.
namespace twofold::scene_io {

inline constexpr std::size_t max_json_bytes = std::size_t{1} << 20;
inline constexpr int max_json_depth = 32;

/// The value that `text` stands for; // and /* */ comments are skipped.
///
/// Stricter than the JSON library: a key written twice, a NUL byte, a number beyond binary64, more
/// than `max_json_depth` levels and more than `max_json_bytes` bytes are errors.
/// @param file name for error texts
/// @throws Error naming the file and the field, or line and column where the syntax is wrong
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// `document` with one field set: `change` is `path.to.field=value`, list elements by index. The
/// value is JSON, or else taken as a string, so that `meshes.m.file=a.ply` needs no quotes. Objects
/// on the way that do not exist are made; whether the field is a known one is for the reader to
/// say.
nlohmann::json with_override(nlohmann::json document, std::string_view change,
                             std::string_view file);

/// `document` indented by two spaces, lists of plain values on one line; numbers read back to the
/// same bits.
/// @throws Error if a string is not UTF-8
std::string to_text(const nlohmann::ordered_json& document);

}  // namespace twofold::scene_io
