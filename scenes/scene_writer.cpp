#include "scenes/json_text.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_names.hpp"

namespace twofold {
namespace scene_io {
namespace {

using Json = nlohmann::ordered_json;

// Declared ahead for the templates below, which find no later ones: their types are of another
// namespace.
Json json_of(const DiscLight&);
Json json_of(const DirectionalLight&);
Json json_of(const EnvironmentSpec&);
Json json_of(const BeckmannLobe&);
Json json_of(const Brdf&);
Json json_of(const MeshSpec&);
Json json_of(const TextureSpec&);
Json json_of(const FactoredObject&);
Json json_of(const AlphaTest&);
Json json_of(const DepthTest&);
Json json_of(const Blend&);
Json json_of(const ScenePass&);

Json json_of(Preset preset) { return name_of(preset); }
Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }
Json json_of(Vec4 v) { return {v.x, v.y, v.z, v.w}; }

/// Row by row, as one writes a matrix.
Json json_of(const Mat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) rows.push_back(matrix[column][row]);
    return rows;
}

template <class T>
Json list_of(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(json_of(value));
    return list;
}

template <class T>
Json map_of(const std::map<std::string, T>& values) {
    Json map = Json::object();
    for (const auto& [name, value] : values) map[name] = json_of(value);
    return map;
}

/// What can be switched off is null then.
template <class T>
Json optional_of(const std::optional<T>& value) {
    return value ? json_of(*value) : Json(nullptr);
}

Json json_of(const ImageSpec& image) {
    return {{"width", image.width},
            {"height", image.height},
            {"background", json_of(image.background)}};
}

Json json_of(const Camera& camera) {
    return {{"eye", json_of(camera.eye)}, {"target", json_of(camera.target)},
            {"up", json_of(camera.up)},   {"vertical_fov_degrees", camera.vertical_fov_degrees},
            {"near", camera.near_plane},  {"far", camera.far_plane}};
}

Json json_of(const DiscLight& light) {
    return {{"direction", json_of(light.direction)},
            {"half_angle_degrees", light.half_angle},
            {"radiance", json_of(light.radiance)}};
}

Json json_of(const DirectionalLight& light) {
    return {{"direction", json_of(light.direction)}, {"irradiance", json_of(light.irradiance)}};
}

Json source_of(const LatLongFile& file) {
    return {{"latlong", file.path}, {"repair", file.repair}};
}

Json source_of(const PaintedLatLong& painted) {
    return {{"painted",
             {{"background", json_of(painted.environment.background)},
              {"lights", list_of(painted.environment.discs)},
              {"width", painted.width},
              {"height", painted.height}}}};
}

Json source_of(const DirectionalLights& directional) {
    return {{"directional", list_of(directional.lights)}};
}

Json json_of(const EnvironmentSpec& environment) {
    Json json =
        std::visit([](const auto& source) { return source_of(source); }, environment.source);
    json["cells"] = environment.cells;
    return json;
}

Json json_of(const WhitePoint& white) {
    if (white.radiance) return *white.radiance;
    return {{"percentile", white.percentile}};
}

Json json_of(const FactorSettings& settings) {
    return {{"method", name_in(method_names, settings.method)},
            {"map_size", settings.map_size},
            {"guard", settings.guard},
            {"samples", settings.samples},
            {"held_out", settings.held_out},
            {"solver", name_in(solver_names, settings.solver)},
            {"tolerance", settings.tolerance},
            {"iteration_limit", settings.iteration_limit},
            {"floor", settings.floor},
            {"cap", settings.cap},
            {"row_weight", settings.row_weight},
            {"smoothness", settings.smoothness},
            {"seam", settings.seam},
            {"column_scaling", settings.column_scaling},
            {"fill_power", settings.fill_power}};
}

Json json_of(const BeckmannLobe& lobe) { return {{"m", lobe.m}, {"weight", lobe.weight}}; }

Json material_of(const CookTorrance& brdf) {
    return {{"cook_torrance",
             {{"diffuse", json_of(brdf.diffuse)},
              {"specular", json_of(brdf.specular)},
              {"f0", json_of(brdf.f0)},
              {"lobes", list_of(brdf.lobes)},
              {"constant", name_in(constant_names, brdf.constant)}}}};
}

Json material_of(const ModifiedPhong& brdf) {
    return {{"modified_phong",
             {{"diffuse", json_of(brdf.diffuse)},
              {"specular", json_of(brdf.specular)},
              {"exponent", brdf.exponent}}}};
}

Json json_of(const Brdf& brdf) {
    return std::visit([](const auto& model) { return material_of(model); }, brdf);
}

Json mesh_of(const MeshFile& file) { return {{"file", file.path}}; }
Json mesh_of(const SphereMesh& sphere) {
    return {{"sphere", {{"subdivisions", sphere.subdivisions}}}};
}
Json mesh_of(const QuadMesh&) { return {{"quad", Json::object()}}; }
Json mesh_of(const InlineMesh& vertices) {
    const Mesh& mesh = vertices.mesh;
    return {{"vertices",
             {{"positions", list_of(mesh.positions)},
              {"normals", list_of(mesh.normals)},
              {"texcoords", list_of(mesh.texcoords)},
              {"colors", list_of(mesh.colors)},
              {"indices", Json(mesh.indices)}}}};
}

Json json_of(const MeshSpec& mesh) {
    return std::visit([](const auto& kind) { return mesh_of(kind); }, mesh);
}

Json texture_of(const TextureFile& file) { return {{"file", file.path}}; }
Json texture_of(const Checkerboard& board) {
    return {{"checkerboard",
             {{"width", board.width},
              {"height", board.height},
              {"cell", board.cell},
              {"first", json_of(board.first)},
              {"second", json_of(board.second)}}}};
}

Json json_of(const TextureSpec& texture) {
    return std::visit([](const auto& kind) { return texture_of(kind); }, texture);
}

Json json_of(const FactoredObject& object) {
    return {{"mesh", object.mesh},
            {"material", object.material},
            {"translation", json_of(object.translation)},
            {"scale", object.scale},
            {"rotate_y_degrees", object.rotate_y_degrees}};
}

Json unit_of(const TextureUnitState& unit, const std::string& texture) {
    return {{"texture", texture.empty() ? Json(nullptr) : Json(texture)},
            {"texgen", name_in(texgen_names, unit.texgen)},
            {"matrix", json_of(unit.matrix)},
            {"wrap_s", name_in(wrap_names, unit.wrap_s)},
            {"wrap_t", name_in(wrap_names, unit.wrap_t)},
            {"filter", name_in(filter_names, unit.filter)},
            {"border_color", json_of(unit.border_color)},
            {"rgb_scale", unit.rgb_scale}};
}

Json json_of(const AlphaTest& test) {
    return {{"func", name_in(compare_names, test.func)}, {"reference", test.reference}};
}

Json json_of(const DepthTest& test) {
    return {{"func", name_in(compare_names, test.func)}, {"write", test.write}};
}

Json json_of(const Blend& blend) {
    return {{"source", name_in(blend_names, blend.source)},
            {"destination", name_in(blend_names, blend.destination)}};
}

Json units_of(const ScenePass& pass) {
    Json units = Json::array();
    for (std::size_t i = 0; i < pass.state.units.size(); ++i) {
        const auto& unit = pass.state.units[i];
        units.push_back(unit ? unit_of(*unit, pass.textures[i]) : Json(nullptr));
    }
    return units;
}

Json json_of(const ScenePass& pass) {
    const PassState& state = pass.state;
    return {{"mesh", pass.mesh},
            {"modelview", pass.own_matrices ? json_of(state.modelview) : Json(nullptr)},
            {"projection", pass.own_matrices ? json_of(state.projection) : Json(nullptr)},
            {"color", json_of(state.color)},
            {"normalize", state.normalize},
            {"cull", name_in(cull_names, state.cull)},
            {"units", units_of(pass)},
            {"alpha_test", optional_of(state.alpha_test)},
            {"depth_test", optional_of(state.depth_test)},
            {"blend", optional_of(state.blend)},
            {"color_mask", Json(state.color_mask)}};
}

Json document_of(const Scene& scene) {
    return {{"title", scene.title},
            {"directory", scene.directory},
            {"image", json_of(scene.image)},
            {"camera", json_of(scene.camera)},
            {"environment", optional_of(scene.environment)},
            {"white", json_of(scene.white)},
            {"factorization", json_of(scene.factorization)},
            {"materials", map_of(scene.materials)},
            {"meshes", map_of(scene.meshes)},
            {"textures", map_of(scene.textures)},
            {"objects", list_of(scene.objects)},
            {"passes", list_of(scene.passes)},
            {"presets", list_of(scene.presets)}};
}

}  // namespace
}  // namespace scene_io

std::string scene_to_json(const Scene& scene) {
    return scene_io::to_text(scene_io::document_of(scene));
}

}  // namespace twofold
