#pragma once
#include <utility>

#include "scenes/named.hpp"
#include "scenes/scene.hpp"

/// The names of enumerators in scene files: one table for the reader and the writer.
namespace twofold::scene_io {

inline constexpr std::array method_names{
    Named{"letter", Method::letter}, Named{"paper", Method::paper}, Named{"best", Method::best}};

inline constexpr std::array solver_names{Named{"qmr", Solver::qmr}, Named{"lsmr", Solver::lsmr},
                                         Named{"cgls", Solver::cgls},
                                         Named{"qmr_augmented", Solver::qmr_augmented}};

inline constexpr std::array model_names{
    Named{"product", Model::product}, Named{"svd", Model::svd},
    Named{"nd", Model::nd},           Named{"mccool", Model::mccool},
    Named{"slf", Model::slf},         Named{"prefilter", Model::prefilter}};

inline constexpr std::array row_norm_names{Named{"one", RowNorm::one}, Named{"two", RowNorm::two},
                                           Named{"max", RowNorm::max}};

inline constexpr std::array surface_row_names{Named{"vertices", SurfaceRow::vertices},
                                              Named{"texels", SurfaceRow::texels}};

inline constexpr std::array map_form_names{Named{"dual_paraboloid", MapForm::dual_paraboloid},
                                           Named{"cube", MapForm::cube},
                                           Named{"sphere", MapForm::sphere}};

inline constexpr std::array lighting_sum_names{Named{"full", LightingSum::full},
                                               Named{"clustered", LightingSum::clustered}};

inline constexpr std::array scale_rule_names{Named{"maximum", ScaleRule::maximum},
                                             Named{"percentile", ScaleRule::percentile},
                                             Named{"best_split", ScaleRule::best_split}};

inline constexpr std::array constant_names{Named{"pi1981", CookTorranceConstant::pi1981},
                                           Named{"modern4", CookTorranceConstant::modern4}};

inline constexpr std::array environment_form_names{
    Named{"latlong", EnvironmentForm::latlong},
    Named{"probe", EnvironmentForm::probe},
    Named{"cube_cross", EnvironmentForm::cube_cross},
    Named{"cube_strip", EnvironmentForm::cube_strip},
    Named{"cube_openexr", EnvironmentForm::cube_openexr},
    Named{"dual_paraboloid", EnvironmentForm::dual_paraboloid}};

inline constexpr std::array fill_names{Named{"homomorphic", Fill::homomorphic},
                                       Named{"interpolate", Fill::interpolate}};

/// The models of measured materials, by the files that hold them.
inline constexpr std::array measured_names{Named{"merl", MeasuredFormat::merl},
                                           Named{"cornell", MeasuredFormat::cornell},
                                           Named{"rgl", MeasuredFormat::rgl}};

inline constexpr std::array texgen_names{Named{"none", TexGen::none},
                                         Named{"object_linear", TexGen::object_linear},
                                         Named{"eye_linear", TexGen::eye_linear},
                                         Named{"sphere_map", TexGen::sphere_map},
                                         Named{"normal_map", TexGen::normal_map},
                                         Named{"reflection_map", TexGen::reflection_map}};

inline constexpr std::array target_names{Named{"texture_2d", TextureTarget::texture_2d},
                                         Named{"rectangle", TextureTarget::rectangle},
                                         Named{"cube_map", TextureTarget::cube_map}};

inline constexpr std::array wrap_names{Named{"repeat", Wrap::repeat}, Named{"clamp", Wrap::clamp},
                                       Named{"clamp_to_edge", Wrap::clamp_to_edge},
                                       Named{"clamp_to_border", Wrap::clamp_to_border},
                                       Named{"mirrored_repeat", Wrap::mirrored_repeat}};

inline constexpr std::array filter_names{Named{"nearest", Filter::nearest},
                                         Named{"linear", Filter::linear}};

inline constexpr std::array mip_filter_names{Named{"off", MipFilter::off},
                                             Named{"nearest", MipFilter::nearest},
                                             Named{"linear", MipFilter::linear}};

inline constexpr std::array env_mode_names{
    Named{"replace", TexEnvMode::replace}, Named{"modulate", TexEnvMode::modulate},
    Named{"decal", TexEnvMode::decal},     Named{"blend", TexEnvMode::blend},
    Named{"add", TexEnvMode::add},         Named{"combine", TexEnvMode::combine}};

inline constexpr std::array combine_rgb_names{Named{"replace", CombineFunction::replace},
                                              Named{"modulate", CombineFunction::modulate},
                                              Named{"add", CombineFunction::add},
                                              Named{"add_signed", CombineFunction::add_signed},
                                              Named{"interpolate", CombineFunction::interpolate},
                                              Named{"subtract", CombineFunction::subtract},
                                              Named{"dot3_rgb", CombineFunction::dot3_rgb},
                                              Named{"dot3_rgba", CombineFunction::dot3_rgba}};

/// Alpha has no dot products.
inline constexpr std::array combine_alpha_names{combine_rgb_names[0], combine_rgb_names[1],
                                                combine_rgb_names[2], combine_rgb_names[3],
                                                combine_rgb_names[4], combine_rgb_names[5]};

inline constexpr std::array combine_source_names{
    Named{"texture", CombineSource::texture}, Named{"constant", CombineSource::constant},
    Named{"primary_color", CombineSource::primary_color},
    Named{"previous", CombineSource::previous}};

inline constexpr std::array operand_rgb_names{
    Named{"src_color", CombineOperand::src_color},
    Named{"one_minus_src_color", CombineOperand::one_minus_src_color},
    Named{"src_alpha", CombineOperand::src_alpha},
    Named{"one_minus_src_alpha", CombineOperand::one_minus_src_alpha}};

/// Alpha reads alphas only.
inline constexpr std::array operand_alpha_names{operand_rgb_names[2], operand_rgb_names[3]};

/// What a final combiner's A to D read; general stages and E to G read all but the last two.
inline constexpr std::array final_register_names{
    Named{"zero", CombinerRegister::zero},
    Named{"constant_color0", CombinerRegister::constant_color0},
    Named{"constant_color1", CombinerRegister::constant_color1},
    Named{"fog", CombinerRegister::fog},
    Named{"primary_color", CombinerRegister::primary_color},
    Named{"secondary_color", CombinerRegister::secondary_color},
    Named{"texture0", CombinerRegister::texture0},
    Named{"texture1", CombinerRegister::texture1},
    Named{"texture2", CombinerRegister::texture2},
    Named{"texture3", CombinerRegister::texture3},
    Named{"spare0", CombinerRegister::spare0},
    Named{"spare1", CombinerRegister::spare1},
    Named{"spare0_plus_secondary_color", CombinerRegister::spare0_plus_secondary_color},
    Named{"e_times_f", CombinerRegister::e_times_f}};

template <class E, std::size_t N, std::size_t... I>
constexpr std::array<Named<E>, sizeof...(I)> part_of(const std::array<Named<E>, N>& names,
                                                     std::size_t first, std::index_sequence<I...>) {
    return {names[first + I]...};
}

inline constexpr auto register_names =
    part_of(final_register_names, 0, std::make_index_sequence<12>{});

/// What a general stage writes: neither zero nor constants nor fog.
inline constexpr auto output_names =
    part_of(final_register_names, 4, std::make_index_sequence<8>{});

inline constexpr std::array rgb_component_names{Named{"rgb", CombinerComponent::rgb},
                                                Named{"alpha", CombinerComponent::alpha}};

inline constexpr std::array alpha_component_names{Named{"alpha", CombinerComponent::alpha},
                                                  Named{"blue", CombinerComponent::blue}};

inline constexpr std::array mapping_names{
    Named{"unsigned_identity", CombinerMapping::unsigned_identity},
    Named{"unsigned_invert", CombinerMapping::unsigned_invert},
    Named{"expand_normal", CombinerMapping::expand_normal},
    Named{"expand_negate", CombinerMapping::expand_negate},
    Named{"half_bias_normal", CombinerMapping::half_bias_normal},
    Named{"half_bias_negate", CombinerMapping::half_bias_negate},
    Named{"signed_identity", CombinerMapping::signed_identity},
    Named{"signed_negate", CombinerMapping::signed_negate}};

inline constexpr std::array combiner_scale_names{
    Named{"one", CombinerScale::one}, Named{"two", CombinerScale::two},
    Named{"four", CombinerScale::four}, Named{"one_half", CombinerScale::one_half}};

inline constexpr std::array base_format_names{Named{"alpha", BaseFormat::alpha},
                                              Named{"luminance", BaseFormat::luminance},
                                              Named{"luminance_alpha", BaseFormat::luminance_alpha},
                                              Named{"intensity", BaseFormat::intensity},
                                              Named{"rgb", BaseFormat::rgb},
                                              Named{"rgba", BaseFormat::rgba}};

inline constexpr std::array texture_format_names{Named{"argb8888", TextureFormat::argb8888},
                                                 Named{"xrgb8888", TextureFormat::xrgb8888},
                                                 Named{"rgb565", TextureFormat::rgb565},
                                                 Named{"argb1555", TextureFormat::argb1555},
                                                 Named{"xrgb1555", TextureFormat::xrgb1555},
                                                 Named{"argb4444", TextureFormat::argb4444},
                                                 Named{"l8", TextureFormat::l8},
                                                 Named{"a8", TextureFormat::a8},
                                                 Named{"i8", TextureFormat::i8},
                                                 Named{"la88", TextureFormat::la88},
                                                 Named{"dxt1", TextureFormat::dxt1},
                                                 Named{"dxt3", TextureFormat::dxt3},
                                                 Named{"dxt5", TextureFormat::dxt5}};

inline constexpr std::array mipmaps_names{Named{"none", Mipmaps::none}, Named{"box", Mipmaps::box}};

inline constexpr std::array color_format_names{
    Named{"rgba8888", ColorFormat::rgba8888},     Named{"xrgb8888_z", ColorFormat::xrgb8888_z},
    Named{"xrgb8888_o", ColorFormat::xrgb8888_o}, Named{"rgb565", ColorFormat::rgb565},
    Named{"xrgb1555_z", ColorFormat::xrgb1555_z}, Named{"xrgb1555_o", ColorFormat::xrgb1555_o}};

inline constexpr std::array primitive_names{Named{"triangles", Primitive::triangles},
                                            Named{"triangle_strip", Primitive::triangle_strip},
                                            Named{"triangle_fan", Primitive::triangle_fan},
                                            Named{"quads", Primitive::quads},
                                            Named{"quad_strip", Primitive::quad_strip},
                                            Named{"polygon", Primitive::polygon}};

inline constexpr std::array filter_rounding_names{Named{"half_up", FilterRounding::half_up},
                                                  Named{"floor", FilterRounding::floor},
                                                  Named{"once", FilterRounding::once}};

inline constexpr std::array product_rounding_names{Named{"nearest", ProductRounding::nearest},
                                                   Named{"floor", ProductRounding::floor},
                                                   Named{"shift", ProductRounding::shift}};

inline constexpr std::array vertex_color_names{
    Named{"nv17", VertexColorRounding::nv17}, Named{"nv2x", VertexColorRounding::nv2x},
    Named{"nearest", VertexColorRounding::nearest}, Named{"floor", VertexColorRounding::floor},
    Named{"real", VertexColorRounding::real}};

inline constexpr std::array shade_model_names{Named{"smooth", ShadeModel::smooth},
                                              Named{"flat", ShadeModel::flat}};

inline constexpr std::array provoking_names{Named{"last", ProvokingVertex::last},
                                            Named{"first", ProvokingVertex::first}};

inline constexpr std::array fog_mode_names{
    Named{"linear", FogMode::linear}, Named{"exp", FogMode::exp}, Named{"exp2", FogMode::exp2}};

inline constexpr std::array equation_names{
    Named{"add", BlendEquation::add}, Named{"subtract", BlendEquation::subtract},
    Named{"reverse_subtract", BlendEquation::reverse_subtract}, Named{"min", BlendEquation::min},
    Named{"max", BlendEquation::max}};

inline constexpr std::array cull_names{
    Named{"none", CullFace::none}, Named{"front", CullFace::front}, Named{"back", CullFace::back}};

inline constexpr std::array compare_names{
    Named{"never", CompareFunc::never},     Named{"less", CompareFunc::less},
    Named{"equal", CompareFunc::equal},     Named{"lequal", CompareFunc::lequal},
    Named{"greater", CompareFunc::greater}, Named{"notequal", CompareFunc::notequal},
    Named{"gequal", CompareFunc::gequal},   Named{"always", CompareFunc::always}};

inline constexpr std::array blend_names{
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
    Named{"constant_color", BlendFactor::constant_color},
    Named{"one_minus_constant_color", BlendFactor::one_minus_constant_color},
    Named{"constant_alpha", BlendFactor::constant_alpha},
    Named{"one_minus_constant_alpha", BlendFactor::one_minus_constant_alpha}};

}  // namespace twofold::scene_io
