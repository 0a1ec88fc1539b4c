#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "scenes/scene_file.hpp"
#include "texunit/error.hpp"

/// What the tests of scene files share.
namespace twofold::scene_text {

inline const std::filesystem::path folder = std::filesystem::path(TWOFOLD_SOURCE_DIR) / "scenes";

inline const std::vector<std::string> shipped{"gold-suzanne.json",    "copper-phong.json",
                                              "gold-arealights.json", "phong-teapot.json",
                                              "sphere-lobe.json",     "two-passes.json"};

inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The smallest scene: one quad.
inline const std::string smallest = R"({"meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})";

/// A scene with one object, everything at its default.
inline const std::string one_object = R"({
  "environment": {"directional": [{"direction": [0, 0, 1], "irradiance": 1}]},
  "materials": {"gold": {"cook_torrance": {"f0": [0.98, 0.77, 0.34]}}},
  "meshes": {"suzanne": {"sphere": {}}},
  "objects": [{"mesh": "suzanne", "material": "gold"}]})";

inline Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "x.json", "", overrides);
}

/// The text of the error that reading `text` gives, or "accepted"; any exception but a plain
/// failure is told.
inline std::string error_of(const std::string& text,
                            const std::vector<std::string>& overrides = {}) {
    try {
        parse(text, overrides);
    } catch (const Error& error) {
        return (error.code() == ExitCode::failure ? "" : "wrong exit code: ") +
               std::string(error.what());
    }
    return "accepted";
}

}  // namespace twofold::scene_text
