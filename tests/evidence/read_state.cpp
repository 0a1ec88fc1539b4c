#include "tests/evidence/reading.hpp"

/// The pipeline's state but for the combiners.
namespace twofold::evidence {
namespace {

using scene_io::any_number;

enum class TransformMode { screen, fixed_function };

constexpr std::array transform_names{Named{"screen", TransformMode::screen},
                                     Named{"fixed_function", TransformMode::fixed_function}};

constexpr std::array shade_names{Named{"smooth", ShadeModel::smooth},
                                 Named{"flat", ShadeModel::flat}};

constexpr std::array provoking_names{Named{"last", ProvokingVertex::last},
                                     Named{"first", ProvokingVertex::first}};

constexpr std::array equation_names{
    Named{"add", BlendEquation::add}, Named{"subtract", BlendEquation::subtract},
    Named{"reverse_subtract", BlendEquation::reverse_subtract}, Named{"min", BlendEquation::min},
    Named{"max", BlendEquation::max}};

constexpr std::array factor_names{
    Named{"zero", BlendFactor::zero},
    Named{"one", BlendFactor::one},
    Named{"src_color", BlendFactor::src_color},
    Named{"one_minus_src_color", BlendFactor::one_minus_src_color},
    Named{"dst_color", BlendFactor::dst_color},
    Named{"one_minus_dst_color", BlendFactor::one_minus_dst_color},
    Named{"src_alpha", BlendFactor::src_alpha},
    Named{"one_minus_src_alpha", BlendFactor::one_minus_src_alpha},
    Named{"dst_alpha", BlendFactor::dst_alpha},
    Named{"one_minus_dst_alpha", BlendFactor::one_minus_dst_alpha},
    Named{"src_alpha_saturate", BlendFactor::src_alpha_saturate},
    Named{"const_color", BlendFactor::constant_color},
    Named{"one_minus_const_color", BlendFactor::one_minus_constant_color},
    Named{"const_alpha", BlendFactor::constant_alpha},
    Named{"one_minus_const_alpha", BlendFactor::one_minus_constant_alpha}};

constexpr std::array target_names{Named{"normalised", TextureTarget::texture_2d},
                                  Named{"texels", TextureTarget::rectangle}};

constexpr std::array wrap_names{
    Named{"repeat", Wrap::repeat}, Named{"mirror", Wrap::mirrored_repeat},
    Named{"clamp_to_edge", Wrap::clamp_to_edge}, Named{"clamp_to_border", Wrap::clamp_to_border},
    Named{"gl_clamp", Wrap::clamp}};

constexpr std::array texgen_names{
    Named{"object_linear", TexGen::object_linear}, Named{"eye_linear", TexGen::eye_linear},
    Named{"sphere_map", TexGen::sphere_map}, Named{"normal_map", TexGen::normal_map},
    Named{"reflection_map", TexGen::reflection_map}};

constexpr std::array compare_names{
    Named{"never", CompareFunc::never},     Named{"less", CompareFunc::less},
    Named{"equal", CompareFunc::equal},     Named{"lequal", CompareFunc::lequal},
    Named{"greater", CompareFunc::greater}, Named{"notequal", CompareFunc::notequal},
    Named{"gequal", CompareFunc::gequal},   Named{"always", CompareFunc::always}};

constexpr std::array magnification_names{Named{"nearest", Filter::nearest},
                                         Named{"linear", Filter::linear}};

struct Minification {
    Filter within;
    MipFilter between;
};

constexpr std::array minification_names{
    Named{"nearest", Minification{Filter::nearest, MipFilter::off}},
    Named{"linear", Minification{Filter::linear, MipFilter::off}},
    Named{"linear_mipmap_linear", Minification{Filter::linear, MipFilter::linear}}};

/// The projection already holds pixels, y down, and steps of the depth buffer: what is left of the
/// viewport is the division of depth into 0..1 and the offset, which holds the snap bias.
void read_fixed_function(const JsonValue& value, int depth_bits, PassState& pass) {
    const JsonObject fields(value, {"mode", "modelview", "projection", "viewport_offset", "note"});
    pass.modelview = fields.at("modelview").mat4();
    pass.projection = fields.at("projection").mat4();
    const auto offset = fields.at("viewport_offset").numbers(2, 2, any_number);
    pass.viewport =
        Viewport{Vec3{1.0, 1.0, 1.0 / ((1 << depth_bits) - 1)}, Vec3{offset[0], offset[1], 0.0}};
    fields.text("note", "");
}

void read_transform(const JsonValue& value, int depth_bits, PassState& pass) {
    const auto mode = value.is_object() ? value.member("mode") : std::nullopt;
    if (!mode) value.fail("the field 'mode' is missing");
    if (mode->enumerator(transform_names) == TransformMode::fixed_function)
        return read_fixed_function(value, depth_bits, pass);
    JsonObject(value, {"mode", "note"}).text("note", "");
    pass.window_space = true;
}

TexGenState read_texgen(const JsonValue& value) {
    const JsonObject fields(value, {"s", "t", "r", "q"});
    TexGenState texgen;
    // The test programs' planes are the unit vectors of all four coordinates; OpenGL's r and q
    // begin as 0.
    texgen.object_plane[2] = texgen.eye_plane[2] = Vec4{0, 0, 1, 0};
    texgen.object_plane[3] = texgen.eye_plane[3] = Vec4{0, 0, 0, 1};
    constexpr std::array<std::string_view, 4> coordinates{"s", "t", "r", "q"};
    for (std::size_t k = 0; k < 4; ++k)
        texgen.mode[k] = fields.enumerator(coordinates[k], texgen_names, TexGen::none);
    return texgen;
}

void read_filters(const JsonObject& fields, TextureUnitState& unit) {
    const Minification minification = fields.at("min").enumerator(minification_names);
    unit.min_filter = minification.within;
    unit.mip_filter = minification.between;
    unit.mag_filter = fields.at("mag").enumerator(magnification_names);
    // Signed, in 256ths of a level.
    unit.lod_bias = fields.integer("lod_bias_5_8", -8192, 8191, 0) / 256.0;
}

void read_unit(const JsonValue& value, StateDescription& state) {
    const JsonObject fields(value, {"unit", "texture", "coords", "projective", "wrap", "min", "mag",
                                    "matrix", "texgen", "border", "lod_bias_5_8"});
    const auto index =
        static_cast<std::size_t>(fields.at("unit").integer(0, static_cast<int>(max_units) - 1));
    if (state.pass.units[index]) fields.at("unit").fail("the unit is given twice");
    TextureUnitState unit;
    unit.target = fields.at("coords").enumerator(target_names);
    unit.divide_by_q = fields.at("projective").boolean();
    const auto wrap = fields.at("wrap").elements(2, 2);
    unit.wrap_s = wrap[0].enumerator(wrap_names);
    unit.wrap_t = wrap[1].enumerator(wrap_names);
    read_filters(fields, unit);
    if (const auto matrix = fields.enabled("matrix")) unit.matrix = matrix->mat4();
    unit.texgen = read_texgen(fields.at("texgen"));
    if (const auto border = fields.find("border")) unit.border_color = read_color_as_reals(*border);
    state.pass.units[index] = unit;
    state.textures[index] = fields.at("texture").text();
}

std::optional<Blend> read_blend(const JsonValue& value) {
    const JsonObject fields(value, {"enable", "equation", "src", "dst", "constant"});
    if (!fields.at("enable").boolean()) return std::nullopt;
    return Blend{fields.at("src").enumerator(factor_names),
                 fields.at("dst").enumerator(factor_names),
                 fields.at("equation").enumerator(equation_names),
                 read_color_as_reals(fields.at("constant"))};
}

std::optional<AlphaTest> read_alpha_test(const JsonValue& value) {
    const JsonObject fields(value, {"enable", "func", "ref"});
    if (!fields.at("enable").boolean()) return std::nullopt;
    return AlphaTest{fields.at("func").enumerator(compare_names),
                     fields.at("ref").integer(0, 255) / 255.0};
}

std::optional<DepthTest> read_depth_test(const std::optional<JsonValue>& value, int depth_bits) {
    if (!value) return std::nullopt;
    const JsonObject fields(*value, {"enable", "func", "write", "bits"});
    if (!fields.at("enable").boolean()) return std::nullopt;
    const JsonValue bits = fields.at("bits");
    if (bits.integer(16, 24) != depth_bits)
        bits.fail(bits.shown() + " differs from the framebuffer's depth_bits");
    return DepthTest{fields.at("func").enumerator(compare_names), fields.at("write").boolean()};
}

}  // namespace

std::array<bool, 4> read_channels(const JsonValue& value) {
    constexpr std::string_view letters = "rgba";
    std::array<bool, 4> channels{};
    std::string in_order;
    const std::string text = value.text();
    for (std::size_t k = 0; k < letters.size(); ++k) {
        channels[k] = text.find(letters[k]) != std::string::npos;
        if (channels[k]) in_order += letters[k];
    }
    if (text.empty() || text != in_order)
        value.fail(value.shown() + " is not made of r, g, b, a in this order");
    return channels;
}

StateDescription read_state(const JsonValue& value, int depth_bits) {
    const JsonObject fields(
        value, {"transform", "cull", "shade", "provoking", "perspective", "units", "combiner",
                "blend", "alpha_test", "color_mask", "depth"});
    StateDescription state;
    PassState& pass = state.pass;
    read_transform(fields.at("transform"), depth_bits, pass);
    // What is dropped runs counter-clockwise as seen on the screen. That is a front face here, as
    // in OpenGL.
    pass.cull = fields.at("cull").boolean() ? CullFace::front : CullFace::none;
    pass.shade_model = fields.at("shade").enumerator(shade_names);
    pass.provoking_vertex = fields.at("provoking").enumerator(provoking_names);
    pass.perspective_correction = fields.at("perspective").boolean();
    for (const JsonValue& unit : fields.at("units").elements(0, max_units)) read_unit(unit, state);
    pass.combiners = read_combiners(fields.at("combiner"));
    pass.blend = read_blend(fields.at("blend"));
    pass.alpha_test = read_alpha_test(fields.at("alpha_test"));
    pass.color_mask = read_channels(fields.at("color_mask"));
    pass.depth_test = read_depth_test(fields.find("depth"), depth_bits);
    return state;
}

}  // namespace twofold::evidence
