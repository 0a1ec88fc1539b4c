#include "factor/clustered_lighting.hpp"

#include <algorithm>
#include <cmath>

#include "factor/directions.hpp"
#include "factor/light_tree.hpp"
#include "factor/light_walk.hpp"
#include "factor/lighting.hpp"
#include "factor/lobe_variation.hpp"
#include "factor/parametrization.hpp"
#include "factor/simd_clones.hpp"
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

/// A light of a node, where one line of the cache holds it.
struct alignas(64) NodeLight {
    double x, y, z, r, g, b;
};

/// Vectors take this many lights at a time; what a list lacks is filled up with black ones, which
/// change no sum.
constexpr std::size_t lights_at_a_time = 8;

TWOFOLD_SIMD_CLONES
void put(DistantLights& lights, const std::vector<NodeLight>& of_node,
         std::span<const std::uint32_t> nodes) {
    const std::size_t count = nodes.size();
    const std::size_t room = (count + lights_at_a_time - 1) / lights_at_a_time * lights_at_a_time;
    for (auto* values : {&lights.x, &lights.y, &lights.z, &lights.r, &lights.g, &lights.b})
        values->resize(room);
    const NodeLight* const from = of_node.data();
    const std::uint32_t* const node = nodes.data();
    const auto gather = [&](std::vector<double> & to, double NodeLight::*part)
        __attribute__((always_inline)) {
        double* const out = to.data();
        for (std::size_t i = 0; i < count; ++i) out[i] = from[node[i]].*part;
    };
    gather(lights.x, &NodeLight::x);
    gather(lights.y, &NodeLight::y);
    gather(lights.z, &NodeLight::z);
    gather(lights.r, &NodeLight::r);
    gather(lights.g, &NodeLight::g);
    gather(lights.b, &NodeLight::b);
    for (std::size_t i = count; i < room; ++i) {
        lights.x[i] = lights.y[i] = 0.0;
        lights.z[i] = 1.0;
        lights.r[i] = lights.g[i] = lights.b[i] = 0.0;
    }
}

std::vector<NodeLight> lights_of(const LightTree& tree) {
    std::vector<NodeLight> lights;
    lights.reserve(tree.nodes.size());
    for (const LightNode& node : tree.nodes)
        lights.push_back({node.direction.x, node.direction.y, node.direction.z, node.weight.x,
                          node.weight.y, node.weight.z});
    return lights;
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
    std::vector<NodeLight> lights;  ///< of the nodes
    LobeVariation variation;
    Stops stops;

    double bound(const SurfaceView& at, std::span<const std::uint32_t> taken) const {
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
            put(scratch->lights, parts.lights, scratch->walk.taken_by(view));
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
        const auto nodes = walk.taken_by(view);
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
    LightTree tree = light_tree(lights);
    std::vector<NodeLight> node_lights = lights_of(tree);
    auto parts = std::make_unique<Parts>(
        Parts{brdf, std::move(tree), std::move(node_lights), LobeVariation(brdf, threads), {}});
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
