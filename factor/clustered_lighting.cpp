#include "factor/clustered_lighting.hpp"

#include <algorithm>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/light_tree.hpp"
#include "factor/lighting.hpp"
#include "factor/lobe_variation.hpp"
#include "factor/parametrization.hpp"
#include "texunit/fixed.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {

namespace {

/// A node's bound may at first be the tolerance over this. Bounds add up while errors do not: their
/// sum is some thirty times the error.
constexpr double first_share = 4.0;

/// The measured error is taken to this share of the tolerance: what is left is for other views.
constexpr double aim = 0.5;
constexpr int most_trials = 6;

constexpr int judged_views = 256;
constexpr std::uint64_t judged_sequence =
    7;  ///< of surface_views(): in no fit and held out of none

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

double bound_of(const LightNode& node, const LobeVariation::Bounds& rate) {
    return node.first * rate.first + 0.5 * node.second * rate.second;
}

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

/// Nodes that a view takes, level by level.
class Walk {
  public:
    explicit Walk(const Stops& stops) : stops_(stops) {}

    const std::vector<std::uint32_t>& taken_by(const SurfaceView& at) {
        taken_.clear();
        open_.assign(1, {0, stops_.roots});
        const Vec3 r = pi_2(at);
        const float* nearest =
            stops_.nearest.data() + LobeVariation::row_of(dot(at.n, at.v)) * stops_.nodes.size();
        for (std::size_t next = 0; next < open_.size(); ++next) {
            const auto [first, count] = open_[next];
            for (std::uint32_t k = first; k < first + count; ++k) visit(k, at.n, r, nearest);
        }
        return taken_;
    }

  private:
    void visit(std::uint32_t k, Vec3 n, Vec3 r, const float* nearest) {
        const Stop& node = stops_.nodes[k];
        if (dot(n, node.direction) <= -node.radius) return;  // below the horizon
        const Vec3 off = r - node.direction;
        if (dot(off, off) >= static_cast<double>(nearest[k]))
            taken_.push_back(k);
        else
            open_.emplace_back(node.child, node.children);
    }

    const Stops& stops_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open_;
    std::vector<std::uint32_t> taken_;
};

void put(DistantLights& lights, const LightTree& tree, const std::vector<std::uint32_t>& nodes) {
    for (auto* values : {&lights.x, &lights.y, &lights.z, &lights.r, &lights.g, &lights.b})
        values->resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const LightNode& node = tree.nodes[nodes[i]];
        lights.x[i] = node.direction.x;
        lights.y[i] = node.direction.y;
        lights.z[i] = node.direction.z;
        lights.r[i] = node.weight.x;
        lights.g[i] = node.weight.y;
        lights.b[i] = node.weight.z;
    }
}

double root_mean_square(std::size_t n, const auto& value) {
    return std::sqrt(ordered_sum(n,
                                 [&](std::size_t i) {
                                     const double v = value(i);
                                     return v * v;
                                 }) /
                     static_cast<double>(n));
}

}  // namespace

struct ClusteredLighting::Parts {
    Brdf brdf;
    LightTree tree;
    LobeVariation variation;
    Stops stops;

    double bound(const SurfaceView& at, const std::vector<std::uint32_t>& taken) const {
        const std::size_t row = LobeVariation::row_of(dot(at.n, at.v));
        double sum = 0.0;
        for (const std::uint32_t k : taken) {
            const LightNode& node = tree.nodes[k];
            if (node.children == 0) continue;
            const double distance = max(0.0, length(pi_2(at) - node.direction) - node.radius);
            const double step = std::sqrt(0.5 * distance) * LobeVariation::distance_steps;
            const auto last = LobeVariation::distance_steps - 1;
            sum += bound_of(
                node, variation.bounds(row, to_fixed(std::floor(step), std::size_t{0}, last)));
        }
        return sum;
    }
};

namespace {

using Parts = ClusteredLighting::Parts;

std::vector<Rgb> merged_radiance(const Parts& parts, std::span<const SurfaceView> at, int threads) {
    struct Scratch {
        Walk walk;
        DistantLights lights;
    };
    const auto begin = [&]() -> LightsOfView {
        return [scratch = std::make_shared<Scratch>(Scratch{Walk(parts.stops), {}}),
                &parts](const SurfaceView& view) -> const DistantLights& {
            put(scratch->lights, parts.tree, scratch->walk.taken_by(view));
            return scratch->lights;
        };
    };
    return outgoing_radiance(parts.brdf, begin, at, threads);
}

/// @param largest rms of the largest channel of `full`
ClusterReport judged(const Parts& parts, std::span<const SurfaceView> at, std::span<const Rgb> full,
                     double largest, int threads) {
    ClusterReport report{.views = at.size()};
    if (largest == 0.0) return report;
    const std::vector<Rgb> merged = merged_radiance(parts, at, threads);
    Walk walk(parts.stops);
    std::vector<double> bound;
    double taken = 0.0;
    for (const SurfaceView& view : at) {
        const auto& nodes = walk.taken_by(view);
        taken += static_cast<double>(nodes.size());
        bound.push_back(parts.bound(view, nodes));
    }
    report.lights = taken / static_cast<double>(at.size());
    report.bound = root_mean_square(at.size(), [&](std::size_t i) { return bound[i]; }) / largest;
    report.relative_rms =
        root_mean_square(at.size(), [&](std::size_t i) { return length(merged[i] - full[i]); }) /
        root_mean_square(at.size(), [&](std::size_t i) { return length(full[i]); });
    return report;
}

}  // namespace

ClusteredLighting::~ClusteredLighting() = default;
ClusteredLighting::ClusteredLighting(ClusteredLighting&&) noexcept = default;

ClusteredLighting::ClusteredLighting(const Brdf& brdf, const DistantLights& lights,
                                     double tolerance, int threads) {
    const std::vector<SurfaceView> at = surface_views(judged_views, judged_sequence);
    const std::vector<Rgb> full = outgoing_radiance(brdf, lights, at, threads);
    const double largest =
        root_mean_square(at.size(), [&](std::size_t i) { return max_component(full[i]); });
    auto parts =
        std::make_unique<Parts>(Parts{brdf, light_tree(lights), LobeVariation(brdf, threads), {}});
    double most = tolerance * largest / first_share;
    for (int trial = 0; trial < most_trials; ++trial) {
        parts->stops = stops_of(parts->tree, parts->variation, most, threads);
        report_ = judged(*parts, at, full, largest, threads);
        // The error is about in proportion to the bound of a node.
        const double wanted = aim * tolerance / max(report_.relative_rms, aim * tolerance / 4.0);
        if (largest == 0.0 || (trial > 0 && report_.relative_rms <= tolerance)) break;
        most *= wanted;
    }
    report_.tolerance = tolerance;
    report_.full_lights = lights.size();
    parts_ = std::move(parts);
}

std::vector<Rgb> ClusteredLighting::radiance(std::span<const SurfaceView> at, int threads) const {
    return merged_radiance(*parts_, at, threads);
}

}  // namespace twofold
