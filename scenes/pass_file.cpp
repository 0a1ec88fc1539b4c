#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// Explicit passes.
namespace twofold::scene_io {
namespace {

constexpr int largest_picture = 16384;  ///< pixels along an edge

Viewport read_viewport(const JsonValue& value) {
    const JsonObject fields(value, {"scale", "offset"});
    return {.scale = fields.at("scale").vec3(coordinates),
            .offset = fields.at("offset").vec3(coordinates)};
}

Scissor read_scissor(const JsonValue& value) {
    const JsonObject fields(value, {"x", "y", "width", "height"});
    const auto place = [&](std::string_view name) {
        return fields.integer(name, -largest_picture, largest_picture, 0);
    };
    return {.x = place("x"),
            .y = place("y"),
            .width = fields.at("width").integer(0, largest_picture),
            .height = fields.at("height").integer(0, largest_picture)};
}

Fog read_fog(const JsonValue& value) {
    const JsonObject fields(value, {"mode", "density", "start", "end", "color"});
    const Fog absent;
    const Fog fog{.mode = fields.enumerator("mode", fog_mode_names, absent.mode),
                  .density = fields.number("density", {.low = 0.0, .high = 1e9}, absent.density),
                  .start = fields.number("start", coordinates, absent.start),
                  .end = fields.number("end", coordinates, absent.end),
                  .color = fields.rgb("color", unit_interval, absent.color)};
    if (fog.mode == FogMode::linear && fog.start == fog.end)
        value.fail("'start' and 'end' are equal, and linear fog divides by their difference");
    return fog;
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
    const JsonObject fields(value, {"source", "destination", "equation", "color"});
    const Blend absent;
    return {.source = fields.enumerator("source", blend_names, absent.source),
            .destination = fields.enumerator("destination", blend_names, absent.destination),
            .equation = fields.enumerator("equation", equation_names, absent.equation),
            .color = fields.vec4("color", unit_interval, absent.color)};
}

std::array<bool, 4> read_color_mask(const JsonValue& value) {
    const auto channels = value.elements(4, 4);
    return {channels[0].boolean(), channels[1].boolean(), channels[2].boolean(),
            channels[3].boolean()};
}

/// From the vertices to the window.
void read_geometry_state(const JsonObject& fields, PassState& state) {
    if (const auto matrix = fields.enabled("modelview")) state.modelview = matrix->mat4();
    if (const auto matrix = fields.enabled("projection")) state.projection = matrix->mat4();
    if (const auto viewport = fields.enabled("viewport")) state.viewport = read_viewport(*viewport);
    state.window_space = fields.boolean("window_space", state.window_space);
    state.color = fields.vec4("color", unit_interval, state.color);
    state.normalize = fields.boolean("normalize", state.normalize);
    state.cull = fields.enumerator("cull", cull_names, state.cull);
    state.shade_model = fields.enumerator("shade_model", shade_model_names, state.shade_model);
    state.provoking_vertex =
        fields.enumerator("provoking_vertex", provoking_names, state.provoking_vertex);
    state.perspective_correction =
        fields.boolean("perspective_correction", state.perspective_correction);
}

/// From the textures to the framebuffer.
void read_fragment_state(const JsonObject& fields, PassState& state) {
    if (const auto stages = fields.enabled("combiners")) state.combiners = read_combiners(*stages);
    state.color_sum = fields.boolean("color_sum", state.color_sum);
    if (const auto fog = fields.enabled("fog")) state.fog = read_fog(*fog);
    if (const auto scissor = fields.enabled("scissor")) state.scissor = read_scissor(*scissor);
    if (const auto test = fields.enabled("alpha_test")) state.alpha_test = read_alpha_test(*test);
    if (const auto test = fields.enabled("depth_test")) state.depth_test = read_depth_test(*test);
    if (const auto blend = fields.enabled("blend")) state.blend = read_blend(*blend);
    if (const auto mask = fields.find("color_mask")) state.color_mask = read_color_mask(*mask);
    state.dither = fields.boolean("dither", state.dither);
}

}  // namespace

ScenePass read_pass(const JsonValue& value) {
    const JsonObject fields(value, {"mesh",
                                    "modelview",
                                    "projection",
                                    "viewport",
                                    "window_space",
                                    "color",
                                    "normalize",
                                    "cull",
                                    "shade_model",
                                    "provoking_vertex",
                                    "perspective_correction",
                                    "units",
                                    "combiners",
                                    "color_sum",
                                    "fog",
                                    "scissor",
                                    "alpha_test",
                                    "depth_test",
                                    "blend",
                                    "color_mask",
                                    "dither"});
    ScenePass pass;
    pass.mesh = fields.at("mesh").text();
    pass.own_matrices = fields.enabled("modelview") || fields.enabled("projection");
    read_geometry_state(fields, pass.state);
    if (const auto units = fields.find("units")) read_units(*units, pass);
    read_fragment_state(fields, pass.state);
    return pass;
}

}  // namespace twofold::scene_io
