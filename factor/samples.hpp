#pragma once
#include <vector>

#include "texunit/linear.hpp"

namespace twofold {

/// One argument (v, n) of the lighting function: world-space unit vectors, n.v > 0 where visible.
struct SurfaceView {
    Vec3 n;  ///< surface normal
    Vec3 v;  ///< direction to the viewer
};

/// Samples of the lighting function L_o(v, n): radiance[i] belongs to at[i].
struct LightingSamples {
    std::vector<SurfaceView> at;
    std::vector<Rgb> radiance;
};

/// Samples of one material's lighting function: those of the fit and those held out of it.
struct MaterialSamples {
    LightingSamples fit;
    LightingSamples held_out;
};

}  // namespace twofold
