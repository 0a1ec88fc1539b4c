#include "scenes/assets.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "scenes/box_mipmaps.hpp"
#include "scenes/mesh_shapes.hpp"
#include "scenes/texture_images.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

Mesh load_mesh_file(const std::filesystem::path& path) {
    if (path.extension() == ".obj") return read_obj(path);
    if (path.extension() == ".ply") return read_ply(path);
    throw Error(ExitCode::failure, path.string() + ": a mesh file ends in .obj or .ply");
}

struct MeshLoader {
    const std::string& directory;

    Mesh operator()(const MeshFile& file) const {
        return load_mesh_file(std::filesystem::path(directory) / file.path);
    }
    Mesh operator()(const SphereMesh& sphere) const { return sphere_mesh(sphere.subdivisions); }
    Mesh operator()(const QuadMesh&) const { return quad_mesh(); }
    Mesh operator()(const InlineMesh& mesh) const { return mesh.mesh; }
};

struct ImageLoader {
    const std::string& directory;

    Texture operator()(const TextureFile& file) const {
        return texture_of(read_png(std::filesystem::path(directory) / file.path));
    }
    Texture operator()(const Checkerboard& spec) const { return checkerboard(spec); }
    Texture operator()(const InlineTexels& spec) const {
        return {spec.width, spec.height, spec.texels};
    }
};

[[noreturn]] void fail(const std::string& texture, std::string_view what) {
    throw Error(ExitCode::failure, fmt::format("texture '{}': {}", texture, what));
}

/// An image with its levels.
Texture load_levels(const ImageLoader& loader, const std::string& name, const TextureSpec& spec,
                    const TextureImageSpec& which) {
    Texture image = std::visit(loader, which);
    if (spec.border != 0 && (image.width < 3 || image.height < 3))
        fail(name, fmt::format("border: an image of {} x {} has nothing inside its border",
                               image.width, image.height));
    if (spec.mipmaps == Mipmaps::box)
        image.mipmaps = box_mipmaps(image.width, image.height, image.texels, spec.border);
    return image;
}

/// The further faces of a cube map, whose sizes must be those of the first.
void add_face(Texture& texture, Texture face, const std::string& name) {
    if (face.width != face.height || face.width != texture.width)
        fail(name, "the faces of a cube are squares of one size");
    texture.cube_faces.push_back(
        {face.width, face.height, std::move(face.texels), std::move(face.mipmaps)});
}

Texture load_texture(const std::string& directory, const std::string& name,
                     const TextureSpec& spec) {
    const ImageLoader loader{directory};
    Texture texture = load_levels(loader, name, spec, spec.images.front());
    texture.base_format = spec.base_format;
    texture.border = spec.border;
    for (std::size_t i = 1; i < spec.images.size(); ++i)
        add_face(texture, load_levels(loader, name, spec, spec.images[i]), name);
    return texture;
}

}  // namespace

SceneAssets load_assets(const Scene& scene) {
    SceneAssets assets;
    for (const auto& [name, spec] : scene.meshes) {
        const auto it = assets.meshes.emplace(name, std::visit(MeshLoader{scene.directory}, spec));
        assets.mesh_reports.emplace(name, inspect(it.first->second));
    }
    for (const auto& [name, spec] : scene.textures)
        assets.textures.emplace(name, load_texture(scene.directory, name, spec));
    for (const HistoricalObject& object : scene.historical)
        if (!assets.factor_sets.contains(object.factors))
            assets.factor_sets.emplace(
                object.factors,
                read_factor_set(std::filesystem::path(scene.directory) / object.factors));
    return assets;
}

}  // namespace twofold
