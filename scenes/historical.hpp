#pragma once
#include "scenes/assets.hpp"
#include "scenes/frame.hpp"
#include "scenes/point_lit_passes.hpp"

namespace twofold {

/// Adds an object's passes to a frame: colour x p(l) x q(h) on two units, then x p(v) by blending
/// (ZERO, SRC_COLOR), then a highlight by (ONE, ONE). The colour is diffuse x alpha x irradiance x
/// max(0, n.l) at each vertex, spread over vertex colour and a combiner scale of 1, 2 or 4; above 4
/// it is clamped. Directions are taken at the vertices, in the frame of the surface, and their
/// paraboloid coordinates are projective.
/// @source McCool, Ang & Ahmad 2001, section 5; the constants of libsh's renderer
void add_historical(Frame& frame, const HistoricalObject& object, const Mesh& mesh,
                    const FactorSet& set, const Camera& camera);

}  // namespace twofold
