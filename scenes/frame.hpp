#pragma once
#include <map>
#include <string>

#include "factor/factorize.hpp"
#include "scenes/assets.hpp"

namespace twofold {

/// Lighting functions by material name.
using FactoredMaterials = std::map<std::string, FactoredLighting>;

/// Whether a preset samples the factors as float textures (ideal64, float32, custom with texels of
/// other than 8 bits) or as bytes.
bool samples_float_textures(Preset preset, const CustomSettings& custom);

/// The scene as passes: each object by the paper's four (front and back of t1 times front and back
/// of t2, chosen by the alpha test), or by one where the maps are cube maps, for each product of
/// the sum, its doubling passes, the historical objects, then the explicit passes.
/// @throws Error if a material that an object names was not factored, or if the preset's chip does
/// not take a texture's size
Frame make_frame(const Scene& scene, const SceneAssets& assets, const FactoredMaterials& materials,
                 Preset preset);

/// One plain pass an object, in order: for visible_surface().
Frame make_surface_frame(const Scene& scene, const SceneAssets& assets);

}  // namespace twofold
