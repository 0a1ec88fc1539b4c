#pragma once
#include <cstdint>
#include <vector>

#include "factor/distant_lights.hpp"

namespace twofold {

/// The lights of one cell of the sphere as one light, and what that leaves out.
struct LightNode {
    Vec3 direction{0.0};  ///< mean of the lights, weighted by their energy, unit
    Rgb weight{0.0};      ///< sum of W: the energy is kept
    double radius = 0.0;  ///< largest distance |l - direction| of a light
    double first = 0.0;   ///< |sum W (l - direction)| across the direction, largest channel: what
                          ///< is left of the first moment, as one direction serves three channels
    double second = 0.0;  ///< sum W |l - direction|^2, largest channel
    std::uint32_t child = 0, children = 0;  ///< nodes [child, child + children); none: one light
};

/// The lights over a hierarchy of cells: the faces of a cube, each cut into 2 x 2 cells again and
/// again until a cell holds one light. Black cells are left out. Nodes of a level lie together, in
/// the order of their cells.
struct LightTree {
    std::vector<LightNode> nodes;
    std::uint32_t roots = 0;  ///< the first nodes
};

LightTree light_tree(const DistantLights& lights);

}  // namespace twofold
