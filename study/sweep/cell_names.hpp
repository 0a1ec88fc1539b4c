#pragma once
#include "scenes/named.hpp"
#include "study/sweep/cell.hpp"

/// The names of a cell's enumerators in study files and results.
namespace twofold {

inline constexpr std::array technique_names{
    scene_io::Named{"factored", Technique::factored}, scene_io::Named{"exact", Technique::exact},
    scene_io::Named{"vertex_sum", Technique::vertex_sum},
    scene_io::Named{"vertex_lights", Technique::vertex_lights}};

inline constexpr std::array draw_way_names{scene_io::Named{"fused", DrawWay::fused},
                                           scene_io::Named{"literal", DrawWay::literal},
                                           scene_io::Named{"reference", DrawWay::reference}};

inline constexpr std::array texel_filter_names{
    scene_io::Named{"linear", TexelFilter::linear},
    scene_io::Named{"nearest", TexelFilter::nearest},
    scene_io::Named{"trilinear", TexelFilter::trilinear}};

}  // namespace twofold
