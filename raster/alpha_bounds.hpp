#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/alpha_lanes.hpp"
#include "raster/alpha_outcome.hpp"
#include "raster/bind.hpp"
#include "raster/lane_image.hpp"
#include "raster/window_mesh.hpp"

/// What the alpha test will say of a whole triangle, found before it is drawn: the four passes of
/// the paper differ in nothing but the hemispheres whose texels have alpha 1, and most triangles lie
/// in one of them.
namespace twofold {

/// What is known of the alpha that a unit's lookups give all over a triangle; as find_alphas() of
/// alpha_lanes.hpp numbers it.
enum class AlphaKnown : std::uint8_t { nothing, zero, one };

/// A unit's lookup as far as its alpha goes: the set of coordinates, and lanes::AlphaGrid with its
/// memory.
struct AlphaLookup {
    std::size_t set;
    int width, height;
    bool in_texels, divide_by_q;
    int cell_bits;      ///< a cell has 2^cell_bits texels a side
    int columns, rows;  ///< cells
    std::vector<std::uint32_t> count;

    lanes::AlphaGrid grid() const { return {width, height, cell_bits, columns, count.data()}; }
    bool operator==(const AlphaLookup&) const = default;
};

/// Cells a side at most: the grids of four textures stay in the nearest caches.
inline constexpr int most_cells = 128;

/// Lookups whose alpha can be bounded: one level, clamped to its edge, combined by MODULATE of alpha
/// without a scale.
template <NumericModel M>
bool alpha_is_bounded(const BoundUnit<M>& unit) {
    const TextureUnitState& s = unit.state;
    return s.target != TextureTarget::cube_map && !unit.derivatives &&
           s.wrap_s == Wrap::clamp_to_edge && s.wrap_t == Wrap::clamp_to_edge &&
           s.env.mode == TexEnvMode::modulate && unit.env.alpha_scale == 1;
}

/// What the alphas of one cell are.
template <NumericModel M>
AlphaKnown cell_alpha(const M& m, const UploadedImage<M>& image, int cell, int column, int row) {
    bool zero = true, one = true;
    for (int j = row * cell; j < std::min(image.height, (row + 1) * cell); ++j)
        for (int i = column * cell; i < std::min(image.width, (column + 1) * cell); ++i) {
            const auto alpha = image.texels[static_cast<std::size_t>(j * image.width + i)][3];
            zero = zero && alpha == typename M::Channel{0};
            one = one && alpha == m.one();
        }
    return zero ? AlphaKnown::zero : (one ? AlphaKnown::one : AlphaKnown::nothing);
}

template <NumericModel M>
AlphaLookup alpha_lookup(const M& m, const BoundUnit<M>& unit, std::size_t set) {
    const UploadedImage<M>& image = unit.texture->levels[0];
    int cell_bits = 0;
    while (std::max(image.width, image.height) >> cell_bits > most_cells) ++cell_bits;
    const int cell = 1 << cell_bits;
    const int columns = (image.width + cell - 1) / cell, rows = (image.height + cell - 1) / cell;
    AlphaLookup lookup{set, image.width, image.height,
                       unit.state.target == TextureTarget::rectangle, unit.state.divide_by_q,
                       cell_bits, columns, rows, {}};
    const auto stride = static_cast<std::size_t>(columns) + 1;
    lookup.count.resize(stride * (static_cast<std::size_t>(rows) + 1));
    for (int j = 0; j < rows; ++j) {
        std::uint32_t left = 0;
        for (int i = 0; i < columns; ++i) {
            const AlphaKnown known = cell_alpha(m, image, cell, i, j);
            left += known == AlphaKnown::zero ? 1u : (known == AlphaKnown::one ? 1u << 16 : 0u);
            const std::size_t at = static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i);
            lookup.count[at + stride + 1] = lookup.count[at + 1] + left;
        }
    }
    return lookup;
}

/// Places of vertices in an image, in texels; rounded to binary32, which the margins of
/// alpha_lanes.cpp allow for.
struct TexelColumns {
    std::vector<float> u, v;
};

template <class Real>
void place_texels(const AlphaLookup& lookup, const std::vector<std::array<Real, 4>>& coords,
                  TexelColumns& out) {
    out.u.resize(coords.size());
    out.v.resize(coords.size());
    const double width = lookup.in_texels ? 1 : lookup.width;
    const double height = lookup.in_texels ? 1 : lookup.height;
    const auto held = [](double u) {
        return static_cast<float>(u < -32768.0 ? -32768.0 : (u > 32768.0 ? 32768.0 : u));
    };
    for (std::size_t i = 0; i < coords.size(); ++i) {
        const auto& c = coords[i];
        const double over_q = lookup.divide_by_q ? 1.0 / static_cast<double>(c[3]) : 1.0;
        out.u[i] = held(static_cast<double>(c[0]) * width * over_q);
        out.v[i] = held(static_cast<double>(c[1]) * height * over_q);
    }
}

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
    std::vector<std::vector<std::size_t>> of_pass;  ///< [pass][unit in its list]: lookup or none
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

/// What the lookups' alphas are in some of a mesh's triangles: [lookup][triangle from `first` on].
template <NumericModel M>
std::vector<std::vector<std::uint8_t>> known_alphas(const WindowMesh<M>& mesh,
                                                    const GroupAlpha<M>& group, std::size_t first,
                                                    std::size_t count) {
    static_assert(sizeof(MeshTriangle) % sizeof(std::uint32_t) == 0);
    const lanes::TriangleList list{mesh.triangles[first].vertex.data(),
                                   sizeof(MeshTriangle) / sizeof(std::uint32_t), count};
    std::vector<std::vector<std::uint8_t>> known(group.lookups.size());
    for (std::size_t l = 0; l < known.size(); ++l) {
        known[l].resize(count + lanes::widest);
        const TexelColumns& places = group.places[l];
        lanes::find_alphas(group.lookups[l].grid(), {places.u.data(), places.v.data()}, list,
                           known[l].data());
        for (std::size_t k = 0; k < count; ++k)
            if (!is_convex(group.lookups[l], mesh.triangles[first + k].flags)) known[l][k] = 0;
    }
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
        const auto known = known_alphas(mesh, group, first, count);
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
