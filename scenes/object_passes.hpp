#pragma once
#include <span>

#include "scenes/frame_builder.hpp"

/// An object's factors as passes.
namespace twofold {

/// Adds the images of a term; the result is the index of t1's first, t2's follow: the front and the
/// back of each, or one image each.
std::size_t add_factor_textures(Frame& frame, const ProductTerm& term, bool as_float);

/// Adds the passes of an object. @param textures of each term, as add_factor_textures() gave them
void add_object_passes(FrameBuilder& b, const FactoredObject& object,
                       const FactoredLighting& lighting, std::span<const std::size_t> textures);

/// How many passes those are.
std::size_t pass_count(const FactoredLighting& lighting);

}  // namespace twofold
