#include <fmt/format.h>

#include "raster/framebuffer.hpp"
#include "scenes/json_text.hpp"
#include "tests/evidence/reading.hpp"
#include "tests/evidence/surface_memory.hpp"
#include "texunit/error.hpp"
#include "texunit/texture_format.hpp"

/// A whole description, and whether the names in it name something.
namespace twofold::evidence {
namespace {

constexpr std::size_t most_members = 4096;
constexpr std::size_t most_draws = 100000;

/// Only back buffers that a capture's PNG can show without loss are known.
constexpr std::array framebuffer_formats{Named{"A8R8G8B8", ColorFormat::rgba8888}};

template <class Value, class Read>
std::map<std::string, Value> read_members(const JsonValue& value, Read read) {
    std::map<std::string, Value> members;
    for (const auto& [name, member] : value.named_members(most_members))
        members.emplace(name, read(member));
    return members;
}

/// A whole number of depth steps in 0..1, a quarter of a step up so that it comes back as the same
/// number whether the preset cuts or rounds.
double depth_of(int steps, int bits) {
    const double depth = (steps + 0.25) / ((1 << bits) - 1);
    return depth < 1.0 ? depth : 1.0;
}

void read_framebuffer(const JsonValue& value, Description& description) {
    const JsonObject fields(value,
                            {"width", "height", "format", "clear", "depth_bits", "depth_clear"});
    const int bits = fields.integer("depth_bits", 16, 24, 24);
    if (bits != 16 && bits != 24) fields.at("depth_bits").fail("is neither 16 nor 24");
    const int most = (1 << bits) - 1;
    description.depth_bits = bits;
    description.depth_clear = depth_of(fields.integer("depth_clear", 0, most, most), bits);
    description.surfaces.emplace(
        framebuffer_name, SurfaceDescription{fields.at("width").integer(1, 4096),
                                             fields.at("height").integer(1, 4096),
                                             fields.at("format").enumerator(framebuffer_formats),
                                             ConstantColor{read_color(fields.at("clear"))}});
}

template <class Members>
void require_member(const Members& members, const std::string& name, const JsonValue& place) {
    if (members.find(name) == members.end())
        place.fail(fmt::format("'{}' is not there", printable(name)));
}

/// A texture that is a surface, not its bytes reread, has the surface's size and width of pixels.
void check_view(const Description& description, const TextureDescription& texture,
                const JsonValue& place) {
    const auto* view = std::get_if<SurfaceView>(&texture.source);
    if (!view) return;
    require_member(description.surfaces, view->surface, place);
    const SurfaceDescription& surface = description.surfaces.at(view->surface);
    if (is_block_compressed(texture.format)) place.fail("a surface is not block compressed");
    if (place.member("raw_of")) return;
    if (surface.width != texture.width || surface.height != texture.height ||
        bytes_per_pixel(surface.format) != layout_of(texture.format).bytes)
        place.fail("has another size or format than its surface");
}

void check_command(const Description& description, const Command& command, const JsonValue& place) {
    require_member(description.surfaces, command.target, place);
    if (const auto* draw = std::get_if<DrawCommand>(&command.what))
        require_member(description.states, draw->state, place);
}

void read_textures(const JsonValue& value, Description& description) {
    description.textures = read_members<TextureDescription>(value, read_texture);
    for (const auto& [name, texture] : description.textures)
        check_view(description, texture, *value.member(name));
}

void read_states(const JsonValue& value, Description& description) {
    description.states = read_members<StateDescription>(
        value, [&](const JsonValue& state) { return read_state(state, description.depth_bits); });
    for (const auto& [name, state] : description.states)
        for (const std::string& texture : state.textures)
            if (!texture.empty())
                require_member(description.textures, texture, *value.member(name));
}

void read_commands(const JsonValue& value, Description& description) {
    for (const JsonValue& element : value.elements(0, most_draws)) {
        description.commands.push_back(read_command(element));
        check_command(description, description.commands.back(), element);
    }
}

/// Captures lie below the pack's folder; a description does not name files elsewhere.
std::string read_capture(const JsonValue& value) {
    std::string path = value.text();
    if (path.empty() || path.front() == '/' || path.find("..") != std::string::npos)
        value.fail(value.shown() + " is not a path below the pack's folder");
    return path;
}

void read_drawing(const JsonObject& fields, Description& description) {
    description.surfaces = read_members<SurfaceDescription>(fields.at("surfaces"), read_surface);
    if (description.surfaces.count(framebuffer_name) > 0)
        fields.at("surfaces").fail("a surface may not be called 'framebuffer'");
    read_framebuffer(fields.at("framebuffer"), description);
    read_textures(fields.at("textures"), description);
    read_states(fields.at("states"), description);
    read_commands(fields.at("draws"), description);
}

}  // namespace

Description parse_description(std::string_view text, std::string_view file) {
    const nlohmann::json document = scene_io::parse_json(text, file);
    const JsonObject fields(JsonValue(document, file, ""),
                            {"id", "capture", "hardware", "framebuffer", "textures", "surfaces",
                             "states", "draws", "compare", "settles", "notes", "check"});
    for (const std::string_view remark : {"hardware", "settles", "notes"}) fields.text(remark, "");
    Description description;
    description.id = fields.at("id").text();
    description.capture = read_capture(fields.at("capture"));
    read_drawing(fields, description);
    description.region = read_region(fields.at("compare"));
    if (const auto check = fields.find("check")) description.expectation = read_expectation(*check);
    return description;
}

}  // namespace twofold::evidence
