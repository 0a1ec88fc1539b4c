#include "scenes/assets.hpp"

#include <filesystem>

#include "scenes/mesh_shapes.hpp"
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

struct TextureLoader {
    const std::string& directory;

    Texture operator()(const TextureFile& file) const {
        return texture_of(read_png(std::filesystem::path(directory) / file.path));
    }
    Texture operator()(const Checkerboard& spec) const { return checkerboard(spec); }
};

Rgba32f rgba32f_of(const Vec4& c) {
    return {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z),
            static_cast<float>(c.w)};
}

}  // namespace

Texture texture_of(const ByteImage& image) {
    std::vector<Rgba8> texels;
    texels.reserve(image.pixels.size());
    const auto row_size = static_cast<std::ptrdiff_t>(image.width);
    for (int y = image.height - 1; y >= 0; --y) {
        const auto row = image.pixels.begin() + y * row_size;
        texels.insert(texels.end(), row, row + row_size);
    }
    return {image.width, image.height, std::move(texels)};
}

Texture checkerboard(const Checkerboard& spec) {
    std::vector<Rgba32f> texels;
    for (int j = 0; j < spec.height; ++j)
        for (int i = 0; i < spec.width; ++i) {
            const bool odd = ((i / spec.cell + j / spec.cell) & 1) != 0;
            texels.push_back(rgba32f_of(odd ? spec.second : spec.first));
        }
    return {spec.width, spec.height, std::move(texels)};
}

SceneAssets load_assets(const Scene& scene) {
    SceneAssets assets;
    for (const auto& [name, spec] : scene.meshes) {
        const auto it = assets.meshes.emplace(name, std::visit(MeshLoader{scene.directory}, spec));
        assets.mesh_reports.emplace(name, inspect(it.first->second));
    }
    for (const auto& [name, spec] : scene.textures)
        assets.textures.emplace(name, std::visit(TextureLoader{scene.directory}, spec));
    return assets;
}

}  // namespace twofold
