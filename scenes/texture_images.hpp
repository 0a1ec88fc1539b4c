#pragma once
#include "scenes/scene.hpp"
#include "texunit/texture.hpp"

namespace twofold {

/// A picture, rows top down, as a texture image, rows bottom up.
Texture texture_of(const ByteImage& image);

/// A chequered texture; field (0, 0) is at s = t = 0.
Texture checkerboard(const Checkerboard& spec);

}  // namespace twofold
