#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

/// One cell of a study as a value: a scene under one preset and a way of drawing it.
namespace twofold {

/// How the light on the objects is found. `exact` sums equation (1) at every pixel and
/// `vertex_sum` at every vertex; `vertex_lights` is OpenGL's own lighting by a few lights.
enum class Technique { factored, exact, vertex_sum, vertex_lights };

/// The fast pipeline with and without fused passes, or the reference.
enum class DrawWay { fused, literal, reference };

/// The filter of every texture unit; `trilinear` also gives every texture its mipmaps.
enum class TexelFilter { linear, nearest, trilinear };

/// What of a cell no scene file says: the fields `draw.*` of a study.
struct DrawSettings {
    Technique technique = Technique::factored;
    int lights = 8;  ///< of vertex_lights, 1 to 8
    DrawWay way = DrawWay::fused;
    TexelFilter filter = TexelFilter::linear;
    bool operator==(const DrawSettings&) const = default;
};

struct Cell {
    Scene scene;  ///< names one preset
    DrawSettings draw;
    int white_samples = 0;  ///< samples whose percentile is the white point, where it is one
};

/// A scene file read once, of which cells are made.
struct SceneSource {
    std::string text, name;
    std::filesystem::path directory;
};

/// @throws Error if the file cannot be read
SceneSource read_source(const std::filesystem::path& path);

/// The cell that `changes` make of the scene, each `path=value`, in order; those of `draw.` change
/// the settings above, the others the scene.
/// @throws Error naming field and value
Cell make_cell(const SceneSource& source, const std::vector<std::string>& changes);

/// Hashes of the files that scenes name, each read once.
class InputHashes {
  public:
    /// One hash of the bytes of all files that the scene reads.
    /// @throws Error naming a file that cannot be read
    std::string of(const Scene& scene);

  private:
    std::map<std::filesystem::path, std::string> known_;
};

/// What decides a part of a cell's work, as text: two cells with the same text share that work.
struct CellKeys {
    std::string assets;    ///< meshes and textures
    std::string lighting;  ///< samples of the lighting functions
    std::string truth;     ///< the exact picture
    std::string factors;   ///< the factorisation
    std::string ideal;     ///< the picture under ideal64
};

CellKeys keys_of(const Cell& cell, InputHashes& inputs);

/// 16 hexadecimal digits that name the cell: FNV-1a of all that decides its result (scene without
/// title and folder, bytes of the input files, way of drawing, versions of program and preset).
std::string id_of(const Cell& cell, InputHashes& inputs);

}  // namespace twofold
