#pragma once
#include <optional>

#include "texunit/preset.hpp"
#include "texunit/texture.hpp"
#include "texunit/unit_state.hpp"

namespace twofold {

/// The sides that a chip takes, without border texels.
struct SizeLimit {
    int largest;
    bool powers_of_two;

    bool allows(int side) const;
};

/// What the preset's chip takes for a texture of this kind; nothing if the preset is no chip or the
/// chip's limits are not modelled.
/// @source envytools hwtest for NV1x: 2D to 2048, rectangles below 2048, cubes to 512 for texels of
/// 32 bits and DXT3/5, else to 1024
std::optional<SizeLimit> size_limit(Preset preset, TextureTarget target, const Texture& texture);

}  // namespace twofold
