#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scenes/mesh_file.hpp"
#include "tests/temporary_folder.hpp"

/// What the tests of mesh files share.
namespace twofold::mesh_text {

inline const TemporaryFolder& folder() {
    static const TemporaryFolder result;
    return result;
}

inline std::filesystem::path file_of(const std::string& text) {
    // Not write_file_atomically(): thousands of flushes to the disk would take half a minute.
    std::ofstream(folder() / "mesh", std::ios::binary) << text;
    return folder() / "mesh";
}

inline std::filesystem::path product_mesh(const std::string& name) {
    return std::filesystem::path(TWOFOLD_SOURCE_DIR) / "scenes/data/mesh" / name;
}

inline const std::string three_points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

inline Mesh obj(const std::string& text) { return read_obj(file_of(text)); }
inline Mesh ply(const std::string& text) { return read_ply(file_of(text)); }

inline std::string ascii_ply(int vertices, int faces, const std::string& data) {
    return fmt::format(
        "ply\nformat ascii 1.0\ncomment none\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\n"
        "property list uchar int vertex_indices\nend_header\n{}",
        vertices, faces, data);
}

}  // namespace twofold::mesh_text
