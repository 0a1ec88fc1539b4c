#include "study/sweep/cell.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scenes/json_reader.hpp"
#include "scenes/json_text.hpp"
#include "scenes/scene_file.hpp"
#include "study/results_json.hpp"
#include "study/sweep/cell_names.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/fnv1a.hpp"

namespace twofold {
namespace {

using Json = nlohmann::json;

/// As the largest measured BRDF.
constexpr std::size_t max_input_bytes = std::size_t{1} << 30;

bool is_draw(const std::string& change) { return change.starts_with("draw."); }

DrawSettings read_draw(const Json& document, const std::string& name) {
    const scene_io::JsonObject fields(scene_io::JsonValue(document.at("draw"), name, "draw"),
                                      {"technique", "lights", "way", "filter"});
    const DrawSettings absent;
    return {.technique = fields.enumerator("technique", technique_names, absent.technique),
            .lights = fields.integer("lights", 1, 8, absent.lights),
            .way = fields.enumerator("way", draw_way_names, absent.way),
            .filter = fields.enumerator("filter", texel_filter_names, absent.filter)};
}

Json json_of(const DrawSettings& draw) {
    return {{"technique", scene_io::name_in(technique_names, draw.technique)},
            {"lights", draw.technique == Technique::vertex_lights ? draw.lights : 0},
            {"way", scene_io::name_in(draw_way_names, draw.way)},
            {"filter", scene_io::name_in(texel_filter_names, draw.filter)}};
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder(scene.directory);
    const auto add = [&](const std::string& path) { files.push_back(folder / path); };
    if (scene.environment)
        if (const auto* file = std::get_if<EnvironmentFile>(&scene.environment->source))
            add(file->path);
    for (const auto& [name, brdf] : scene.materials)
        if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf)) add(measured->source.path);
    for (const auto& [name, mesh] : scene.meshes)
        if (const auto* file = std::get_if<MeshFile>(&mesh)) add(file->path);
    for (const auto& [name, texture] : scene.textures)
        for (const TextureImageSpec& image : texture.images)
            if (const auto* file = std::get_if<TextureFile>(&image)) add(file->path);
    for (const HistoricalObject& object : scene.historical) add(object.factors);
    return files;
}

std::string hex_of(const Fnv1a& hash) { return fmt::format("{:016x}", hash.value()); }

/// The scene's fields of these names, with what else decides the same work.
std::string part_of(const Json& scene, std::initializer_list<const char*> fields,
                    const std::string& more) {
    Json part = Json::object();  // a null becomes one in two steps, and crashes without memory
    for (const char* field : fields) part[field] = scene.at(field);
    return part.dump() + more;
}

/// What decides the samples beside the materials and lights: how lights are summed; of sphere maps,
/// which are tied to the eye, and of surface light fields, sampled on the surfaces for their rows,
/// the camera and every setting.
std::string sampling_part(const FactorSettings& settings, const Json& scene) {
    if (settings.map_form == MapForm::sphere || settings.model == Model::slf)
        return part_of(scene, {"camera", "factorization"}, "");
    return part_of(scene.at("factorization"), {"lighting_sum", "lighting_tolerance"}, "");
}

/// What is drawn of a cell: its technique alone may not look at all of it.
Json drawn_json(const Cell& cell) {
    Json scene = Json::parse(scene_to_json(cell.scene));
    for (const char* field : {"title", "directory"}) scene.erase(field);
    if (cell.scene.presets.front() != Preset::custom) scene.erase("custom");
    if (cell.draw.technique != Technique::factored) scene.erase("factorization");
    if (cell.draw.technique == Technique::exact) scene.erase("presets");
    return scene;
}

}  // namespace

SceneSource read_source(const std::filesystem::path& path) {
    return {read_text_file(path, scene_io::max_json_bytes), path.string(),
            std::filesystem::absolute(path).parent_path()};
}

Cell make_cell(const SceneSource& source, const std::vector<std::string>& changes) {
    Json draw{{"draw", Json::object()}};
    std::vector<std::string> of_scene;
    for (const std::string& change : changes)
        if (is_draw(change))
            draw = scene_io::with_override(std::move(draw), change, source.name);
        else
            of_scene.push_back(change);
    Cell cell;
    cell.scene = parse_scene(source.text, source.name, source.directory, of_scene);
    cell.scene.presets.resize(1);
    cell.draw = read_draw(draw, source.name);
    cell.white_samples = cell.scene.factorization.samples;
    return cell;
}

std::string InputHashes::of(const Scene& scene) {
    Fnv1a all;
    for (const std::filesystem::path& path : input_files(scene)) {
        std::string& known = known_[path];
        if (known.empty()) {
            Fnv1a hash;
            for (const unsigned char byte : read_file(path, max_input_bytes)) hash.u8(byte);
            known = hex_of(hash);
        }
        all.text(known);
    }
    return hex_of(all);
}

CellKeys keys_of(const Cell& cell, InputHashes& inputs) {
    const Json scene = Json::parse(scene_to_json(cell.scene));
    const std::string files = inputs.of(cell.scene);
    const int held_out = cell.scene.factorization.held_out;
    CellKeys keys;
    keys.assets = part_of(scene, {"meshes", "textures", "historical", "directory"}, files);
    keys.lighting = part_of(scene, {"environment", "white", "materials", "objects", "directory"},
                            fmt::format("{} {} {} {}", files, held_out, cell.white_samples,
                                        sampling_part(cell.scene.factorization, scene)));
    const Json& image = scene.at("image");
    keys.truth = part_of(scene, {"camera"}, keys.assets + keys.lighting) +
                 part_of(image, {"width", "height", "background"}, "");
    keys.factors = part_of(scene, {"factorization"}, keys.lighting);
    DrawSettings draw = cell.draw;
    draw.way = DrawWay::fused;
    keys.ideal =
        part_of(scene, {"passes", "image"}, keys.truth + keys.factors + json_of(draw).dump());
    return keys;
}

/// Of a kept result: one of another format is measured again.
constexpr std::string_view result_format = "5";

std::string id_of(const Cell& cell, InputHashes& inputs) {
    const Preset preset = cell.scene.presets.front();
    const bool percentile = cell.scene.environment && !cell.scene.white.radiance;
    Fnv1a hash;
    hash.text(program_version())
        .text(result_format)
        .text(inputs.of(cell.scene))
        .text(drawn_json(cell).dump());
    hash.text(json_of(cell.draw).dump());
    hash.text(fmt::format("{} {}", version_of(preset), percentile ? cell.white_samples : 0));
    return hex_of(hash);
}

}  // namespace twofold
