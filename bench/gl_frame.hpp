#pragma once
#include "raster/pass.hpp"
#include "texunit/texture.hpp"

namespace twofold::bench {

/// The frame as OpenGL's fixed function draws it: RGBA of 8 bits, rows top down, whatever the
/// driver's arithmetic is. A GlContext must be current.
/// @throws Error for a frame that fixed function cannot say (register combiners, window-space
/// vertices, a viewport of its own, coordinates without perspective, 16-bit colour), or if OpenGL
/// reports an error
ByteImage draw_with_gl(const Frame& frame);

}  // namespace twofold::bench
