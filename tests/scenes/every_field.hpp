#pragma once
#include <string>
#include <vector>

namespace twofold::scene_text {

/// Documents that write every field of every kind, none at its default.
inline const std::vector<std::string> every_field{R"({
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
                    "scale_percentile": 98.5, "combiner_scale": 2, "shortcuts": true},
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
inline const std::string short_forms = R"({
  "meshes": {"v": {"vertices": {"positions": [[0, 0, 0]], "texcoords": [[0.5, 0.25]], "indices": []}}},
  "passes": [{"mesh": "v", "units": [{"filter": "nearest", "rgb_scale": 4, "texgen": "eye_linear"}]}]})";

}  // namespace twofold::scene_text
