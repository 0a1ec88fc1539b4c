#pragma once
#include <array>
#include <optional>
#include <vector>

#include "texunit/linear.hpp"

/// State of the register combiners, in the terms of NV_register_combiners. Values are what a scene
/// or a texture environment declares; combiner.hpp computes with them.
/// @source NV_register_combiners specification, 3.8.12
namespace twofold {

/// Texture units and texture registers: 2 on nv17, 4 on nv2x and in the real models.
inline constexpr std::size_t max_units = 4;

enum class CombinerRegister {
    zero,
    constant_color0,
    constant_color1,
    fog,
    primary_color,
    secondary_color,
    texture0,
    texture1,
    texture2,
    texture3,
    spare0,
    spare1,
    spare0_plus_secondary_color,  ///< final combiner, A to D
    e_times_f                     ///< final combiner, A to D
};

/// How an input register value e in [-1, 1] is read.
enum class CombinerMapping {
    unsigned_identity,  ///< max(0, e)
    unsigned_invert,    ///< 1 - min(max(0, e), 1)
    expand_normal,      ///< 2 max(0, e) - 1
    expand_negate,      ///< -2 max(0, e) + 1
    half_bias_normal,   ///< max(0, e) - 1/2
    half_bias_negate,   ///< -max(0, e) + 1/2
    signed_identity,    ///< e
    signed_negate       ///< -e
};

enum class CombinerComponent { rgb, alpha, blue };

struct CombinerInput {
    CombinerRegister source = CombinerRegister::zero;
    CombinerComponent component = CombinerComponent::rgb;
    CombinerMapping mapping = CombinerMapping::unsigned_identity;
    bool operator==(const CombinerInput&) const = default;
};

enum class CombinerScale { one, two, four, one_half };

/// The RGB or the alpha half of a general combiner stage. An output that is not set is discarded.
struct CombinerPortion {
    std::array<CombinerInput, 4> input;  ///< A, B, C, D
    std::optional<CombinerRegister> ab_output, cd_output, sum_output;
    bool ab_dot_product = false, cd_dot_product = false;  ///< RGB only
    bool mux = false;                ///< the sum output is AB if spare0 alpha < 1/2, else CD
    bool mux_by_lowest_bit = false;  ///< NV2x: AB if the lowest bit of spare0 alpha is 0, else CD
    CombinerScale scale = CombinerScale::one;
    bool bias_by_negative_one_half = false;
    bool ab_blue_to_alpha = false, cd_blue_to_alpha = false;  ///< NV2x, RGB only
    bool operator==(const CombinerPortion&) const = default;
};

struct CombinerStage {
    CombinerPortion rgb, alpha;
    Vec4 constant_color0{0.0}, constant_color1{0.0};
    bool operator==(const CombinerStage&) const = default;
};

/// rgb = min(A B + (1 - A) C + D, 1), alpha = G. Inputs are read by unsigned_identity or
/// unsigned_invert.
struct FinalCombiner {
    CombinerInput a, b, c, d, e, f, g;
    Vec4 constant_color0{0.0}, constant_color1{0.0};
    bool clamp_sum = false;         ///< COLOR_SUM_CLAMP: spare0 + secondary is limited to 1
    bool invert_spare0 = false;     ///< of the sum register, NV2x
    bool invert_secondary = false;  ///< of the sum register, NV2x
    bool operator==(const FinalCombiner&) const = default;
};

/// 1 to 8 general stages (2 on nv17) and the final one. With it, texture environments are not used.
struct RegisterCombiners {
    std::vector<CombinerStage> stages;
    FinalCombiner final_stage;
    bool operator==(const RegisterCombiners&) const = default;
};

}  // namespace twofold
