#include "scenes/json_text.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_json.hpp"
#include "scenes/scene_names.hpp"

namespace twofold {
namespace scene_io {

Json json_of(Preset preset) { return name_of(preset); }
Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }
Json json_of(Vec4 v) { return {v.x, v.y, v.z, v.w}; }

Json json_of(const Mat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) rows.push_back(matrix[column][row]);
    return rows;
}

Json json_of(const ImageSpec& image) {
    return {{"width", image.width},
            {"height", image.height},
            {"background", json_of(image.background)},
            {"color_format", name_in(color_format_names, image.color_format)},
            {"depth_bits", image.depth_bits},
            {"clear_depth", image.clear_depth}};
}

Json json_of(const Camera& camera) {
    return {{"eye", json_of(camera.eye)}, {"target", json_of(camera.target)},
            {"up", json_of(camera.up)},   {"vertical_fov_degrees", camera.vertical_fov_degrees},
            {"near", camera.near_plane},  {"far", camera.far_plane}};
}

Json json_of(const CustomSettings& custom) {
    return {{"filter_weight_bits", custom.filter_weight_bits},
            {"filter_rounding", name_in(filter_rounding_names, custom.filter_rounding)},
            {"product_rounding", name_in(product_rounding_names, custom.product_rounding)},
            {"texel_bits", custom.texel_bits},
            {"register_bits", custom.register_bits},
            {"vertex_color", name_in(vertex_color_names, custom.vertex_color)},
            {"snap_bits", custom.snap_bits},
            {"snap_bias", custom.snap_bias},
            {"framebuffer_bits", custom.framebuffer_bits}};
}

Json json_of(const FactoredObject& object) {
    return {{"mesh", object.mesh},
            {"material", object.material},
            {"translation", json_of(object.translation)},
            {"scale", object.scale},
            {"rotate_y_degrees", object.rotate_y_degrees}};
}

Json json_of(const HistoricalObject& object) {
    return {{"mesh", object.mesh},
            {"factors", object.factors},
            {"light", json_of(object.light)},
            {"irradiance", json_of(object.irradiance)},
            {"diffuse", object.diffuse},
            {"specular", object.specular},
            {"translation", json_of(object.translation)},
            {"scale", object.scale},
            {"rotate_y_degrees", object.rotate_y_degrees}};
}

namespace {

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
            {"historical", list_of(scene.historical)},
            {"passes", list_of(scene.passes)},
            {"presets", list_of(scene.presets)},
            {"custom", json_of(scene.custom)}};
}

}  // namespace
}  // namespace scene_io

std::string scene_to_json(const Scene& scene) {
    return scene_io::to_text(scene_io::document_of(scene));
}

}  // namespace twofold
