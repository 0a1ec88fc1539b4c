#include <fmt/format.h>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Geometry, textures and explicit passes.
namespace twofold::scene_io {
namespace {

/// A list of vectors, one for each vertex.
std::vector<Vec3> read_vectors(const JsonValue& value, std::size_t least, std::size_t most) {
    std::vector<Vec3> vectors;
    for (const JsonValue& element : value.elements(least, most))
        vectors.push_back(element.vec3(any_number));
    return vectors;
}

/// Like OpenGL's TexCoord2 and Color3: what a shorter vector leaves out is taken from (0, 0, 0, 1).
std::vector<Vec4> read_padded(const JsonValue& value, std::size_t vertices, std::size_t shortest,
                              Range range) {
    std::vector<Vec4> vectors;
    for (const JsonValue& element : value.elements(vertices, vertices)) {
        const std::vector<double> v = element.numbers(shortest, 4, range);
        vectors.push_back({v[0], v[1], v.size() > 2 ? v[2] : 0.0, v.size() > 3 ? v[3] : 1.0});
    }
    return vectors;
}

std::vector<std::uint32_t> read_indices(const JsonValue& value, std::size_t vertices) {
    const auto elements = value.elements(0, max_indices);
    if (elements.size() % 3 != 0)
        value.fail(fmt::format("has {} elements, not a multiple of 3", elements.size()));
    std::vector<std::uint32_t> indices;
    for (const JsonValue& element : elements)
        indices.push_back(
            static_cast<std::uint32_t>(element.integer(0, static_cast<int>(vertices) - 1)));
    return indices;
}

Mesh read_vertices(const JsonValue& value) {
    const JsonObject fields(value, {"positions", "normals", "texcoords", "colors", "indices"});
    Mesh mesh;
    mesh.positions = read_vectors(fields.at("positions"), 1, max_indices);
    const std::size_t count = mesh.positions.size();
    // An empty list means the same as none, so that a mesh is written with all its fields.
    const auto present = [&](std::string_view name) {
        auto field = fields.find(name);
        return field && field->is_list() && field->elements(0, max_indices).empty() ? std::nullopt
                                                                                    : field;
    };
    if (const auto normals = present("normals"))
        mesh.normals = read_vectors(*normals, count, count);
    if (const auto texcoords = present("texcoords"))
        mesh.texcoords = read_padded(*texcoords, count, 2, any_number);
    if (const auto colors = present("colors"))
        mesh.colors = read_padded(*colors, count, 3, unit_interval);
    mesh.indices = read_indices(fields.at("indices"), count);
    return mesh;
}

Checkerboard read_checkerboard(const JsonValue& value) {
    const JsonObject fields(value, {"width", "height", "cell", "first", "second"});
    const Checkerboard absent;
    return {.width = fields.integer("width", 1, 4096, absent.width),
            .height = fields.integer("height", 1, 4096, absent.height),
            .cell = fields.integer("cell", 1, 4096, absent.cell),
            .first = fields.vec4("first", unit_interval, absent.first),
            .second = fields.vec4("second", unit_interval, absent.second)};
}

int read_rgb_scale(const JsonValue& value) {
    const int scale = value.integer(1, 4);
    if (scale == 3) value.fail("3 is not one of 1, 2, 4");
    return scale;
}

TextureUnitState read_unit(const JsonObject& fields) {
    TextureUnitState unit;
    unit.texgen = fields.enumerator("texgen", texgen_names, unit.texgen);
    unit.wrap_s = fields.enumerator("wrap_s", wrap_names, unit.wrap_s);
    unit.wrap_t = fields.enumerator("wrap_t", wrap_names, unit.wrap_t);
    unit.filter = fields.enumerator("filter", filter_names, unit.filter);
    unit.border_color = fields.vec4("border_color", unit_interval, unit.border_color);
    if (const auto matrix = fields.find("matrix")) unit.matrix = matrix->mat4();
    if (const auto scale = fields.find("rgb_scale")) unit.rgb_scale = read_rgb_scale(*scale);
    return unit;
}

void read_units(const JsonValue& value, ScenePass& pass) {
    const auto elements = value.elements(0, pass.state.units.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i].is_null()) continue;
        const JsonObject fields(elements[i], {"texture", "texgen", "matrix", "wrap_s", "wrap_t",
                                              "filter", "border_color", "rgb_scale"});
        pass.state.units[i] = read_unit(fields);
        if (const auto texture = fields.enabled("texture")) pass.textures[i] = texture->text();
    }
}

AlphaTest read_alpha_test(const JsonValue& value) {
    const JsonObject fields(value, {"func", "reference"});
    const AlphaTest absent;
    return {.func = fields.enumerator("func", compare_names, absent.func),
            .reference = fields.number("reference", unit_interval, absent.reference)};
}

DepthTest read_depth_test(const JsonValue& value) {
    const JsonObject fields(value, {"func", "write"});
    const DepthTest absent;
    return {.func = fields.enumerator("func", compare_names, absent.func),
            .write = fields.boolean("write", absent.write)};
}

Blend read_blend(const JsonValue& value) {
    const JsonObject fields(value, {"source", "destination"});
    const Blend absent;
    return {.source = fields.enumerator("source", blend_names, absent.source),
            .destination = fields.enumerator("destination", blend_names, absent.destination)};
}

std::array<bool, 4> read_color_mask(const JsonValue& value) {
    const auto channels = value.elements(4, 4);
    return {channels[0].boolean(), channels[1].boolean(), channels[2].boolean(),
            channels[3].boolean()};
}

PassState read_state(const JsonObject& fields) {
    PassState state;
    state.color = fields.vec4("color", unit_interval, state.color);
    state.normalize = fields.boolean("normalize", state.normalize);
    state.cull = fields.enumerator("cull", cull_names, state.cull);
    if (const auto matrix = fields.enabled("modelview")) state.modelview = matrix->mat4();
    if (const auto matrix = fields.enabled("projection")) state.projection = matrix->mat4();
    if (const auto test = fields.enabled("alpha_test")) state.alpha_test = read_alpha_test(*test);
    if (const auto test = fields.enabled("depth_test")) state.depth_test = read_depth_test(*test);
    if (const auto blend = fields.enabled("blend")) state.blend = read_blend(*blend);
    if (const auto mask = fields.find("color_mask")) state.color_mask = read_color_mask(*mask);
    return state;
}

}  // namespace

MeshSpec read_mesh(const JsonValue& value) {
    const JsonObject fields(value, {"file", "sphere", "quad", "vertices"});
    const std::string_view kind = fields.one_of({"file", "sphere", "quad", "vertices"});
    const JsonValue field = fields.at(kind);
    if (kind == "file") return MeshFile{.path = field.text()};
    if (kind == "vertices") return InlineMesh{.mesh = read_vertices(field)};
    if (kind == "quad") {
        const JsonObject empty(field, {});
        return QuadMesh{};
    }
    const JsonObject sphere(field, {"subdivisions"});
    const SphereMesh absent;
    return SphereMesh{.subdivisions = sphere.integer("subdivisions", 1, 256, absent.subdivisions)};
}

TextureSpec read_texture(const JsonValue& value) {
    const JsonObject fields(value, {"file", "checkerboard"});
    const std::string_view kind = fields.one_of({"file", "checkerboard"});
    if (kind == "file") return TextureFile{.path = fields.at(kind).text()};
    return read_checkerboard(fields.at(kind));
}

ScenePass read_pass(const JsonValue& value) {
    const JsonObject fields(value, {"mesh", "modelview", "projection", "color", "normalize", "cull",
                                    "units", "alpha_test", "depth_test", "blend", "color_mask"});
    ScenePass pass;
    pass.mesh = fields.at("mesh").text();
    pass.own_matrices = fields.enabled("modelview") || fields.enabled("projection");
    pass.state = read_state(fields);
    if (const auto units = fields.find("units")) read_units(*units, pass);
    return pass;
}

}  // namespace twofold::scene_io
