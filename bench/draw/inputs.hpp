#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "raster/pass.hpp"

/// What is drawn by both sides: one mesh, two pairs of textures and the matrices.
namespace twofold::bench {

/// The inputs of one drawing, without its state, which belongs to the drawing's name.
struct Inputs {
    std::string drawing;     ///< as in drawing.hpp
    int size = 0;            ///< of the picture, in pixels along an edge
    Mesh mesh;               ///< with normals, colours and the coordinates of units 0 and 1
    std::vector<Vec4> clip;  ///< the positions in clip space
    Mat4 modelview{1.0}, projection{1.0};
    /// [unit][front, back]: dual paraboloids, and what takes an eye-space vector to their s, t, q.
    std::array<std::array<Texture, 2>, 2> textures;
    std::array<std::array<Mat4, 2>, 2> texture_matrices{};

    std::size_t triangles() const { return mesh.indices.size() / 3; }
};

/// A peer's dump: `manifest.txt` and raw little-endian arrays `NAME.TYPExCOUNT`.
/// @throws Error(bad_file) naming the file and the field if one is missing, has another size than
///         the manifest says, or asks for a state that drawing.hpp does not draw
Inputs read_dump(const std::filesystem::path& folder);

/// Inputs of the same kind that need no peer. Textures are as large as the picture, but not more
/// than 256 texels along an edge.
/// @param squares  n for the sphere of 12 n^2 triangles; 0: a quad of two
Inputs make_inputs(const std::string& drawing, int squares, int size);

}  // namespace twofold::bench
