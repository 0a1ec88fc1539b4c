#pragma once
#include <map>
#include <string>

#include "raster/mesh.hpp"
#include "scenes/factor_set.hpp"
#include "scenes/mesh_file.hpp"
#include "scenes/scene.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// What a scene names and files hold: loaded once, whatever the presets.
struct SceneAssets {
    std::map<std::string, Mesh> meshes;
    std::map<std::string, MeshReport> mesh_reports;
    std::map<std::string, Texture> textures;
    std::map<std::string, FactorSet> factor_sets;  ///< of historical objects, by their files' paths
};

/// Loads or makes the scene's meshes and textures.
/// @throws Error naming the file that cannot be used
SceneAssets load_assets(const Scene& scene);

}  // namespace twofold
