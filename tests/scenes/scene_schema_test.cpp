#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/scenes/scene_text.hpp"

/// The schema and the reader say the same: fields, defaults, enumerators and ranges.
/// The documents below write every field of every kind, none at its default.

using namespace twofold;
using namespace twofold::scene_text;
using nlohmann::json;

namespace {

const std::vector<std::string> every_field{R"({
  "title": "t", "directory": "/d",
  "image": {"width": 11, "height": 12, "background": [0.1, 0.2, 0.3], "color_format": "rgb565",
            "depth_bits": 16, "clear_depth": 0.375},
  "camera": {"eye": [1.5, 2.5, 3.5], "target": [0.25, 0.5, 0.75], "up": [0.1, 0.9, 0.2],
             "vertical_fov_degrees": 33.5, "near": 0.3, "far": 44.5},
  "environment": {"latlong": "e.hdr", "repair": true, "cells": 77, "scale": 1.75, "orientation":
                  {"forward": [1.5, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "white": 2.5,
  "factorization": {"method": "letter", "model": "svd", "map_form": "cube", "map_size": 21, "guard": 0.75, "samples": 1234, "held_out": 567,
                    "lighting_sum": "clustered", "lighting_tolerance": 0.0625,
                    "solver": "lsmr", "tolerance": 0.125, "iteration_limit": 31,
                    "stagnation_window": 41, "keep_best": true, "remove_null_vectors": true, "floor": 0.01, "cap": 3.5,
                    "row_weight": 0.5, "smoothness": 0.625, "seam": 0.375, "column_scaling": true,
                    "fill_power": 3.25, "view_knots": 17, "view_smoothness": 0.875,
                    "terms": 3, "rounds": 9, "row_norm": "max", "surface_rows": "texels", "refinement": 5, "refinement_weight": 0.625, "scale": "percentile",
                    "scale_percentile": 98.5, "shortcuts": true},
  "materials": {
    "a": {"cook_torrance": {"diffuse": [0.1, 0.2, 0.3], "specular": [0.4, 0.5, 0.6], "f0": [0.7, 0.8, 0.9],
                            "lobes": [{"m": 0.3, "weight": 0.25}, {"m": 0.15, "weight": 0.75}],
                            "constant": "modern4"}},
    "b": {"modified_phong": {"diffuse": [0.15, 0.25, 0.35], "specular": [0.45, 0.55, 0.65],
                             "exponent": 12.5}},
    "c": {"merl": {"file": "m.binary", "fill": "interpolate"}},
    "d": {"cornell": {"file": "c.brdf", "fill": "interpolate"}},
    "e": {"rgl": {"file": "r.bsdf", "fill": "interpolate"}}},
  "meshes": {
    "f": {"file": "m.ply"}, "q": {"quad": {}}, "s": {"sphere": {"subdivisions": 7}},
    "v": {"vertices": {"primitive": "polygon", "positions": [[0.5, 1.5, 2.5], [3.5, 4.5, 5.5], [6.5, 7.5, 8.5]],
                       "position_w": [1.25, 2.25, 3.25],
                       "normals": [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
                       "texcoords": {
                         "0": [[0.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8], [0.9, 1.1, 1.2, 1.3]],
                         "1": [[1.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8], [0.9, 1.1, 1.2, 1.3]],
                         "2": [],
                         "3": [[3.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8], [0.9, 1.1, 1.2, 1.3]]},
                       "colors": [[0.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8], [0.9, 0.11, 0.12, 0.13]],
                       "secondary_colors": [[0.15, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8],
                                            [0.9, 0.11, 0.12, 0.13]],
                       "indices": [2, 0, 1]}}},
  "textures": {
    "f": {"file": "t.png", "base_format": "rgb", "mipmaps": "box", "border": 1},
    "c": {"checkerboard": {"width": 3, "height": 5, "cell": 2, "first": [0.1, 0.2, 0.3, 0.4],
                           "second": [0.5, 0.6, 0.7, 0.8]}, "base_format": "alpha", "mipmaps": "none", "border": 0},
    "p": {"texels": {"width": 2, "height": 3, "format": "rgb565",
                     "bytes": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 255]},
          "base_format": "luminance", "mipmaps": "none", "border": 1},
    "d": {"cube": {"faces": [{"file": "px.png"},
                             {"checkerboard": {"width": 4, "height": 4, "cell": 3,
                              "first": [0.15, 0.2, 0.3, 0.4], "second": [0.55, 0.6, 0.7, 0.8]}},
                             {"texels": {"width": 1, "height": 1, "format": "l8", "bytes": [77]}},
                             {"file": "ny.png"}, {"file": "pz.png"}, {"file": "nz.png"}]},
          "base_format": "intensity", "mipmaps": "box", "border": 1}},
  "objects": [{"mesh": "f", "material": "b", "translation": [1.25, 2.25, 3.25], "scale": 4.25,
               "rotate_y_degrees": 5.25}],
  "historical": [{"mesh": "s", "factors": "f.txt", "light": [0.5, 1.5, 2.5], "irradiance": [3.5, 4.5, 5.5],
                  "diffuse": 6.5, "specular": 7.5, "translation": [8.5, 9.5, 10.5], "scale": 11.5,
                  "rotate_y_degrees": 12.5}],
  "passes": [
    {"mesh": "v",
     "modelview": [1.0, 2.0, 3.0, 4.0, 5.0, 60.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0],
     "projection": [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5, 11.5, 12.5, 13.5, 14.5, 15.5, 16.5],
     "viewport": {"scale": [11.5, -12.5, 0.25], "offset": [13.5, 14.5, 0.75]}, "window_space": true,
     "color": [0.1, 0.2, 0.3, 0.4], "normalize": true, "cull": "front",
     "shade_model": "flat", "provoking_vertex": "first", "perspective_correction": false,
     "units": [{"texture": "c", "target": "rectangle",
                "texgen": {"s": "object_linear", "t": "eye_linear", "r": "sphere_map", "q": "object_linear",
                  "object_planes": [[0.1, 0.2, 0.3, 0.4], [1.1, 0.2, 0.3, 0.4], [2.1, 0.2, 0.3, 0.4],
                                    [3.1, 0.2, 0.3, 0.4]],
                  "eye_planes": [[4.1, 0.2, 0.3, 0.4], [5.1, 0.2, 0.3, 0.4], [6.1, 0.2, 0.3, 0.4],
                                 [7.1, 0.2, 0.3, 0.4]]},
                "matrix": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7],
                "divide_by_q": false, "wrap_s": "clamp", "wrap_t": "clamp_to_border",
                "min_filter": "nearest", "mag_filter": "linear", "mip_filter": "off", "lod_bias": 1.25,
                "border_color": [0.9, 0.8, 0.7, 0.6],
                "env": {"mode": "combine", "color": [0.19, 0.18, 0.17, 0.16], "combine_rgb": "dot3_rgba",
                  "combine_alpha": "add_signed",
                  "rgb": [{"source": "constant", "operand": "one_minus_src_color"},
                          {"source": "primary_color", "operand": "src_alpha"},
                          {"source": "texture", "operand": "one_minus_src_alpha"}],
                  "alpha": [{"source": "previous", "operand": "one_minus_src_alpha"},
                            {"source": "constant", "operand": "src_alpha"},
                            {"source": "primary_color", "operand": "one_minus_src_alpha"}],
                  "rgb_scale": 4, "alpha_scale": 2}},
               null, null, null],
     "combiners": {
       "stages": [{"constant_color0": [0.21, 0.22, 0.23, 0.24], "constant_color1": [0.31, 0.32, 0.33, 0.34],
         "rgb": {"inputs": [
             {"source": "texture0", "component": "alpha", "mapping": "expand_normal"},
             {"source": "texture1", "component": "rgb", "mapping": "expand_negate"},
             {"source": "constant_color0", "component": "alpha", "mapping": "half_bias_normal"},
             {"source": "spare1", "component": "rgb", "mapping": "signed_negate"}],
           "ab_output": "spare0", "cd_output": "spare1", "sum_output": null,
           "ab_dot_product": true, "cd_dot_product": false, "mux": true,
           "mux_by_lowest_bit": false, "scale": "two",
           "bias_by_negative_one_half": true, "ab_blue_to_alpha": false, "cd_blue_to_alpha": true},
         "alpha": {"inputs": [
             {"source": "fog", "component": "blue", "mapping": "unsigned_invert"},
             {"source": "texture2", "component": "alpha", "mapping": "signed_identity"},
             {"source": "constant_color1", "component": "blue", "mapping": "half_bias_negate"},
             {"source": "texture3", "component": "alpha", "mapping": "expand_normal"}],
           "ab_output": "texture0", "cd_output": null, "sum_output": "primary_color", "mux": true,
           "mux_by_lowest_bit": true,
           "scale": "four", "bias_by_negative_one_half": false}}],
       "final": {
         "a": {"source": "fog", "component": "alpha", "invert": true},
         "b": {"source": "spare0_plus_secondary_color", "component": "rgb", "invert": false},
         "c": {"source": "e_times_f", "component": "rgb", "invert": true},
         "d": {"source": "secondary_color", "component": "alpha", "invert": false},
         "e": {"source": "spare0", "component": "alpha", "invert": true},
         "f": {"source": "spare1", "component": "rgb", "invert": true},
         "g": {"source": "texture1", "component": "blue", "invert": true},
         "constant_color0": [0.41, 0.42, 0.43, 0.44], "constant_color1": [0.51, 0.52, 0.53, 0.54],
         "clamp_sum": true, "invert_spare0": true, "invert_secondary": true}},
     "color_sum": true,
     "fog": {"mode": "linear", "density": 0.625, "start": 2.5, "end": 20.5, "color": [0.61, 0.62, 0.63]},
     "scissor": {"x": -3, "y": 4, "width": 5, "height": 6},
     "alpha_test": {"func": "notequal", "reference": 0.25}, "depth_test": {"func": "lequal", "write": false},
     "blend": {"source": "dst_color", "destination": "one_minus_constant_alpha",
               "equation": "reverse_subtract", "color": [0.71, 0.72, 0.73, 0.74]},
     "color_mask": [false, true, false, true], "dither": true},
    {"mesh": "q", "modelview": null, "projection": null, "viewport": null, "window_space": true,
     "color": [0.4, 0.3, 0.2, 0.1], "normalize": true, "cull": "back",
     "shade_model": "flat", "provoking_vertex": "first", "perspective_correction": false,
     "units": [null, {"texture": null, "target": "texture_2d", "texgen": "reflection_map",
                "matrix": [1.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7],
                "divide_by_q": false, "wrap_s": "mirrored_repeat", "wrap_t": "clamp",
                "min_filter": "linear", "mag_filter": "nearest", "mip_filter": "nearest", "lod_bias": -2.5,
                "border_color": [0.5, 0.8, 0.7, 0.6],
                "env": {"mode": "decal", "color": [0.29, 0.18, 0.17, 0.16], "combine_rgb": "replace",
                  "combine_alpha": "subtract",
                  "rgb": [{"source": "previous", "operand": "one_minus_src_color"},
                          {"source": "texture", "operand": "src_alpha"},
                          {"source": "texture", "operand": "one_minus_src_alpha"}],
                  "alpha": [{"source": "texture", "operand": "one_minus_src_alpha"},
                            {"source": "constant", "operand": "src_alpha"},
                            {"source": "previous", "operand": "one_minus_src_alpha"}],
                  "rgb_scale": 2, "alpha_scale": 4}}, null, null],
     "combiners": null, "color_sum": true, "fog": null, "scissor": null,
     "alpha_test": null, "depth_test": null, "blend": null, "color_mask": [true, true, true, false], "dither": true}],
  "presets": ["nv17", "custom", "coarse8", "nv2x", "gl13"],
  "custom": {"texel_bits": 7, "filter_weight_bits": 5, "filter_rounding": "once", "product_rounding": "shift",
             "register_bits": 11, "vertex_color": "floor", "snap_bits": 7, "snap_bias": 0.25,
             "framebuffer_bits": 6}
})",
                                           R"({
  "environment": {"painted": {"background": [0.1, 0.2, 0.3],
    "lights": [{"direction": [1.5, 2.5, 3.5], "half_angle_degrees": 4.5, "radiance": [5.5, 6.5, 7.5]}],
    "width": 41, "height": 42}, "cells": 78},
  "white": {"percentile": 98.5},
  "materials": {"a": {"modified_phong": {}}}, "meshes": {"q": {"quad": {}}},
  "objects": [{"mesh": "q", "material": "a"}]})",
                                           R"({
  "environment": {"probe": "e.exr", "repair": true, "cells": 79, "scale": 2.75, "orientation":
                  {"forward": [1.25, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})",
                                           R"({
  "environment": {"cube_cross": "e.exr", "repair": true, "cells": 79, "scale": 2.75, "orientation":
                  {"forward": [1.25, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})",
                                           R"({
  "environment": {"cube_strip": "e.exr", "repair": true, "cells": 79, "scale": 2.75, "orientation":
                  {"forward": [1.25, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})",
                                           R"({
  "environment": {"cube_openexr": "e.exr", "repair": true, "cells": 79, "scale": 2.75, "orientation":
                  {"forward": [1.25, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})",
                                           R"({
  "environment": {"dual_paraboloid": "e.exr", "repair": true, "cells": 79, "scale": 2.75, "guard": 0.625, "orientation":
                  {"forward": [1.25, 2.5, 3.5], "up": [0.25, 0.5, -0.75], "mirror": true}},
  "meshes": {"q": {"quad": {}}}, "passes": [{"mesh": "q"}]})",
                                           R"({
  "environment": {"directional": [{"direction": [1.25, 2.5, 3.5], "irradiance": [5.25, 6.25, 7.25]}],
                  "cells": 79},
  "materials": {"a": {"cook_torrance": {}}}, "meshes": {"q": {"quad": {}}},
  "objects": [{"mesh": "q", "material": "a"}]})"};

/// Fields that say in short what the program writes in full.
const std::string short_forms = R"({
  "meshes": {"v": {"vertices": {"positions": [[0, 0, 0]], "texcoords": [[0.5, 0.25]], "indices": []}}},
  "passes": [{"mesh": "v", "units": [{"filter": "nearest", "rgb_scale": 4, "texgen": "eye_linear"}]}]})";

json written(const std::string& text) { return json::parse(scene_to_json(parse(text))); }

const json& schema() {
    static const json document = json::parse(contents(folder / "scene.schema.json"));
    return document;
}

/// The alternatives that a schema node stands for, references followed.
std::vector<json> alternatives(const json& node) {
    if (node.contains("$ref"))
        return alternatives(
            schema().at(json::json_pointer(node["$ref"].get<std::string>().substr(1))));
    std::vector<json> result;
    for (const std::string key : {"anyOf", "allOf"})
        if (node.contains(key) && !node.contains("properties"))
            for (const json& part : node[key])
                for (json& alternative : alternatives(part))
                    result.push_back(std::move(alternative));
    if (result.empty()) result.push_back(node);
    return result;
}

/// One step into a document and into its schema.
struct Step {
    std::string name;     ///< key or index
    std::string general;  ///< key, * for a name that the author chose, # for an index
    json schema;
};

std::vector<Step> steps_into(const json& value, const json& node) {
    std::vector<Step> steps;
    for (const json& kind : alternatives(node)) {
        if (value.is_array() && kind.contains("items"))
            for (std::size_t i = 0; i < value.size(); ++i)
                steps.push_back({std::to_string(i), "#", kind["items"]});
        if (!value.is_object() || !kind.contains("properties")) {
            if (value.is_object() && kind.contains("additionalProperties"))
                for (const auto& [key, member] : value.items())
                    steps.push_back({key, "*", kind["additionalProperties"]});
            continue;
        }
        for (const auto& [key, member] : value.items()) {
            INFO(key);
            REQUIRE(kind["properties"].contains(key));
            steps.push_back({key, key, kind["properties"][key]});
        }
    }
    return steps;
}

/// Calls visit(value, schema node, pointer, general path) for all that `value` holds.
template <class Visit>
void walk(const json& value, const json& node, const json::json_pointer& pointer,
          const std::string& general, const Visit& visit) {
    visit(value, node, pointer, general);
    for (const Step& step : steps_into(value, node)) {
        const json& child = value.is_array() ? value[std::stoul(step.name)] : value[step.name];
        const auto next = value.is_array() ? pointer / std::stoul(step.name) : pointer / step.name;
        walk(child, step.schema, next, general + "/" + step.general, visit);
    }
}

/// General paths of all properties of the schema.
std::set<std::string> schema_fields(const json& node, const std::string& path) {
    std::set<std::string> fields;
    const auto add = [&](const json& child, const std::string& name) {
        fields.merge(schema_fields(child, path + "/" + name));
    };
    for (const json& kind : alternatives(node)) {
        if (kind.contains("items")) add(kind["items"], "#");
        if (kind.contains("additionalProperties") && kind["additionalProperties"].is_object())
            add(kind["additionalProperties"], "*");
        if (!kind.contains("properties")) continue;
        for (const auto& [key, child] : kind["properties"].items()) {
            fields.insert(path + "/" + key);
            add(child, key);
        }
    }
    return fields;
}

/// The documents with all that the program writes into them, and the short forms as they are.
std::vector<json> full_documents() {
    std::vector<json> documents;
    for (const std::string& text : every_field) documents.push_back(written(text));
    documents.push_back(json::parse(short_forms));
    return documents;
}

/// A field's path as error texts write it.
std::string dotted(const json::json_pointer& pointer) {
    std::string text = pointer.to_string().substr(1);
    for (char& c : text)
        if (c == '/') c = '.';
    return text;
}

/// The error after one value of `document` is replaced.
std::string error_with(json document, const json::json_pointer& pointer, const json& value) {
    document[pointer] = value;
    return error_of(document.dump());
}

void check_limits(const json& document, const json& kind, const json::json_pointer& pointer) {
    const auto refuses = [&](const json& value) {
        const std::string error = error_with(document, pointer, value);
        INFO(error << " for " << value);
        CHECK(error.rfind("x.json: " + dotted(pointer) + ": " + value.dump() + " is not in", 0) ==
              0);
    };
    const auto takes = [&](const json& value) {
        const std::string error = error_with(document, pointer, value);
        INFO(error << " for " << value);
        CHECK(error.find(" is not in") == std::string::npos);
    };
    const bool whole = kind["type"] == "integer";
    const auto beyond = [&](const json& limit, double direction) -> json {
        if (whole) return limit.get<int>() + static_cast<int>(direction);
        return std::nextafter(limit.get<double>(), direction * 1e300);
    };
    if (kind.contains("minimum")) takes(kind["minimum"]), refuses(beyond(kind["minimum"], -1));
    if (kind.contains("exclusiveMinimum")) refuses(kind["exclusiveMinimum"]);
    if (kind.contains("maximum")) takes(kind["maximum"]), refuses(beyond(kind["maximum"], 1));
    if (kind.contains("exclusiveMaximum")) refuses(kind["exclusiveMaximum"]);
}

void check_enumerators(const json& document, const json& kind, const json::json_pointer& pointer) {
    // A name that is known may still not go with the others of its document.
    for (const json& value : kind["enum"]) {
        const std::string error = error_with(document, pointer, value);
        INFO(error);
        CHECK(error.find("unknown value") == std::string::npos);
        CHECK(error.find("is not one of") == std::string::npos);
    }
    if (kind["enum"][0].is_string()) CHECK(error_with(document, pointer, "nothing") != "accepted");
}

}  // namespace

TEST_CASE("what is read is what is written, in every field") {
    // No field here has its default and no two fields of a kind are equal, so a field that is read
    // into another's place, or not at all, shows.
    CHECK(written(every_field[0]) == json::parse(every_field[0]));
    for (const std::string& text : every_field) {
        const json full = written(text);
        const json given = json::parse(text);
        CHECK(full["environment"] == given["environment"]);
        CHECK(written(full.dump()) == full);
    }
    CHECK(written(every_field[1])["white"] == json::parse(R"({"percentile": 98.5})"));
}

TEST_CASE("shipped scenes mean the same after being written") {
    for (const std::string& name : shipped) {
        const std::string text = scene_to_json(read_scene(folder / name));
        CHECK(scene_to_json(parse_scene(text, "y.json", "/somewhere/else")) == text);
    }
}

TEST_CASE("numbers come back to the bit") {
    for (const double x : {0.1, 1.0 / 3.0, 5e-324, 2.2250738585072014e-308, 123456789.12345679,
                           -0.0, 9007199254740993.0, 1.7976931348623157e308}) {
        Scene scene = parse(smallest);
        InlineMesh inline_mesh;
        inline_mesh.mesh.positions = {Vec3(x, -x, x)};
        scene.meshes["q"] = inline_mesh;
        const Scene again = parse(scene_to_json(scene));
        const Vec3 position = std::get<InlineMesh>(again.meshes.at("q")).mesh.positions[0];
        CHECK(position.x == x);
        CHECK(std::signbit(position.x) == std::signbit(x));
        CHECK(position.y == -x);
    }
}

TEST_CASE("the schema has exactly the fields that the reader takes and the writer writes") {
    std::set<std::string> fields;
    for (const json& document : full_documents())
        walk(document, schema(), json::json_pointer(), "",
             [&](const json&, const json&, const json::json_pointer&, const std::string& general) {
                 const std::string name = general.substr(general.rfind('/') + 1);
                 if (!general.empty() && name != "*" && name != "#") fields.insert(general);
             });
    fields.insert("/$schema");  // taken for the editors' sake and not kept
    fields.insert("/results");  // written by a run into its manifest, not kept either
    CHECK(fields == schema_fields(schema(), ""));
    CHECK(error_of(smallest, {"$schema=scene.schema.json"}) == "accepted");
}

TEST_CASE("the schema's defaults are the reader's") {
    int compared = 0;
    const auto compare = [&](const json& value, const json& node, const json::json_pointer& pointer,
                             const std::string&) {
        for (const json& kind : alternatives(node)) {
            const json& place = node.contains("default") ? node : kind;
            if (!place.contains("default")) continue;
            INFO(pointer.to_string());
            CHECK(value == place["default"]);
            ++compared;
            break;
        }
    };
    // What is on here is on with all its own fields at their defaults; what holds it is not
    // compared.
    const std::string all_on = R"({"image": {}, "camera": {}, "factorization": {}, "textures":
        {"c": {"checkerboard": {}}}, "meshes": {"s": {"sphere": {}}, "q": {"quad": {}},
                   "v": {"vertices": {"positions": [[0, 0, 0]], "indices": []}}},
        "materials": {"a": {"cook_torrance": {}}, "b": {"modified_phong": {}},
                      "c": {"merl": {"file": "m"}}},
        "environment": {"painted": {}}, "objects": [{"mesh": "q", "material": "a"}],
        "historical": [{"mesh": "q", "factors": "f"}],
        "custom": {}, "passes": [{"mesh": "v",
            "units": [{"env": {}}, {"texgen": {"s": "eye_linear"}}], "alpha_test": {},
            "depth_test": {}, "blend": {}, "fog": {}, "scissor": {"width": 1, "height": 1},
            "combiners": {"stages": [{"rgb": {"inputs": [{}]}, "alpha": {"inputs": [{}]}}],
                          "final": {"a": {}, "e": {}, "g": {}}}}]})";
    const std::set<std::string> given{"/environment",
                                      "/textures",
                                      "/meshes",
                                      "/materials",
                                      "/objects",
                                      "/historical",
                                      "/passes",
                                      "/passes/#/units",
                                      "/passes/#/alpha_test",
                                      "/passes/#/blend",
                                      "/passes/#/depth_test",
                                      "/passes/#/fog",
                                      "/passes/#/scissor",
                                      "/passes/#/combiners",
                                      "/passes/#/units/#/texgen",
                                      "/passes/#/units/#/texgen/s"};
    walk(written(all_on), schema(), json::json_pointer(), "",
         [&](const json& value, const json& node, const json::json_pointer& pointer,
             const std::string& general) {
             if (given.count(general) == 0) compare(value, node, pointer, general);
         });
    CHECK(compared > 150);
}

TEST_CASE("the schema's ranges and enumerators are the reader's") {
    int compared = 0;
    for (const json& document : full_documents())
        walk(document, schema(), json::json_pointer(), "",
             [&](const json& value, const json& node, const json::json_pointer& pointer,
                 const std::string& general) {
                 // Indices are limited by the number of vertices, and presets are a set.
                 if (general.find("/indices/") != std::string::npos) return;
                 for (const json& kind : alternatives(node)) {
                     if (value.is_number() && kind.contains("type")) {
                         if (kind["type"] != "number" && kind["type"] != "integer") continue;
                         check_limits(document, kind, pointer);
                         ++compared;
                     }
                     if (kind.contains("enum") && general != "/presets/#")
                         check_enumerators(document, kind, pointer);
                 }
             });
    CHECK(compared > 100);
}
