#pragma once
#include "tests/evidence/description.hpp"
#include "texunit/preset.hpp"

namespace twofold::evidence {

/// The framebuffer after all commands of the description, drawn under one preset.
/// @throws Error for a drawing that cannot be expressed as frames: memory written directly between
///         depth-tested draws.
ByteImage draw(const Description& description, Preset preset);

}  // namespace twofold::evidence
