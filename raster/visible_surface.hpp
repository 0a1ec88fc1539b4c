#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "raster/pass.hpp"
#include "texunit/ideal64.hpp"

namespace twofold {

/// What is seen through one pixel centre: a triangle of a pass's mesh and the perspective-correct
/// weights of its three vertices.
struct SurfacePoint {
    std::uint32_t pass;                   ///< index into the frame's passes
    std::array<std::uint32_t, 3> vertex;  ///< of that pass's mesh
    std::array<double, 3> weights;        ///< >= 0, they sum to 1
};

struct VisibleSurface {
    int width = 0;
    int height = 0;
    std::vector<std::int32_t>
        point_of_pixel;                ///< rows top down; index into points, -1 = background
    std::vector<SurfacePoint> points;  ///< in pixel order
};

/// The nearest surface at each pixel centre, whatever the passes' tests, textures and blending are;
/// of equal depths the last wins, as with LEQUAL. Culling is kept.
/// @param snap  of the vertices, whose places are computed in binary64
VisibleSurface visible_surface(const Frame& frame, SnapRule snap = Ideal64::snap());

}  // namespace twofold
