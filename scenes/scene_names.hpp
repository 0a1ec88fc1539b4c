#pragma once
#include "scenes/named.hpp"
#include "scenes/scene.hpp"

/// The names of enumerators in scene files: one table for the reader and the writer.
namespace twofold::scene_io {

inline constexpr std::array method_names{Named{"letter", Method::letter},
                                         Named{"paper", Method::paper}};

inline constexpr std::array solver_names{Named{"qmr", Solver::qmr}, Named{"lsmr", Solver::lsmr}};

inline constexpr std::array constant_names{Named{"pi1981", CookTorranceConstant::pi1981},
                                           Named{"modern4", CookTorranceConstant::modern4}};

inline constexpr std::array texgen_names{Named{"none", TexGen::none},
                                         Named{"normal_map", TexGen::normal_map},
                                         Named{"reflection_map", TexGen::reflection_map}};

inline constexpr std::array wrap_names{Named{"repeat", Wrap::repeat}, Named{"clamp", Wrap::clamp},
                                       Named{"clamp_to_edge", Wrap::clamp_to_edge},
                                       Named{"clamp_to_border", Wrap::clamp_to_border}};

inline constexpr std::array filter_names{Named{"nearest", Filter::nearest},
                                         Named{"linear", Filter::linear}};

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
    Named{"src_alpha_saturate", BlendFactor::src_alpha_saturate}};

}  // namespace twofold::scene_io
