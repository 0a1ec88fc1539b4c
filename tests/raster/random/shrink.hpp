#pragma once
#include <functional>

#include "tests/raster/random/random_state.hpp"

namespace twofold::test {

/// A small state that still fails: passes, triangles, units and state are taken away one after the
/// other, as long as `fails` holds, until nothing more can go. What no pass uses is gone.
/// @param fails is true for `state`
RandomState shrunk(RandomState state, const std::function<bool(const RandomState&)>& fails);

/// Without the vertices, meshes and textures that no pass uses; draws the same picture.
Frame compacted(Frame frame);

}  // namespace twofold::test
