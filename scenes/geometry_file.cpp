#include <fmt/format.h>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Meshes.
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

/// How many indices make a whole number of primitives; 1 where any number does, because a strip
/// that is too short draws nothing.
std::size_t indices_per_primitive(Primitive primitive) {
    switch (primitive) {
        case Primitive::triangles:
            return 3;
        case Primitive::quads:
            return 4;
        case Primitive::quad_strip:
            return 2;
        default:
            return 1;
    }
}

std::vector<std::uint32_t> read_indices(const JsonValue& value, std::size_t vertices,
                                        Primitive primitive) {
    const auto elements = value.elements(0, max_indices);
    const std::size_t step = indices_per_primitive(primitive);
    if (elements.size() % step != 0)
        value.fail(fmt::format("has {} elements, not a multiple of {}", elements.size(), step));
    std::vector<std::uint32_t> indices;
    for (const JsonValue& element : elements)
        indices.push_back(
            static_cast<std::uint32_t>(element.integer(0, static_cast<int>(vertices) - 1)));
    return indices;
}

/// A field that is there and holds something: an empty list means the same as none, so that a mesh
/// is written with all its fields.
std::optional<JsonValue> filled(const JsonObject& fields, std::string_view name) {
    auto field = fields.find(name);
    const bool empty = field && field->is_list() && field->elements(0, max_indices).empty();
    return empty ? std::nullopt : field;
}

/// One list is unit 0's; several are named by their units.
void read_texcoords(const JsonValue& value, std::size_t count, Mesh& mesh) {
    if (!value.is_object()) {
        mesh.texcoords[0] = read_padded(value, count, 2, any_number);
        return;
    }
    constexpr std::array<std::string_view, max_units> units{"0", "1", "2", "3"};
    const JsonObject fields(value, {units[0], units[1], units[2], units[3]});
    for (std::size_t i = 0; i < units.size(); ++i)
        if (const auto list = filled(fields, units[i]))
            mesh.texcoords[i] = read_padded(*list, count, 2, any_number);
}

void read_vertex_lists(const JsonObject& fields, std::size_t count, Mesh& mesh) {
    if (const auto normals = filled(fields, "normals"))
        mesh.normals = read_vectors(*normals, count, count);
    if (const auto texcoords = filled(fields, "texcoords")) read_texcoords(*texcoords, count, mesh);
    if (const auto colors = filled(fields, "colors"))
        mesh.colors = read_padded(*colors, count, 3, unit_interval);
    if (const auto colors = filled(fields, "secondary_colors"))
        mesh.secondary_colors = read_padded(*colors, count, 3, unit_interval);
    if (const auto w = filled(fields, "position_w"))
        mesh.position_w = w->numbers(count, count, any_number);
}

Mesh read_vertices(const JsonValue& value) {
    const JsonObject fields(value, {"primitive", "positions", "position_w", "normals", "texcoords",
                                    "colors", "secondary_colors", "indices"});
    Mesh mesh;
    mesh.primitive = fields.enumerator("primitive", primitive_names, mesh.primitive);
    mesh.positions = read_vectors(fields.at("positions"), 1, max_indices);
    read_vertex_lists(fields, mesh.positions.size(), mesh);
    mesh.indices = read_indices(fields.at("indices"), mesh.positions.size(), mesh.primitive);
    return mesh;
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

}  // namespace twofold::scene_io
