#pragma once
#include "raster/framebuffer.hpp"
#include "scenes/assets.hpp"
#include "scenes/lighting.hpp"

namespace twofold {

/// The truth beside the pictures: at each pixel centre equation (1) in binary64, without
/// factorisation, for the surface that ideal64 sees there. The normal is interpolated between the
/// vertices and made unit.
struct ExactPicture {
    Framebuffer picture;      ///< radiance / white, limited to [0, 1]; alpha 1 where an object is
    std::size_t turned_away;  ///< pixels whose interpolated normal faces away from the eye: there v
                              ///< is taken at the horizon
};

ExactPicture exact_picture(const Scene& scene, const SceneAssets& assets, const LitScene& lit,
                           int threads);

}  // namespace twofold
