#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "factor/light_tree.hpp"
#include "factor/lobe_variation.hpp"
#include "factor/samples.hpp"

namespace twofold {

/// A node as the walk through the tree sees it.
struct Stop {
    Vec3 direction;
    double radius;
    std::uint32_t child, children;
};

/// The tree with what decides where to stop in it: a node is taken as one light by views whose r_v
/// is at least this far from it.
struct Stops {
    std::vector<Stop> nodes;
    std::vector<float> nearest;  ///< by row of LobeVariation, then node: squares of distances
    std::uint32_t roots = 0;
};

/// @param most what the bound of a node may be
Stops stops_of(const LightTree& tree, const LobeVariation& variation, double most, int threads);

/// The bound of a node's error at such variation of the lobe.
double bound_of(const LightNode& node, const LobeVariation::Bounds& rate);

/// Finds the nodes that a view takes; to be used by one thread.
class Walk {
  public:
    /// @param stops must live as long
    explicit Walk(const Stops& stops) : stops_(stops) {}

    /// The nodes, ascending, until the next call.
    std::span<const std::uint32_t> taken_by(const SurfaceView& at);

  private:
    /// Nodes [first, first + count).
    struct Range {
        std::uint32_t first, count;
    };
    struct Ends {
        std::size_t open, taken;
    };

    void make_room(Ends ends);
    Ends visit(Range range, Vec3 n, Vec3 r, const float* nearest, Ends ends);

    const Stops& stops_;
    std::vector<Range> open_;
    std::vector<std::uint32_t> taken_;
};

}  // namespace twofold
