#include <fmt/format.h>

#include <cmath>

#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"

/// What decides the shading of objects: environment, white point, materials, factorisation.
namespace twofold::scene_io {
namespace {

constexpr Range radiance{.low = 0.0, .high = 1e9};

/// A vector that has a direction. Components below 1e-9 could vanish when squared and summed.
Vec3 read_direction(const JsonValue& value) {
    const Vec3 direction = value.vec3(coordinates);
    if (max_component({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}) < 1e-9)
        value.fail(fmt::format("[{}, {}, {}] is zero and has no direction", direction.x,
                               direction.y, direction.z));
    return direction;
}

DiscLight read_disc_light(const JsonValue& value) {
    const JsonObject fields(value, {"direction", "half_angle_degrees", "radiance"});
    const Range angle{.low = 0.0, .high = 180.0, .low_excluded = true};
    return {.direction = read_direction(fields.at("direction")),
            .half_angle = fields.at("half_angle_degrees").number(angle),
            .radiance = fields.at("radiance").rgb(radiance)};
}

PaintedLatLong read_painted(const JsonValue& value) {
    const JsonObject fields(value, {"background", "lights", "width", "height"});
    PaintedLatLong painted;
    painted.width = fields.integer("width", 4, 4096, painted.width);
    painted.height = fields.integer("height", 2, 2048, painted.height);
    PaintedEnvironment& environment = painted.environment;
    environment.background = fields.rgb("background", radiance, environment.background);
    if (const auto lights = fields.find("lights"))
        for (const JsonValue& light : lights->elements(0, max_lights))
            environment.discs.push_back(read_disc_light(light));
    return painted;
}

DirectionalLights read_directional(const JsonValue& value) {
    DirectionalLights result;
    for (const JsonValue& light : value.elements(1, max_lights)) {
        const JsonObject fields(light, {"direction", "irradiance"});
        result.lights.push_back({.direction = read_direction(fields.at("direction")),
                                 .irradiance = fields.at("irradiance").rgb(radiance)});
    }
    return result;
}

CookTorrance read_cook_torrance(const JsonValue& value) {
    const JsonObject fields(value, {"diffuse", "specular", "f0", "lobes", "constant"});
    CookTorrance brdf;
    brdf.diffuse = fields.rgb("diffuse", unit_interval, brdf.diffuse);
    brdf.specular = fields.rgb("specular", {.low = 0.0, .high = 100.0}, brdf.specular);
    // eta = (1 + sqrt f0) / (1 - sqrt f0) has no value at 1.
    brdf.f0 = fields.rgb("f0", {.low = 0.0, .high = 1.0, .high_excluded = true}, brdf.f0);
    brdf.constant = fields.enumerator("constant", constant_names, brdf.constant);
    const auto lobes = fields.find("lobes");
    if (!lobes) return brdf;
    brdf.lobes.clear();
    double sum = 0.0;
    for (const JsonValue& element : lobes->elements(1, 16)) {
        const JsonObject lobe(element, {"m", "weight"});
        brdf.lobes.push_back({.m = lobe.at("m").number({.low = 1e-4, .high = 10.0}),
                              .weight = lobe.number("weight", unit_interval, 1.0)});
        sum += brdf.lobes.back().weight;
    }
    if (std::abs(sum - 1.0) > 1e-6) lobes->fail(fmt::format("the weights sum to {}, not 1", sum));
    return brdf;
}

ModifiedPhong read_modified_phong(const JsonValue& value) {
    const JsonObject fields(value, {"diffuse", "specular", "exponent"});
    const ModifiedPhong absent;
    return {.diffuse = fields.rgb("diffuse", unit_interval, absent.diffuse),
            .specular = fields.rgb("specular", unit_interval, absent.specular),
            .exponent = fields.number("exponent", {.low = 0.0, .high = 1e6}, absent.exponent)};
}

EnvironmentPlacement read_orientation(const JsonValue& value) {
    const JsonObject fields(value, {"forward", "up", "mirror"});
    EnvironmentPlacement placement;
    if (const auto forward = fields.find("forward")) placement.forward = read_direction(*forward);
    if (const auto up = fields.find("up")) placement.up = read_direction(*up);
    placement.mirror = fields.boolean("mirror", placement.mirror);
    const double across = length(cross(normalized(placement.forward), normalized(placement.up)));
    if (across < 1e-6) value.fail("'forward' and 'up' span no plane");
    return placement;
}

EnvironmentFile read_environment_file(const JsonObject& fields, std::string_view name,
                                      EnvironmentForm form) {
    EnvironmentFile file;
    file.path = fields.at(name).text();
    file.form = form;
    file.repair = fields.boolean("repair", file.repair);
    if (const auto guard = fields.find("guard")) {
        if (form != EnvironmentForm::dual_paraboloid) guard->fail("belongs to 'dual_paraboloid'");
        file.guard = guard->number({.low = 0.0, .high = 1.0, .low_excluded = true});
    }
    if (const auto orientation = fields.find("orientation"))
        file.placement = read_orientation(*orientation);
    file.placement.scale =
        fields.number("scale", {.low = 0.0, .high = 1e9, .low_excluded = true}, 1.0);
    return file;
}

MeasuredBrdf read_measured(const JsonValue& value, MeasuredFormat format) {
    const JsonObject fields(value, {"file", "fill"});
    return {{.format = format,
             .path = fields.at("file").text(),
             .fill = fields.enumerator("fill", fill_names, MeasuredFile{}.fill)},
            nullptr};
}

/// A table has at least two knots.
int read_view_knots(const JsonObject& fields, int absent) {
    const int knots = fields.integer("view_knots", 0, 256, absent);
    if (knots == 1) fields.at("view_knots").fail("1 is neither 0 nor in 2..256");
    return knots;
}

}  // namespace

EnvironmentSpec read_environment(const JsonValue& value) {
    const JsonObject fields(
        value, {"latlong", "probe", "cube_cross", "cube_strip", "cube_openexr", "dual_paraboloid",
                "painted", "directional", "repair", "guard", "orientation", "scale", "cells"});
    const std::string_view kind =
        fields.one_of({"latlong", "probe", "cube_cross", "cube_strip", "cube_openexr",
                       "dual_paraboloid", "painted", "directional"});
    EnvironmentSpec spec;
    spec.cells = fields.integer("cells", 1, 1 << 20, spec.cells);
    for (const auto& [name, form] : environment_form_names)
        if (name == kind) {
            spec.source = read_environment_file(fields, name, form);
            return spec;
        }
    for (const std::string_view of_pictures : {"repair", "guard", "orientation", "scale"})
        if (const auto field = fields.find(of_pictures))
            field->fail("belongs to a picture's file and there is none");
    if (kind == "painted")
        spec.source = read_painted(fields.at("painted"));
    else
        spec.source = read_directional(fields.at("directional"));
    return spec;
}

HistoricalObject read_historical(const JsonValue& value) {
    const JsonObject fields(value, {"mesh", "factors", "light", "irradiance", "diffuse", "specular",
                                    "translation", "scale", "rotate_y_degrees"});
    const Range size{.low = 0.0, .high = 1e6, .low_excluded = true};
    HistoricalObject object;
    object.mesh = fields.at("mesh").text();
    object.factors = fields.at("factors").text();
    if (const auto light = fields.find("light")) object.light = read_direction(*light);
    object.irradiance = fields.rgb("irradiance", radiance, object.irradiance);
    object.diffuse = fields.number("diffuse", {.low = 0.0, .high = 1e6}, object.diffuse);
    object.specular = fields.number("specular", {.low = 0.0, .high = 1e6}, object.specular);
    object.translation = fields.vec3("translation", coordinates, object.translation);
    object.scale = fields.number("scale", size, object.scale);
    object.rotate_y_degrees =
        fields.number("rotate_y_degrees", {.low = -360.0, .high = 360.0}, object.rotate_y_degrees);
    return object;
}

WhitePoint read_white(const JsonValue& value) {
    WhitePoint white;
    if (!value.is_object()) {
        white.radiance = value.number({.low = 0.0, .high = 1e12, .low_excluded = true});
        return white;
    }
    const JsonObject fields(value, {"percentile"});
    white.percentile =
        fields.at("percentile").number({.low = 0.0, .high = 100.0, .low_excluded = true});
    return white;
}

Brdf read_material(const JsonValue& value) {
    const std::initializer_list<std::string_view> kinds{"cook_torrance", "modified_phong", "merl",
                                                        "cornell", "rgl"};
    const JsonObject fields(value, kinds);
    const std::string_view kind = fields.one_of(kinds);
    if (kind == "cook_torrance") return read_cook_torrance(fields.at(kind));
    if (kind == "modified_phong") return read_modified_phong(fields.at(kind));
    for (const auto& [name, format] : measured_names)
        if (name == kind) return read_measured(fields.at(kind), format);
    fields.value().fail("has no model");
}

const std::initializer_list<std::string_view> factorization_fields{"method",
                                                                   "model",
                                                                   "map_form",
                                                                   "map_size",
                                                                   "guard",
                                                                   "samples",
                                                                   "held_out",
                                                                   "lighting_sum",
                                                                   "lighting_tolerance",
                                                                   "solver",
                                                                   "tolerance",
                                                                   "iteration_limit",
                                                                   "stagnation_window",
                                                                   "keep_best",
                                                                   "remove_null_vectors",
                                                                   "floor",
                                                                   "cap",
                                                                   "row_weight",
                                                                   "smoothness",
                                                                   "seam",
                                                                   "column_scaling",
                                                                   "fill_power",
                                                                   "view_knots",
                                                                   "view_smoothness",
                                                                   "terms",
                                                                   "rounds",
                                                                   "row_norm",
                                                                   "surface_rows",
                                                                   "refinement",
                                                                   "refinement_weight",
                                                                   "scale",
                                                                   "scale_percentile",
                                                                   "combiner_scale",
                                                                   "shortcuts"};

FactorSettings read_factorization(const JsonValue& value) {
    const JsonObject fields(value, factorization_fields);
    // The method first: it gives the values of all that the file does not say.
    const Method method = fields.enumerator("method", method_names, FactorSettings{}.method);
    const FactorSettings absent = method_preset(method);
    const Range positive{.low = 0.0, .high = 1.0, .low_excluded = true};
    const Range factor{.low = 0.0, .high = 1e6};
    const auto scale = fields.find("combiner_scale");
    return {
        .method = method,
        .model = fields.enumerator("model", model_names, absent.model),
        .map_form = fields.enumerator("map_form", map_form_names, absent.map_form),
        .map_size = fields.integer("map_size", 4, 512, absent.map_size),
        .guard = fields.number("guard", positive, absent.guard),
        .samples = fields.integer("samples", 1, 10'000'000, absent.samples),
        .held_out = fields.integer("held_out", 1, 10'000'000, absent.held_out),
        .lighting_sum = fields.enumerator("lighting_sum", lighting_sum_names, absent.lighting_sum),
        .lighting_tolerance = fields.number("lighting_tolerance", {.low = 1e-6, .high = 1.0},
                                            absent.lighting_tolerance),
        .solver = fields.enumerator("solver", solver_names, absent.solver),
        .tolerance = fields.number("tolerance", unit_interval, absent.tolerance),
        .iteration_limit = fields.integer("iteration_limit", 0, 100'000, absent.iteration_limit),
        .stagnation_window =
            fields.integer("stagnation_window", 0, 100'000, absent.stagnation_window),
        .keep_best = fields.boolean("keep_best", absent.keep_best),
        .remove_null_vectors = fields.boolean("remove_null_vectors", absent.remove_null_vectors),
        .floor = fields.number("floor", positive, absent.floor),
        .cap = fields.number("cap", factor, absent.cap),
        .row_weight = fields.number("row_weight", {.low = 0.0, .high = 2.0}, absent.row_weight),
        .smoothness = fields.number("smoothness", factor, absent.smoothness),
        .seam = fields.number("seam", factor, absent.seam),
        .column_scaling = fields.boolean("column_scaling", absent.column_scaling),
        .fill_power = fields.number("fill_power", {.low = 0.0, .high = 16.0}, absent.fill_power),
        .view_knots = read_view_knots(fields, absent.view_knots),
        .view_smoothness = fields.number("view_smoothness", factor, absent.view_smoothness),
        .terms = fields.integer("terms", 1, 4, absent.terms),
        .rounds = fields.integer("rounds", 1, 1000, absent.rounds),
        .row_norm = fields.enumerator("row_norm", row_norm_names, absent.row_norm),
        .surface_rows = fields.enumerator("surface_rows", surface_row_names, absent.surface_rows),
        .refinement = fields.integer("refinement", 0, 100, absent.refinement),
        .refinement_weight =
            fields.number("refinement_weight", {.low = 0.0, .high = 2.0}, absent.refinement_weight),
        .scale = fields.enumerator("scale", scale_rule_names, absent.scale),
        .scale_percentile =
            fields.number("scale_percentile", {.low = 0.0, .high = 100.0, .low_excluded = true},
                          absent.scale_percentile),
        .combiner_scale = scale ? read_scale(*scale) : absent.combiner_scale,
        .shortcuts = fields.boolean("shortcuts", absent.shortcuts)};
}

}  // namespace twofold::scene_io
