#include "scenes/scene_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "scenes/json_text.hpp"
#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"
#include "texunit/error.hpp"

namespace twofold {
namespace scene_io {
namespace {

int read_depth_bits(const JsonObject& fields, int absent) {
    const auto value = fields.find("depth_bits");
    if (!value) return absent;
    const int bits = value->integer(16, 24);
    if (bits != 16 && bits != 24) value->fail(fmt::format("{} is not one of 16, 24", bits));
    return bits;
}

ImageSpec read_image(const JsonValue& value) {
    const JsonObject fields(
        value, {"width", "height", "background", "color_format", "depth_bits", "clear_depth"});
    const ImageSpec absent;
    // The largest picture, 16384 x 16384, has 2^28 pixels: what int64 edge functions and memory
    // allow.
    return {
        .width = fields.integer("width", 1, 16384, absent.width),
        .height = fields.integer("height", 1, 16384, absent.height),
        .background = fields.rgb("background", unit_interval, absent.background),
        .color_format = fields.enumerator("color_format", color_format_names, absent.color_format),
        .depth_bits = read_depth_bits(fields, absent.depth_bits),
        .clear_depth = fields.number("clear_depth", unit_interval, absent.clear_depth)};
}

/// A camera that looks somewhere, and whose projection has no division by zero.
void check_camera(const Camera& camera, const JsonObject& fields) {
    const auto fail = [&](std::string_view name, const std::string& what) {
        if (const auto field = fields.find(name)) field->fail(what);
        fields.value().fail(fmt::format("'{}' {}", name, what));
    };
    const Vec3 view = camera.target - camera.eye;
    if (view == Vec3{0.0}) fail("target", "is the same point as 'eye'");
    if (camera.up == Vec3{0.0}) fail("up", "is zero");
    if (length(cross(view, camera.up)) <= 1e-9 * length(view) * length(camera.up))
        fail("up", "is parallel to the direction from 'eye' to 'target'");
    if (camera.far_plane <= camera.near_plane)
        fail("far", fmt::format("{} is not greater than 'near', which is {}", camera.far_plane,
                                camera.near_plane));
}

Camera read_camera(const JsonValue& value) {
    const JsonObject fields(value, {"eye", "target", "up", "vertical_fov_degrees", "near", "far"});
    const Range distance{.low = 0.0, .high = 1e9, .low_excluded = true};
    const Range angle{.low = 0.0, .high = 180.0, .low_excluded = true, .high_excluded = true};
    const Camera absent;
    const Camera camera{.eye = fields.vec3("eye", coordinates, absent.eye),
                        .target = fields.vec3("target", coordinates, absent.target),
                        .up = fields.vec3("up", coordinates, absent.up),
                        .vertical_fov_degrees = fields.number("vertical_fov_degrees", angle,
                                                              absent.vertical_fov_degrees),
                        .near_plane = fields.number("near", distance, absent.near_plane),
                        .far_plane = fields.number("far", distance, absent.far_plane)};
    check_camera(camera, fields);
    return camera;
}

FactoredObject read_object(const JsonValue& value) {
    const JsonObject fields(value,
                            {"mesh", "material", "translation", "scale", "rotate_y_degrees"});
    const Range size{.low = 0.0, .high = 1e6, .low_excluded = true};
    return {
        .mesh = fields.at("mesh").text(),
        .material = fields.at("material").text(),
        .translation = fields.vec3("translation", coordinates, Vec3{0.0}),
        .scale = fields.number("scale", size, 1.0),
        .rotate_y_degrees = fields.number("rotate_y_degrees", {.low = -360.0, .high = 360.0}, 0.0)};
}

template <class Read>
auto read_list(const JsonObject& fields, std::string_view name, Read read) {
    std::vector<decltype(read(fields.value()))> list;
    if (const auto field = fields.find(name))
        for (const JsonValue& element : field->elements(0, max_named))
            list.push_back(read(element));
    return list;
}

template <class Read>
auto read_map(const JsonObject& fields, std::string_view name, Read read) {
    std::map<std::string, decltype(read(fields.value()))> map;
    if (const auto field = fields.find(name))
        for (const auto& [key, member] : field->named_members(max_named))
            map.emplace(key, read(member));
    return map;
}

template <class Read>
auto read_or_default(const JsonObject& fields, std::string_view name, Read read) {
    using T = decltype(read(fields.value()));
    const auto field = fields.find(name);
    return field ? read(*field) : T{};
}

std::string read_directory(const JsonObject& fields, const std::filesystem::path& own) {
    const auto directory = fields.find("directory");
    return (directory ? own / directory->text() : own).lexically_normal().string();
}

Scene read_document(const JsonObject& fields, const std::filesystem::path& directory) {
    const auto presets = fields.find("presets");
    const auto environment = fields.enabled("environment");
    static_cast<void>(fields.text("$schema", ""));
    if (const auto results = fields.find("results"); results && !results->is_object())
        results->fail("must be an object");
    return {
        .title = fields.text("title", ""),
        .directory = read_directory(fields, directory),
        .image = read_or_default(fields, "image", read_image),
        .camera = read_or_default(fields, "camera", read_camera),
        .environment = environment ? std::optional(read_environment(*environment)) : std::nullopt,
        .white = read_or_default(fields, "white", read_white),
        .factorization = read_or_default(fields, "factorization", read_factorization),
        .materials = read_map(fields, "materials", read_material),
        .meshes = read_map(fields, "meshes", read_mesh),
        .textures = read_map(fields, "textures", read_texture),
        .objects = read_list(fields, "objects", read_object),
        .historical = read_list(fields, "historical", read_historical),
        .passes = read_list(fields, "passes", read_pass),
        .presets = presets ? read_presets(*presets)
                           : std::vector<Preset>(usual_presets.begin(), usual_presets.end()),
        .custom = read_or_default(fields, "custom", read_custom)};
}

/// The bytes of the file, at most one more than parse_json accepts: a device without end is no
/// trap.
std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(max_json_bytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    // A folder opens and then cannot be read.
    if (!file.is_open() || file.bad() || (file.fail() && !file.eof()))
        throw Error(ExitCode::bad_file, path.string() + ": cannot be read");
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

}  // namespace
}  // namespace scene_io

Scene parse_scene(std::string_view text, const std::string& name,
                  const std::filesystem::path& directory,
                  const std::vector<std::string>& overrides) {
    nlohmann::json document = scene_io::parse_json(text, name);
    for (const std::string& change : overrides)
        document = scene_io::with_override(std::move(document), change, name);
    const scene_io::JsonObject fields(
        scene_io::JsonValue(document, name, ""),
        {"$schema", "title", "directory", "image", "camera", "environment", "white",
         "factorization", "materials", "meshes", "textures", "objects", "historical", "passes",
         "presets", "custom", "results"});
    Scene scene = scene_io::read_document(fields, directory);
    scene.file = name;
    scene_io::check_scene(scene, name, fields.find("directory").has_value());
    return scene;
}

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return parse_scene(scene_io::read_text(path), path.string(),
                       std::filesystem::absolute(path).parent_path(), overrides);
}

}  // namespace twofold
