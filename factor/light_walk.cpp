#include "factor/light_walk.hpp"

#include <algorithm>

#include "factor/parametrization.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// The least square of |r - direction| at which the node's bound is not above `most`.
float nearest_square(const LightNode& node, const LobeVariation& variation, std::size_t row,
                     double most) {
    std::size_t step = LobeVariation::distance_steps;
    while (step > 0 && bound_of(node, variation.bounds(row, step - 1)) <= most) --step;
    if (step == 0) return 0.0F;
    const double distance = LobeVariation::distance_of(static_cast<double>(step)) + node.radius;
    return step == LobeVariation::distance_steps
               ? 9.0F  // no direction is that far
               : static_cast<float>(distance * distance * (1.0 + 0x1p-20));
}

}  // namespace

double bound_of(const LightNode& node, const LobeVariation::Bounds& rate) {
    return node.first * rate.first + 0.5 * node.second * rate.second;
}

Stops stops_of(const LightTree& tree, const LobeVariation& variation, double most, int threads) {
    Stops stops{{}, std::vector<float>(LobeVariation::view_rows * tree.nodes.size()), tree.roots};
    for (const LightNode& node : tree.nodes)
        stops.nodes.push_back({node.direction, node.radius, node.child, node.children});
    parallel_for(LobeVariation::view_rows, threads, [&](std::size_t row) {
        for (std::size_t k = 0; k < tree.nodes.size(); ++k)
            if (tree.nodes[k].children > 0)
                stops.nearest[row * tree.nodes.size() + k] =
                    nearest_square(tree.nodes[k], variation, row, most);
    });
    return stops;
}

std::span<const std::uint32_t> Walk::taken_by(const SurfaceView& at) {
    const Vec3 r = pi_2(at);
    const float* nearest =
        stops_.nearest.data() + LobeVariation::row_of(dot(at.n, at.v)) * stops_.nodes.size();
    make_room({1, 0});
    open_[0] = {0, stops_.roots};
    Ends ends{1, 0};
    for (std::size_t next = 0; next < ends.open; ++next) {
        const Range range = open_[next];
        make_room({ends.open + range.count, ends.taken + range.count});
        ends = visit(range, at.n, r, nearest, ends);
    }
    return std::span(taken_).first(ends.taken);
}

void Walk::make_room(Ends ends) {
    if (open_.size() < ends.open) open_.resize(2 * ends.open);
    if (taken_.size() < ends.taken) taken_.resize(2 * ends.taken);
}

/// Appends every node to both lists; only the list that it belongs to grows. Whether a node is
/// below the horizon or near is a coin's toss to a branch.
Walk::Ends Walk::visit(Range range, Vec3 n, Vec3 r, const float* nearest, Ends ends) {
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
        const Stop& node = stops_.nodes[k];
        const Vec3 off = r - node.direction;
        const auto lit = static_cast<unsigned>(!(dot(n, node.direction) <= -node.radius));
        const auto away = static_cast<unsigned>(dot(off, off) >= static_cast<double>(nearest[k]));
        taken_[ends.taken] = k;
        ends.taken += lit & away;
        open_[ends.open] = {node.child, node.children};
        ends.open += lit & (away ^ 1U);
    }
    return ends;
}

}  // namespace twofold
