#pragma once
#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"
#include "texunit/custom.hpp"

/// The specification: scalar, one fragment at a time, written to be read. Every other way of
/// drawing has to give the same bytes.
namespace twofold {

/// Draws all passes of the frame in order under one preset.
/// @throws Error for a frame that cannot be drawn: sizes out of range, indices that name nothing, a
/// singular
///         modelview where normals are needed.
/// @param custom what the preset `custom` computes with; other presets do not look at it
Framebuffer render_reference(const Frame& frame, Preset preset, const CustomSettings& custom = {});

}  // namespace twofold
