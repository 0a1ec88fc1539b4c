#pragma once
#include <string_view>

#include "bench/draw/inputs.hpp"

/// The drawings that are timed, under the names that the peers give them.
namespace twofold::bench {

/// The picture that a peer makes of `inputs`, as a frame:
/// `clear`         nothing but the clear colour;
/// `tex1-nearest`  one texture, nearest texel;
/// `tex2-persp`    two textures, MODULATE, bilinear;
/// `para4`         two dual paraboloids in four alpha-tested passes, coordinates generated.
/// All with depth test LEQUAL and back faces culled. A quad is given in clip space.
/// @throws Error(failure) for another name
Frame frame_of(const Inputs& inputs);

}  // namespace twofold::bench
