#include "scenes/scene_json.hpp"
#include "scenes/scene_names.hpp"

/// Meshes and textures as JSON.
namespace twofold::scene_io {
namespace {

/// One list where only unit 0 has coordinates, else one for each unit.
Json texcoords_of(const Mesh& mesh) {
    bool only_first = true;
    for (std::size_t i = 1; i < mesh.texcoords.size(); ++i)
        only_first = only_first && mesh.texcoords[i].empty();
    if (only_first) return list_of(mesh.texcoords[0]);
    Json units = Json::object();
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i)
        units[std::to_string(i)] = list_of(mesh.texcoords[i]);
    return units;
}

Json mesh_of(const MeshFile& file) { return {{"file", file.path}}; }
Json mesh_of(const SphereMesh& sphere) {
    return {{"sphere", {{"subdivisions", sphere.subdivisions}}}};
}
Json mesh_of(const QuadMesh&) { return {{"quad", Json::object()}}; }
Json mesh_of(const InlineMesh& vertices) {
    const Mesh& mesh = vertices.mesh;
    return {{"vertices",
             {{"primitive", name_in(primitive_names, mesh.primitive)},
              {"positions", list_of(mesh.positions)},
              {"position_w", Json(mesh.position_w)},
              {"normals", list_of(mesh.normals)},
              {"texcoords", texcoords_of(mesh)},
              {"colors", list_of(mesh.colors)},
              {"secondary_colors", list_of(mesh.secondary_colors)},
              {"indices", Json(mesh.indices)}}}};
}

Json image_of(const TextureFile& file) { return {{"file", file.path}}; }
Json image_of(const Checkerboard& board) {
    return {{"checkerboard",
             {{"width", board.width},
              {"height", board.height},
              {"cell", board.cell},
              {"first", json_of(board.first)},
              {"second", json_of(board.second)}}}};
}
Json image_of(const InlineTexels& image) {
    return {{"texels",
             {{"width", image.width},
              {"height", image.height},
              {"format", name_in(texture_format_names, image.texels.format)},
              {"bytes", Json(image.texels.bytes)}}}};
}

}  // namespace

Json json_of(const MeshSpec& mesh) {
    return std::visit([](const auto& kind) { return mesh_of(kind); }, mesh);
}

Json json_of(const TextureImageSpec& image) {
    return std::visit([](const auto& kind) { return image_of(kind); }, image);
}

Json json_of(const TextureSpec& texture) {
    const bool cube = texture.images.size() > 1;
    Json json = cube ? Json{{"cube", {{"faces", list_of(texture.images)}}}}
                     : json_of(texture.images.front());
    json["base_format"] = name_in(base_format_names, texture.base_format);
    json["mipmaps"] = name_in(mipmaps_names, texture.mipmaps);
    json["border"] = texture.border;
    return json;
}

}  // namespace twofold::scene_io
