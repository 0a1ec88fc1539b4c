#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "raster/mesh.hpp"

/// Triangle meshes from files, and what is wrong with a mesh.
/// Both readers are our own. tinyobjloader (Debian's 2.0.0-rc10) counts the corners of a face in a
/// byte, turns an unreadable number into 0, reports no lines, and scales by the C library's pow(),
/// which differs between platforms; the tests use it as a second opinion. Debian has no PLY library
/// that fits.
namespace twofold {

constexpr std::size_t max_mesh_vertices = 10'000'000;
constexpr std::size_t max_mesh_triangles = 20'000'000;

/// The faces of a Wavefront OBJ file: v (with optional w, or r g b in [0, 1]), vt, vn and f;
/// everything else is skipped. A face is cut into the fan of its first corner. Corners with equal
/// indices share one vertex, in order of first use. Normals are made unit; missing or zero ones are
/// computed from the faces that share the position (`vertex_normals`).
/// @throws Error(bad_file) naming file and line: an unreadable or infinite number, an index that is
/// zero or
///         beyond its list, a face of fewer than three corners.
Mesh parse_obj(std::string_view text, const std::string& name);
Mesh read_obj(const std::filesystem::path& path);

/// The faces of a PLY file, ascii or binary little-endian: element `vertex` with x y z and optional
/// nx ny nz, element `face` with the list vertex_indices (or vertex_index); other elements and
/// properties are skipped. Faces and normals as in parse_obj().
/// @throws Error(bad_file) naming the file and the line, element or value at fault.
Mesh parse_ply(std::string_view content, const std::string& name);
Mesh read_ply(const std::filesystem::path& path);

/// What to know about a mesh before it is drawn. Nothing is repaired: normals decide what is lit,
/// and the rasterizer skips degenerate triangles itself.
struct MeshReport {
    std::size_t triangles = 0;
    std::size_t degenerate = 0;          ///< of zero area
    std::size_t boundary_edges = 0;      ///< with one triangle: the mesh is open there
    std::size_t non_manifold_edges = 0;  ///< with three or more
    double signed_volume = 0.0;  ///< positive if triangles are counter-clockwise seen from outside
    bool inverted = false;       ///< signed volume below zero
};

/// Edges are told apart by the positions of their ends, so a seam where only normals or texture
/// coordinates differ is no boundary; edges of degenerate triangles are not counted. The volume is
/// taken about the centre of the bounding box, which keeps its sign meaningful for a nearly closed
/// mesh far from the origin.
MeshReport inspect(const Mesh& mesh);

}  // namespace twofold
