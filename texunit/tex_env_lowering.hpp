#pragma once
#include <cstddef>
#include <span>

#include "texunit/combiner_state.hpp"
#include "texunit/tex_env_state.hpp"

/// Texture environments as the drivers of register-combiner chips set them up: one general stage a
/// unit, its result in spare0.
namespace twofold {

/// A texture unit that is on.
struct UnitEnvironment {
    std::size_t unit;  ///< its texture register
    TexEnv env;
    BaseFormat format;
};

/// Combiners that compute what apply_tex_env() computes for the units in order, bit for bit on nv17
/// and nv2x.
///
/// Every environment fits one stage. DOT3_RGBA needs a second one that copies blue into alpha,
/// unless it is the last unit: the final combiner can take its alpha from blue. ADD_SIGNED with
/// scale 4 is done with 2: the bias excludes that scale. Odd stages take their colour from the
/// second constant, because two stages on NV1x share two constants.
///
/// @param stages  general stages that the chip has: `combiner_stages` of its model
/// @throws Error naming the unit for which no stage is left
RegisterCombiners lowered(std::span<const UnitEnvironment> units, int stages);

}  // namespace twofold
