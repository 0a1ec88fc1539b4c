#include "scenes/frame.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "scenes/camera.hpp"
#include "scenes/historical.hpp"
#include "scenes/object_passes.hpp"
#include "scenes/scene_names.hpp"
#include "texunit/error.hpp"
#include "texunit/texture_limits.hpp"

namespace twofold {
namespace {

/// @throws Error if the preset's chip does not take textures of this size (T09)
void require_size(const Scene& scene, const std::string& field, Preset preset, TextureTarget target,
                  const Texture& texture) {
    const auto limit = size_limit(preset, target, texture);
    const int width = texture.width - 2 * texture.border;
    const int height = texture.height - 2 * texture.border;
    if (!limit || (limit->allows(width) && limit->allows(height))) return;
    throw Error(
        ExitCode::failure,
        fmt::format("{}: {}: {} x {}: preset {} takes {}sides up to {} for a {}", scene.file, field,
                    width, height, name_of(preset), limit->powers_of_two ? "powers of two as " : "",
                    limit->largest, scene_io::name_in(scene_io::target_names, target)));
}

FrameBuilder start(const Scene& scene, const SceneAssets& assets) {
    const ImageSpec& image = scene.image;
    const double aspect = image.height > 0 ? static_cast<double>(image.width) / image.height : 1.0;
    FrameBuilder b{
        scene, {}, {}, {}, view_matrix(scene.camera), projection_matrix(scene.camera, aspect)};
    b.frame.width = image.width;
    b.frame.height = image.height;
    b.frame.clear_color = Vec4{image.background, 0.0};
    b.frame.clear_depth = image.clear_depth;
    b.frame.color_format = image.color_format;
    b.frame.depth_bits = image.depth_bits;
    for (const auto& [name, mesh] : assets.meshes) {
        b.meshes.emplace(name, b.frame.meshes.size());
        b.frame.meshes.push_back(mesh);
    }
    for (const auto& [name, texture] : assets.textures) {
        b.textures.emplace(name, b.frame.textures.size());
        b.frame.textures.push_back(texture);
    }
    return b;
}

void add_explicit_pass(FrameBuilder& b, const ScenePass& pass, Preset preset) {
    PassState state = pass.state;
    if (!pass.own_matrices) {
        state.modelview = b.view;
        state.projection = b.projection;
    }
    for (std::size_t u = 0; u < state.units.size(); ++u)
        if (auto& unit = state.units[u]; unit && !pass.textures[u].empty()) {
            unit->texture = b.textures.at(pass.textures[u]);
            require_size(b.scene, "textures." + pass.textures[u], preset, unit->target,
                         b.frame.textures[*unit->texture]);
        }
    b.frame.passes.push_back({state, b.meshes.at(pass.mesh)});
}

const FactoredLighting& lighting_of(const FactoredMaterials& materials, const std::string& name) {
    const auto it = materials.find(name);
    if (it == materials.end())
        throw Error(ExitCode::failure, "material '" + name + "' was not factored");
    return it->second;
}

}  // namespace

bool samples_float_textures(Preset preset, const CustomSettings& custom) {
    return preset == Preset::ideal64 || preset == Preset::float32 ||
           (preset == Preset::custom && custom.texel_bits != 8);
}

Frame make_frame(const Scene& scene, const SceneAssets& assets, const FactoredMaterials& materials,
                 Preset preset) {
    FrameBuilder b = start(scene, assets);
    std::map<std::string, std::vector<std::size_t>> factor_textures;
    for (const FactoredObject& object : scene.objects) {
        const FactoredLighting& lighting = lighting_of(materials, object.material);
        const FactorMap& map = lighting.terms.at(0).t2;
        require_size(
            scene, "factorization.map_size", preset,
            map.shape.form == MapForm::cube ? TextureTarget::cube_map : TextureTarget::texture_2d,
            map.bytes[0]);
        std::vector<std::size_t>& textures = factor_textures[object.material];
        for (std::size_t k = textures.size(); k < lighting.terms.size(); ++k)
            textures.push_back(add_factor_textures(b.frame, lighting.terms[k],
                                                   samples_float_textures(preset, scene.custom)));
        add_object_passes(b, object, lighting, textures);
    }
    for (const HistoricalObject& object : scene.historical)
        add_historical(b.frame, object, assets.meshes.at(object.mesh),
                       assets.factor_sets.at(object.factors), scene.camera);
    for (const ScenePass& pass : scene.passes) add_explicit_pass(b, pass, preset);
    return std::move(b.frame);
}

Frame make_surface_frame(const Scene& scene, const SceneAssets& assets) {
    FrameBuilder b = start(scene, assets);
    for (const FactoredObject& object : scene.objects)
        b.frame.passes.push_back({object_state(b, object), b.meshes.at(object.mesh)});
    return std::move(b.frame);
}

}  // namespace twofold
