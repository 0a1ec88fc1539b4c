#include <fmt/format.h>

#include <bit>
#include <charconv>

#include "tests/evidence/reading.hpp"

/// Draws and their vertices, the compared region and the expected figures.
namespace twofold::evidence {
namespace {

using scene_io::any_number;

constexpr std::size_t most_vertices = 65536;
constexpr int farthest_pixel = 16384;

constexpr std::array primitive_names{Named{"triangles", Primitive::triangles},
                                     Named{"triangle_strip", Primitive::triangle_strip},
                                     Named{"triangle_fan", Primitive::triangle_fan},
                                     Named{"polygon", Primitive::polygon},
                                     Named{"quads", Primitive::quads},
                                     Named{"quad_strip", Primitive::quad_strip}};

constexpr std::array operation_names{Named{"fill_checker", true}};

JsonObject attributes_of(const JsonValue& value) {
    return {value,
            {"diffuse", "diffuse8", "diffuse_bits", "specular", "tex0", "tex1", "tex2", "tex3",
             "normal"}};
}

/// A vertex and what it shares with the others of its draw.
class Attributes {
  public:
    Attributes(const JsonObject& own, const std::optional<JsonObject>& common)
        : own_(own), common_(common) {}

    /// @throws Error if the vertex gives what the draw gives for all
    std::optional<JsonValue> find(std::string_view name) const {
        auto own = own_.find(name);
        auto shared = common_ ? common_->find(name) : std::nullopt;
        if (own && shared) own->fail("is given in 'common' too");
        return own ? own : shared;
    }

    const JsonObject& own() const { return own_; }

  private:
    const JsonObject& own_;
    const std::optional<JsonObject>& common_;
};

/// An IEEE binary32 word such as "0x7fc00000", not a number included: its sign survives the
/// widening.
double read_float_bits(const JsonValue& value) {
    const std::string text = value.text();
    std::uint32_t word = 0;
    const bool prefixed = text.size() == 10 && text.compare(0, 2, "0x") == 0;
    const char* last = text.data() + text.size();
    if (!prefixed || std::from_chars(text.data() + 2, last, word, 16).ptr != last)
        value.fail(value.shown() + " is not 0x and 8 hexadecimal digits");
    return static_cast<double>(std::bit_cast<float>(word));
}

Vec4 read_color_bits(const JsonValue& value) {
    const auto words = value.elements(4, 4);
    return {read_float_bits(words[0]), read_float_bits(words[1]), read_float_bits(words[2]),
            read_float_bits(words[3])};
}

/// The primary colour in whichever of three ways it is given; white without one.
Vec4 read_diffuse(const Attributes& vertex) {
    const auto floats = vertex.find("diffuse");
    const auto bytes = vertex.find("diffuse8");
    const auto bits = vertex.find("diffuse_bits");
    if ((floats ? 1 : 0) + (bytes ? 1 : 0) + (bits ? 1 : 0) > 1)
        vertex.own().value().fail("has more than one of diffuse, diffuse8 and diffuse_bits");
    if (floats) return floats->vec4(any_number);
    if (bytes) return read_color_as_reals(*bytes);
    return bits ? read_color_bits(*bits) : Vec4{1.0};
}

Vec4 read_vec4(const Attributes& vertex, std::string_view name, Vec4 absent) {
    const auto value = vertex.find(name);
    return value ? value->vec4(any_number) : absent;
}

void read_vertex(const JsonValue& value, const std::optional<JsonObject>& common, Mesh& mesh) {
    const JsonObject own(value, {"pos", "diffuse", "diffuse8", "diffuse_bits", "specular", "tex0",
                                 "tex1", "tex2", "tex3", "normal"});
    const Attributes vertex(own, common);
    const Vec4 position = own.at("pos").vec4(any_number);
    mesh.positions.push_back(Vec3{position});
    mesh.position_w.push_back(position.w);
    mesh.colors.push_back(read_diffuse(vertex));
    mesh.secondary_colors.push_back(read_vec4(vertex, "specular", Vec4{0.0}));
    const auto normal = vertex.find("normal");
    mesh.normals.push_back(normal ? normal->vec3(any_number) : Vec3{0.0});
    // The chip's initial coordinates; without them a unit would read those of unit 0.
    for (std::size_t u = 0; u < max_units; ++u)
        mesh.texcoords[u].push_back(read_vec4(vertex, fmt::format("tex{}", u), Vec4{0, 0, 0, 1}));
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
}

DrawCommand read_draw(const JsonValue& value) {
    const JsonObject fields(value, {"target", "state", "primitive", "common", "vertices"});
    DrawCommand draw;
    draw.state = fields.at("state").text();
    draw.mesh.primitive = fields.at("primitive").enumerator(primitive_names);
    std::optional<JsonObject> common;
    if (const auto shared = fields.find("common")) common = attributes_of(*shared);
    for (const JsonValue& vertex : fields.at("vertices").elements(3, most_vertices))
        read_vertex(vertex, common, draw.mesh);
    return draw;
}

FillCommand read_fill(const JsonValue& value) {
    const JsonObject fields(value, {"op", "target", "texels"});
    fields.at("op").enumerator(operation_names);
    return {read_texel_rule(fields.at("texels"))};
}

Rectangle read_rectangle(const JsonValue& value) {
    const auto numbers = value.elements(4, 4);
    return {numbers[0].integer(-farthest_pixel, farthest_pixel),
            numbers[1].integer(-farthest_pixel, farthest_pixel),
            numbers[2].integer(0, farthest_pixel), numbers[3].integer(0, farthest_pixel)};
}

std::vector<Rectangle> read_rectangles(const JsonValue& value) {
    std::vector<Rectangle> rectangles;
    for (const JsonValue& element : value.elements(0, most_vertices))
        rectangles.push_back(read_rectangle(element));
    return rectangles;
}

}  // namespace

Command read_command(const JsonValue& value) {
    if (!value.is_object()) value.fail(value.shown() + " is not an object");
    const auto target = value.member("target");
    Command command;
    command.target = target ? target->text() : framebuffer_name;
    if (value.member("op"))
        command.what = read_fill(value);
    else
        command.what = read_draw(value);
    return command;
}

CompareRegion read_region(const JsonValue& value) {
    const JsonObject fields(value, {"include", "exclude", "channels"});
    return {read_rectangles(fields.at("include")), read_rectangles(fields.at("exclude")),
            read_channels(fields.at("channels"))};
}

Expectation read_expectation(const JsonValue& value) {
    const JsonObject fields(value, {"reproduced", "pixels_compared", "pixels_drawn_by_model",
                                    "pixels_wrong", "max_difference", "deviating_pixels_xy"});
    constexpr int most = farthest_pixel * farthest_pixel;
    Expectation expected;
    expected.reproduced = fields.at("reproduced").boolean();
    expected.pixels_compared = fields.at("pixels_compared").integer(0, most);
    expected.pixels_drawn = fields.at("pixels_drawn_by_model").integer(0, most);
    expected.pixels_wrong = fields.at("pixels_wrong").integer(0, most);
    expected.max_difference = fields.at("max_difference").integer(0, 255);
    if (const auto pixels = fields.find("deviating_pixels_xy"))
        for (const JsonValue& pixel : pixels->elements(0, most_vertices)) {
            const auto xy = pixel.elements(2, 2);
            expected.deviating_pixels.emplace_back(xy[0].integer(0, farthest_pixel),
                                                   xy[1].integer(0, farthest_pixel));
        }
    return expected;
}

}  // namespace twofold::evidence
