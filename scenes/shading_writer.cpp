#include "scenes/scene_json.hpp"
#include "scenes/scene_names.hpp"

/// What decides the shading of objects, as JSON.
namespace twofold::scene_io {

Json json_of(const DiscLight& light) {
    return {{"direction", json_of(light.direction)},
            {"half_angle_degrees", light.half_angle},
            {"radiance", json_of(light.radiance)}};
}

Json json_of(const DirectionalLight& light) {
    return {{"direction", json_of(light.direction)}, {"irradiance", json_of(light.irradiance)}};
}

namespace {

Json source_of(const EnvironmentFile& file) {
    const EnvironmentPlacement& placement = file.placement;
    Json json{{std::string(name_in(environment_form_names, file.form)), file.path},
              {"repair", file.repair},
              {"orientation",
               {{"forward", json_of(placement.forward)},
                {"up", json_of(placement.up)},
                {"mirror", placement.mirror}}},
              {"scale", placement.scale}};
    if (file.form == EnvironmentForm::dual_paraboloid) json["guard"] = file.guard;
    return json;
}

Json source_of(const PaintedLatLong& painted) {
    return {{"painted",
             {{"background", json_of(painted.environment.background)},
              {"lights", list_of(painted.environment.discs)},
              {"width", painted.width},
              {"height", painted.height}}}};
}

Json source_of(const DirectionalLights& directional) {
    return {{"directional", list_of(directional.lights)}};
}

}  // namespace

Json json_of(const EnvironmentSpec& environment) {
    Json json =
        std::visit([](const auto& source) { return source_of(source); }, environment.source);
    json["cells"] = environment.cells;
    return json;
}

Json json_of(const WhitePoint& white) {
    if (white.radiance) return *white.radiance;
    return {{"percentile", white.percentile}};
}

Json json_of(const FactorSettings& settings) {
    return {{"method", name_in(method_names, settings.method)},
            {"model", name_in(model_names, settings.model)},
            {"map_form", name_in(map_form_names, settings.map_form)},
            {"map_size", settings.map_size},
            {"guard", settings.guard},
            {"samples", settings.samples},
            {"held_out", settings.held_out},
            {"lighting_sum", name_in(lighting_sum_names, settings.lighting_sum)},
            {"lighting_tolerance", settings.lighting_tolerance},
            {"solver", name_in(solver_names, settings.solver)},
            {"tolerance", settings.tolerance},
            {"iteration_limit", settings.iteration_limit},
            {"stagnation_window", settings.stagnation_window},
            {"keep_best", settings.keep_best},
            {"remove_null_vectors", settings.remove_null_vectors},
            {"floor", settings.floor},
            {"cap", settings.cap},
            {"row_weight", settings.row_weight},
            {"smoothness", settings.smoothness},
            {"seam", settings.seam},
            {"column_scaling", settings.column_scaling},
            {"fill_power", settings.fill_power},
            {"view_knots", settings.view_knots},
            {"view_smoothness", settings.view_smoothness},
            {"terms", settings.terms},
            {"rounds", settings.rounds},
            {"row_norm", name_in(row_norm_names, settings.row_norm)},
            {"surface_rows", name_in(surface_row_names, settings.surface_rows)},
            {"refinement", settings.refinement},
            {"refinement_weight", settings.refinement_weight},
            {"scale", name_in(scale_rule_names, settings.scale)},
            {"scale_percentile", settings.scale_percentile},
            {"combiner_scale", settings.combiner_scale},
            {"shortcuts", settings.shortcuts}};
}

Json json_of(const BeckmannLobe& lobe) { return {{"m", lobe.m}, {"weight", lobe.weight}}; }

namespace {

Json material_of(const CookTorrance& brdf) {
    return {{"cook_torrance",
             {{"diffuse", json_of(brdf.diffuse)},
              {"specular", json_of(brdf.specular)},
              {"f0", json_of(brdf.f0)},
              {"lobes", list_of(brdf.lobes)},
              {"constant", name_in(constant_names, brdf.constant)}}}};
}

Json material_of(const ModifiedPhong& brdf) {
    return {{"modified_phong",
             {{"diffuse", json_of(brdf.diffuse)},
              {"specular", json_of(brdf.specular)},
              {"exponent", brdf.exponent}}}};
}

Json material_of(const MeasuredBrdf& brdf) {
    return {{std::string(name_in(measured_names, brdf.source.format)),
             {{"file", brdf.source.path}, {"fill", name_in(fill_names, brdf.source.fill)}}}};
}

}  // namespace

Json json_of(const Brdf& brdf) {
    return std::visit([](const auto& model) { return material_of(model); }, brdf);
}

}  // namespace twofold::scene_io
