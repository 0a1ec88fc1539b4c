#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/alpha_lookup.hpp"
#include "raster/alpha_outcome.hpp"
#include "raster/bind.hpp"
#include "raster/lane_image.hpp"
#include "raster/level_bounds.hpp"
#include "raster/window_mesh.hpp"

/// What the alpha test will say of a whole triangle, found before it is drawn: the four passes of
/// the paper differ in nothing but the hemispheres whose texels have alpha 1, and most triangles
/// lie in one of them.
namespace twofold {

/// A triangle's own alpha, if all its corners have the same.
template <NumericModel M>
const typename M::Channel* common_alpha(const WindowMesh<M>& mesh, const MeshTriangle& t) {
    const auto alpha = [&](std::size_t k) -> const typename M::Channel& {
        return mesh.vertices[mesh.flat ? t.provoking : t.vertex[k]].color[3];
    };
    return alpha(0) == alpha(1) && alpha(1) == alpha(2) ? &alpha(0) : nullptr;
}

/// The outcome where the units' alphas are known: a zero makes the product 0, ones leave the
/// triangle's own alpha, or what a preset makes of that times 1.
template <NumericModel M>
AlphaOutcome alpha_outcome(const BoundPass<M>& pass, std::span<const AlphaKnown> units,
                           const WindowMesh<M>& mesh, const MeshTriangle& triangle) {
    const auto decided = [&](typename M::Channel alpha) {
        return compare(pass.state.alpha_test->func, pass.m.finish(alpha), pass.alpha_reference)
                   ? AlphaOutcome::passes
                   : AlphaOutcome::fails;
    };
    bool all_one = true;
    for (const AlphaKnown known : units) {
        if (known == AlphaKnown::zero) return decided(typename M::Channel{0});
        all_one = all_one && known == AlphaKnown::one;
    }
    if (!all_one) return AlphaOutcome::open;
    const auto* const own = common_alpha(mesh, triangle);
    if (!own) return AlphaOutcome::open;
    auto alpha = *own;
    for (const BoundUnit<M>& unit : pass.units)
        if (has_alpha(unit.texture->base_format)) alpha = pass.m.modulate(pass.m.one(), alpha);
    return decided(alpha);
}

/// The alpha lookups of a group's passes, each once, and which of them a pass's units make.
template <NumericModel M>
struct GroupAlpha {
    static constexpr std::size_t none = ~std::size_t{0};
    std::vector<AlphaLookup> lookups;
    std::vector<std::vector<std::size_t>> of_pass;    ///< [pass][unit in its list]: lookup or none
    std::vector<TexelColumns> places;                 ///< [lookup]
    std::vector<std::vector<AlphaOutcome>> outcomes;  ///< [pass][triangle]; empty: open
};

/// Whether a fragment's alpha is the product of the units' and its own, so that one zero decides.
template <NumericModel M>
bool multiplies_alpha(const BoundPass<M>& pass) {
    for (const BoundUnit<M>& unit : pass.units)
        if (unit.state.env.mode != TexEnvMode::modulate) return false;
    return !pass.combiners && !pass.state.color_sum && !pass.state.fog;
}

template <NumericModel M>
void add_pass(GroupAlpha<M>& group, const BoundPass<M>& pass,
              const std::array<std::size_t, max_units>& set_of) {
    auto& units = group.of_pass.emplace_back();
    group.outcomes.emplace_back();
    if (!pass.state.alpha_test || !multiplies_alpha(pass)) return;
    for (const BoundUnit<M>& unit : pass.units) {
        units.push_back(GroupAlpha<M>::none);
        if (!alpha_is_bounded(unit)) continue;
        AlphaLookup lookup = alpha_lookup(pass.m, unit, set_of[unit.index]);
        const auto known = std::find(group.lookups.begin(), group.lookups.end(), lookup);
        units.back() = static_cast<std::size_t>(known - group.lookups.begin());
        if (known == group.lookups.end()) group.lookups.push_back(std::move(lookup));
    }
}

/// Whether a lookup's coordinates are bounded by those of a triangle's corners.
inline bool is_convex(const AlphaLookup& lookup, const VertexFlags& flags) {
    const auto bit = static_cast<unsigned>(1u << lookup.set);
    return flags.finite && (flags.bounded & bit) &&
           (!lookup.divide_by_q || ((flags.positive_q | flags.negative_q) & bit));
}

/// Some of a mesh's triangles, one after the other.
template <NumericModel M>
struct TriangleRange {
    const WindowMesh<M>& mesh;
    std::size_t first, count;

    const MeshTriangle& operator[](std::size_t k) const { return mesh.triangles[first + k]; }
    lanes::TriangleList list() const {
        static_assert(sizeof(MeshTriangle) % sizeof(std::uint32_t) == 0);
        return {mesh.triangles[first].vertex.data(), sizeof(MeshTriangle) / sizeof(std::uint32_t),
                count};
    }
};

/// What a lookup's alphas are in each triangle, as far as one level goes.
template <NumericModel M>
std::vector<std::uint8_t> level_alphas(const TriangleRange<M>& triangles, const AlphaLookup& lookup,
                                       const TexelColumns& places, std::size_t level) {
    std::vector<std::uint8_t> known(triangles.count + lanes::widest);
    lanes::find_alphas(lookup.grid(level), {places.u.data(), places.v.data()}, triangles.list(),
                       known.data());
    return known;
}

/// The coarsest level that a triangle's lookups may read.
template <NumericModel M>
std::size_t coarsest_level(const M& m, const WindowMesh<M>& mesh, const MeshTriangle& t,
                           const AlphaLookup& lookup) {
    const std::size_t last = lookup.levels.size() - 1;
    if (!lookup.divide_by_q) return last;
    const auto& coords = mesh.coords[lookup.set];
    const CoordinateSteps steps =
        coordinate_steps(mesh, t, setup_of(mesh, t), m.snap().fraction_bits);
    const double bound = squared_scale_bound<typename M::Real>(
        steps, {&coords[t.vertex[0]], &coords[t.vertex[1]], &coords[t.vertex[2]]}, lookup.scale());
    std::size_t level = 0;
    while (level < last && !(bound <= lookup.reach[level])) ++level;
    return level;
}

/// Forgets what coarser levels do not say, too.
template <NumericModel M>
void ask_coarser_levels(const M& m, const TriangleRange<M>& triangles, const AlphaLookup& lookup,
                        const TexelColumns& places, std::vector<std::uint8_t>& known) {
    std::vector<std::size_t> coarsest(triangles.count);
    for (std::size_t k = 0; k < triangles.count; ++k)
        if (known[k] != 0) coarsest[k] = coarsest_level(m, triangles.mesh, triangles[k], lookup);
    const std::size_t last = *std::max_element(coarsest.begin(), coarsest.end());
    for (std::size_t level = 1; level <= last; ++level) {
        const auto here = level_alphas(triangles, lookup, places, level);
        for (std::size_t k = 0; k < triangles.count; ++k)
            if (level <= coarsest[k] && here[k] != known[k]) known[k] = 0;
    }
}

/// What a lookup's alphas are in each triangle.
template <NumericModel M>
std::vector<std::uint8_t> known_alphas(const M& m, const TriangleRange<M>& triangles,
                                       const AlphaLookup& lookup, const TexelColumns& places) {
    auto known = level_alphas(triangles, lookup, places, 0);
    for (std::size_t k = 0; k < triangles.count; ++k)
        if (!is_convex(lookup, triangles[k].flags)) known[k] = 0;
    if (lookup.levels.size() > 1) ask_coarser_levels(m, triangles, lookup, places, known);
    return known;
}

/// Finds what each pass's alpha test does with each triangle of the mesh.
/// @param passes  the group's, in the order of add_pass
template <NumericModel M>
void find_outcomes(const WindowMesh<M>& mesh, const std::vector<const BoundPass<M>*>& passes,
                   int threads, GroupAlpha<M>& group) {
    if (group.lookups.empty()) return;
    group.places.resize(group.lookups.size());
    for (std::size_t l = 0; l < group.lookups.size(); ++l)
        place_texels(group.lookups[l], mesh.coords[group.lookups[l].set], group.places[l]);
    for (std::size_t p = 0; p < passes.size(); ++p)
        if (!group.of_pass[p].empty()) group.outcomes[p].resize(mesh.triangles.size());
    constexpr std::size_t block = 2048;
    const std::size_t size = mesh.triangles.size();
    parallel_for((size + block - 1) / block, threads, [&](std::size_t b) {
        const std::size_t first = b * block, count = std::min(block, size - first);
        std::vector<std::vector<std::uint8_t>> known;  // [lookup][triangle]
        for (std::size_t l = 0; l < group.lookups.size(); ++l)
            known.push_back(known_alphas(passes.front()->m, TriangleRange<M>{mesh, first, count},
                                         group.lookups[l], group.places[l]));
        std::array<AlphaKnown, max_units> units{};
        for (std::size_t p = 0; p < passes.size(); ++p) {
            const auto& of_pass = group.of_pass[p];
            if (of_pass.empty()) continue;
            for (std::size_t k = 0; k < count; ++k) {
                for (std::size_t u = 0; u < of_pass.size(); ++u)
                    units[u] = of_pass[u] == GroupAlpha<M>::none
                                   ? AlphaKnown::nothing
                                   : static_cast<AlphaKnown>(known[of_pass[u]][k]);
                group.outcomes[p][first + k] =
                    alpha_outcome(*passes[p], std::span(units.data(), of_pass.size()), mesh,
                                  mesh.triangles[first + k]);
            }
        }
    });
}

}  // namespace twofold
