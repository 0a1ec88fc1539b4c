#include "tests/evidence/reading.hpp"

/// Texel rules, textures and surfaces.
namespace twofold::evidence {
namespace {

constexpr int largest_texture = 4096;

constexpr std::array texture_formats{
    Named{"8888", TextureFormat::argb8888}, Named{"x888", TextureFormat::xrgb8888},
    Named{"565", TextureFormat::rgb565},    Named{"1555", TextureFormat::argb1555},
    Named{"x555", TextureFormat::xrgb1555}, Named{"4444", TextureFormat::argb4444},
    Named{"L8", TextureFormat::l8},         Named{"AL8", TextureFormat::i8},
    Named{"A8L8", TextureFormat::la88},     Named{"DXT1_one_colour_blocks", TextureFormat::dxt1}};

constexpr std::array surface_formats{
    Named{"8888", ColorFormat::rgba8888},     Named{"565", ColorFormat::rgb565},
    Named{"x555_z", ColorFormat::xrgb1555_z}, Named{"x555_o", ColorFormat::xrgb1555_o},
    Named{"x888_z", ColorFormat::xrgb8888_z}, Named{"x888_o", ColorFormat::xrgb8888_o}};

constexpr std::array ramp_names{Named{"x", Ramp::x}, Named{"y", Ramp::y},
                                Named{"255-y", Ramp::inverted_y}, Named{"x+y", Ramp::x_plus_y}};

enum class Rule {
    checkerboard,
    checkerboard_window,
    constant,
    gradient,
    radial_alpha_pattern,
    coloured_checkerboard
};

constexpr std::array rule_names{Named{"checkerboard", Rule::checkerboard},
                                Named{"checkerboard_window", Rule::checkerboard_window},
                                Named{"constant", Rule::constant},
                                Named{"gradient", Rule::gradient},
                                Named{"radial_alpha_pattern", Rule::radial_alpha_pattern},
                                Named{"coloured_checkerboard", Rule::coloured_checkerboard}};

int read_size(const JsonObject& fields, std::string_view name) {
    return fields.at(name).integer(1, largest_texture);
}

Checkerboard checkerboard_of(const JsonObject& fields) {
    return {read_color(fields.at("first")), read_color(fields.at("second")),
            read_size(fields, "size")};
}

CheckerboardWindow read_window(const JsonValue& value) {
    const JsonObject fields(value,
                            {"rule", "first", "second", "size", "outside", "x", "y", "w", "h"});
    return {checkerboard_of(fields),
            read_color(fields.at("outside")),
            fields.at("x").integer(0, largest_texture),
            fields.at("y").integer(0, largest_texture),
            read_size(fields, "w"),
            read_size(fields, "h")};
}

/// A ramp by name, or one of the two constants, as a number or as a text.
std::variant<Ramp, std::uint8_t> read_ramp(const JsonValue& value) {
    const std::string shown = value.shown();
    if (shown == "0" || shown == "'0'") return std::uint8_t{0};
    if (shown == "255" || shown == "'255'") return std::uint8_t{255};
    return value.enumerator(ramp_names);
}

Gradient read_gradient(const JsonValue& value) {
    const JsonObject fields(value, {"rule", "r", "g", "b", "a"});
    return {{read_ramp(fields.at("r")), read_ramp(fields.at("g")), read_ramp(fields.at("b")),
             read_ramp(fields.at("a"))}};
}

std::vector<TexelRule> read_levels(const JsonValue& value) {
    std::vector<TexelRule> levels;
    for (const JsonValue& level : value.elements(1, 13)) levels.push_back(read_texel_rule(level));
    return levels;
}

TextureSource read_source(const JsonObject& fields) {
    const std::string_view name = fields.one_of({"texels", "levels", "surface", "raw_of"});
    const JsonValue source = fields.at(name);
    if (name == "texels") return std::vector{read_texel_rule(source)};
    if (name == "levels") return read_levels(source);
    return SurfaceView{source.text()};
}

}  // namespace

Rgba8 read_color(const JsonValue& value) {
    std::array<std::uint8_t, 4> c{};
    const auto elements = value.elements(4, 4);
    for (std::size_t k = 0; k < 4; ++k)
        c[k] = static_cast<std::uint8_t>(elements[k].integer(0, 255));
    return {c[0], c[1], c[2], c[3]};
}

Vec4 read_color_as_reals(const JsonValue& value) {
    const Rgba8 c = read_color(value);
    return Vec4{c.r, c.g, c.b, c.a} / 255.0;
}

TexelRule read_texel_rule(const JsonValue& value) {
    if (!value.is_object()) value.fail(value.shown() + " is not an object");
    const auto name = value.member("rule");
    if (!name) value.fail("the field 'rule' is missing");
    switch (name->enumerator(rule_names)) {
        case Rule::checkerboard:
            return checkerboard_of(JsonObject(value, {"rule", "first", "second", "size"}));
        case Rule::checkerboard_window:
            return read_window(value);
        case Rule::constant:
            return ConstantColor{read_color(JsonObject(value, {"rule", "value"}).at("value"))};
        case Rule::gradient:
            return read_gradient(value);
        case Rule::coloured_checkerboard:
            return ColouredCheckerboard{read_size(JsonObject(value, {"rule", "size"}), "size")};
        case Rule::radial_alpha_pattern:
            break;
    }
    const JsonObject without_parameters(value, {"rule"});
    return RadialAlphaPattern{};
}

TextureDescription read_texture(const JsonValue& value) {
    const JsonObject fields(
        value, {"width", "height", "format", "texels", "levels", "surface", "raw_of", "swap_rb"});
    TextureDescription texture;
    texture.width = read_size(fields, "width");
    texture.height = read_size(fields, "height");
    texture.format = fields.at("format").enumerator(texture_formats);
    texture.swap_red_and_blue = fields.boolean("swap_rb", false);
    texture.source = read_source(fields);
    return texture;
}

SurfaceDescription read_surface(const JsonValue& value) {
    const JsonObject fields(value, {"width", "height", "format", "init"});
    SurfaceDescription surface;
    surface.width = read_size(fields, "width");
    surface.height = read_size(fields, "height");
    surface.format = fields.at("format").enumerator(surface_formats);
    surface.initial = read_texel_rule(fields.at("init"));
    return surface;
}

}  // namespace twofold::evidence
