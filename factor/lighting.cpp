#include "factor/lighting.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "factor/light_block.hpp"
#include "texunit/ordered_sum.hpp"
#include "texunit/parallel.hpp"

namespace twofold {
namespace {

/// Views a thread takes at a time: some milliseconds of work.
constexpr std::size_t views_per_task = 64;

/// A patch all of whose terms are +0.0: black, or wholly below the horizon of n. Adding +0.0
/// changes no lane of a block sum, as lanes begin at +0.0 and are never -0.0: the sum is the same
/// without the work.
bool adds_nothing(const LightCone& cone, Vec3 n) {
    return cone.dark || dot(n, cone.axis) <= -cone.sine;
}

LightBlock light_block_at(const DistantLights& lights, std::size_t block, Vec3 n) {
    constexpr std::size_t patches = light_block / light_patch;
    const std::size_t first = block * light_block;
    const std::size_t rest = lights.size() - first;
    unsigned lit = 0;
    for (std::size_t p = 0; p < patches && p * light_patch < rest; ++p) {
        const bool bounded = !lights.cones.empty();
        const bool nothing = bounded && adds_nothing(lights.cones[block * patches + p], n);
        lit |= nothing ? 0U : 1U << p;
    }
    return {lights, first, rest < light_block ? rest : light_block, lit};
}

template <class Table>
Rgb radiance(const Table& table, const DistantLights& lights, const SurfaceView& at) {
    if (!(dot(at.n, at.v) > 0.0)) {
        return Rgb(0.0);
    }
    std::array<BlockTree, 3> trees;
    for (std::size_t k = 0; k < lights.blocks(); ++k) {
        const LightBlock block = light_block_at(lights, k, at.n);
        const Rgb sum = block.lit == 0 ? Rgb(0.0) : block_sum(table, block, at);
        trees[0].add(sum.x);
        trees[1].add(sum.y);
        trees[2].add(sum.z);
    }
    return {trees[0].total(), trees[1].total(), trees[2].total()};
}

template <class Table>
std::vector<Rgb> radiances(const Table& table, const std::function<LightsOfView()>& begin,
                           std::span<const SurfaceView> at, int threads) {
    std::vector<Rgb> result(at.size(), Rgb(0.0));
    const std::size_t tasks = (at.size() + views_per_task - 1) / views_per_task;
    parallel_for(tasks, threads, [&](std::size_t task) {
        const LightsOfView lights = begin();
        const std::size_t first = task * views_per_task;
        const std::size_t end = std::min(first + views_per_task, at.size());
        for (std::size_t i = first; i < end; ++i) {
            if (dot(at[i].n, at[i].v) > 0.0) result[i] = radiance(table, lights(at[i]), at[i]);
        }
    });
    return result;
}

}  // namespace

Rgb outgoing_radiance(const Brdf& brdf, const DistantLights& lights, const SurfaceView& at) {
    check(brdf);
    return std::visit(
        [&](const auto& material) { return radiance(tabulate(material), lights, at); }, brdf);
}

std::vector<Rgb> outgoing_radiance(const Brdf& brdf, const DistantLights& lights,
                                   std::span<const SurfaceView> at, int threads) {
    const LightsOfView all = [&](const SurfaceView&) -> const DistantLights& { return lights; };
    return outgoing_radiance(
        brdf, [&] { return all; }, at, threads);
}

std::vector<Rgb> outgoing_radiance(const Brdf& brdf, const std::function<LightsOfView()>& begin,
                                   std::span<const SurfaceView> at, int threads) {
    check(brdf);
    return std::visit(
        [&](const auto& material) { return radiances(tabulate(material), begin, at, threads); },
        brdf);
}

}  // namespace twofold
