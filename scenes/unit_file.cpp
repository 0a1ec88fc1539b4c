#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Texture units of explicit passes.
namespace twofold::scene_io {
namespace {

constexpr Range levels{.low = -16.0, .high = 16.0};

void read_planes(const JsonValue& value, std::array<Vec4, 4>& planes) {
    const auto elements = value.elements(4, 4);
    for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = elements[i].vec4(coordinates);
}

/// A name alone is the mode of all coordinates that it makes sense for.
TexGenState read_texgen(const JsonValue& value) {
    if (!value.is_object()) return texgen_all(value.enumerator(texgen_names));
    const JsonObject fields(value, {"s", "t", "r", "q", "object_planes", "eye_planes"});
    TexGenState texgen;
    constexpr std::array<std::string_view, 4> names{"s", "t", "r", "q"};
    for (std::size_t i = 0; i < names.size(); ++i)
        texgen.mode[i] = fields.enumerator(names[i], texgen_names, texgen.mode[i]);
    if (const auto planes = fields.find("object_planes")) read_planes(*planes, texgen.object_plane);
    if (const auto planes = fields.find("eye_planes")) read_planes(*planes, texgen.eye_plane);
    return texgen;
}

/// `filter` alone is for both directions.
void read_filters(const JsonObject& fields, TextureUnitState& unit) {
    if (const auto filter = fields.find("filter")) {
        for (const std::string_view name : {"min_filter", "mag_filter"})
            if (fields.find(name)) filter->fail("says the same as '" + std::string(name) + "'");
        unit.min_filter = unit.mag_filter = filter->enumerator(filter_names);
    }
    unit.min_filter = fields.enumerator("min_filter", filter_names, unit.min_filter);
    unit.mag_filter = fields.enumerator("mag_filter", filter_names, unit.mag_filter);
    unit.mip_filter = fields.enumerator("mip_filter", mip_filter_names, unit.mip_filter);
    unit.lod_bias = fields.number("lod_bias", levels, unit.lod_bias);
}

template <std::size_t N>
void read_arguments(const JsonValue& value, const std::array<Named<CombineOperand>, N>& operands,
                    std::array<CombineArgument, 3>& arguments) {
    const auto elements = value.elements(0, arguments.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const JsonObject fields(elements[i], {"source", "operand"});
        CombineArgument& argument = arguments[i];
        argument.source = fields.enumerator("source", combine_source_names, argument.source);
        argument.operand = fields.enumerator("operand", operands, argument.operand);
    }
}

TexEnv read_env(const JsonValue& value) {
    const JsonObject fields(value, {"mode", "color", "combine_rgb", "combine_alpha", "rgb", "alpha",
                                    "rgb_scale", "alpha_scale"});
    TexEnv env;
    env.mode = fields.enumerator("mode", env_mode_names, env.mode);
    env.color = fields.vec4("color", unit_interval, env.color);
    env.combine_rgb = fields.enumerator("combine_rgb", combine_rgb_names, env.combine_rgb);
    env.combine_alpha = fields.enumerator("combine_alpha", combine_alpha_names, env.combine_alpha);
    if (const auto rgb = fields.find("rgb")) read_arguments(*rgb, operand_rgb_names, env.rgb);
    if (const auto alpha = fields.find("alpha"))
        read_arguments(*alpha, operand_alpha_names, env.alpha);
    if (const auto scale = fields.find("rgb_scale")) env.rgb_scale = read_scale(*scale);
    if (const auto scale = fields.find("alpha_scale")) env.alpha_scale = read_scale(*scale);
    return env;
}

/// `rgb_scale` of the unit is that of its environment, written shorter.
void read_environment_fields(const JsonObject& fields, TextureUnitState& unit) {
    const auto env = fields.find("env");
    if (env) unit.env = read_env(*env);
    const auto scale = fields.find("rgb_scale");
    if (!scale) return;
    if (env && env->member("rgb_scale")) scale->fail("says the same as 'env.rgb_scale'");
    unit.env.rgb_scale = read_scale(*scale);
}

TextureUnitState read_unit(const JsonObject& fields) {
    TextureUnitState unit;
    unit.target = fields.enumerator("target", target_names, unit.target);
    if (const auto texgen = fields.find("texgen")) unit.texgen = read_texgen(*texgen);
    if (const auto matrix = fields.find("matrix")) unit.matrix = matrix->mat4();
    unit.divide_by_q = fields.boolean("divide_by_q", unit.divide_by_q);
    unit.wrap_s = fields.enumerator("wrap_s", wrap_names, unit.wrap_s);
    unit.wrap_t = fields.enumerator("wrap_t", wrap_names, unit.wrap_t);
    read_filters(fields, unit);
    unit.border_color = fields.vec4("border_color", unit_interval, unit.border_color);
    read_environment_fields(fields, unit);
    return unit;
}

}  // namespace

int read_scale(const JsonValue& value) {
    const int scale = value.integer(1, 4);
    if (scale == 3) value.fail("3 is not one of 1, 2, 4");
    return scale;
}

void read_units(const JsonValue& value, ScenePass& pass) {
    const auto elements = value.elements(0, pass.state.units.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i].is_null()) continue;
        const JsonObject fields(
            elements[i], {"texture", "target", "texgen", "matrix", "divide_by_q", "wrap_s",
                          "wrap_t", "filter", "min_filter", "mag_filter", "mip_filter", "lod_bias",
                          "border_color", "env", "rgb_scale"});
        pass.state.units[i] = read_unit(fields);
        if (const auto texture = fields.enabled("texture")) pass.textures[i] = texture->text();
    }
}

}  // namespace twofold::scene_io
