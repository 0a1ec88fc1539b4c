#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/alpha_outcome.hpp"
#include "raster/bind.hpp"
#include "raster/lane_image.hpp"
#include "raster/window_mesh.hpp"

/// What the alpha test will say of a whole triangle, found before it is drawn: the four passes of
/// the paper differ in nothing but the hemispheres whose texels have alpha 1, and most triangles lie
/// in one of them.
namespace twofold {

/// What is known of the alpha that a unit's lookups give all over a triangle.
enum class AlphaKnown : std::uint8_t { nothing, zero, one };

/// A unit's lookup as far as its alpha goes: the set of coordinates, and a grid of cells of the image
/// with how many below and left of each place hold alpha 0 only, or alpha 1 only.
struct AlphaLookup {
    struct Count {
        std::uint32_t zeros, ones;
        bool operator==(const Count&) const = default;
    };
    std::size_t set;
    int width, height;
    bool in_texels, divide_by_q;
    int cell_bits;      ///< a cell has 2^cell_bits texels a side
    int columns, rows;  ///< cells
    std::vector<Count> count;  ///< (columns + 1) x (rows + 1), rows bottom up

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
        AlphaLookup::Count left{0, 0};
        for (int i = 0; i < columns; ++i) {
            const AlphaKnown known = cell_alpha(m, image, cell, i, j);
            left.zeros += known == AlphaKnown::zero;
            left.ones += known == AlphaKnown::one;
            const std::size_t at = static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i);
            const AlphaLookup::Count& below = lookup.count[at + 1];
            lookup.count[at + stride + 1] = {below.zeros + left.zeros, below.ones + left.ones};
        }
    }
    return lookup;
}

/// A place in an image, in texels; rounded to binary32, which the margins below allow for.
struct TexelPlace {
    float u, v;
};

template <class Real>
TexelPlace texel_place(const AlphaLookup& lookup, const std::array<Real, 4>& coords) {
    const double over_q = lookup.divide_by_q ? 1.0 / static_cast<double>(coords[3]) : 1.0;
    const auto along = [&](Real s, int size) {
        const double u = static_cast<double>(s) * (lookup.in_texels ? 1 : size) * over_q;
        return static_cast<float>(u < -32768.0 ? -32768.0 : (u > 32768.0 ? 32768.0 : u));
    };
    return {along(coords[0], lookup.width), along(coords[1], lookup.height)};
}

/// The texels, first to last, that footprints between two places may read along one axis.
struct TexelBounds {
    int first, last;
};

inline TexelBounds texel_bounds(float a, float b, float c, int size) {
    const float low = std::min({a, b, c}), high = std::max({a, b, c});
    // Interpolated coordinates stray from the corners' hull by a few units in the last place of the
    // largest; in binary32 that is 2^-22 of it.
    const float margin = 0.75f + 4e-6f * std::max(std::fabs(low), std::fabs(high));
    const auto texel = [size](float u) {
        const int i = static_cast<int>(std::floor(u));
        return i < 0 ? 0 : (i >= size ? size - 1 : i);
    };
    return {texel(low - margin), texel(high + margin)};
}

/// What a lookup's alpha is all over a triangle with these corners.
inline AlphaKnown alpha_known(const AlphaLookup& lookup, const std::array<TexelPlace, 3>& p) {
    const TexelBounds x = texel_bounds(p[0].u, p[1].u, p[2].u, lookup.width);
    const TexelBounds y = texel_bounds(p[0].v, p[1].v, p[2].v, lookup.height);
    const int x0 = x.first >> lookup.cell_bits, x1 = (x.last >> lookup.cell_bits) + 1;
    const int y0 = y.first >> lookup.cell_bits, y1 = (y.last >> lookup.cell_bits) + 1;
    const auto at = [&](int i, int j) -> const AlphaLookup::Count& {
        return lookup.count[static_cast<std::size_t>(j * (lookup.columns + 1) + i)];
    };
    const auto &a = at(x0, y0), &b = at(x1, y0), &c = at(x0, y1), &d = at(x1, y1);
    const auto cells = static_cast<std::uint32_t>((x1 - x0) * (y1 - y0));
    if (d.zeros + a.zeros - b.zeros - c.zeros == cells) return AlphaKnown::zero;
    if (d.ones + a.ones - b.ones - c.ones == cells) return AlphaKnown::one;
    return AlphaKnown::nothing;
}

/// The outcome where the units' alphas are known: a zero makes the product 0, ones leave the
/// triangle's own alpha.
/// @param own  the alpha of all three corners, if it is the same
template <NumericModel M>
AlphaOutcome alpha_outcome(const BoundPass<M>& pass, std::span<const AlphaKnown> units,
                           const typename M::Channel* own) {
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
    return all_one && own ? decided(*own) : AlphaOutcome::open;
}

/// The alpha lookups of a group's passes, each once, and which of them a pass's units make.
template <NumericModel M>
struct GroupAlpha {
    static constexpr std::size_t none = ~std::size_t{0};
    std::vector<AlphaLookup> lookups;
    std::vector<std::vector<std::size_t>> of_pass;  ///< [pass][unit in its list]: lookup or none
    std::vector<std::vector<TexelPlace>> places;    ///< [lookup][vertex]
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
    if (lane_kind<M>() == LaneKind::none || !pass.state.alpha_test || !multiplies_alpha(pass))
        return;
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

template <NumericModel M>
const typename M::Channel* common_alpha(const WindowMesh<M>& mesh, const MeshTriangle& t) {
    const auto alpha = [&](std::size_t k) -> const typename M::Channel& {
        return mesh.vertices[mesh.flat ? t.provoking : t.vertex[k]].color[3];
    };
    return alpha(0) == alpha(1) && alpha(1) == alpha(2) ? &alpha(0) : nullptr;
}

/// Finds what each pass's alpha test does with each triangle of the mesh.
/// @param passes  the group's, in the order of add_pass
template <NumericModel M>
void find_outcomes(const WindowMesh<M>& mesh, const std::vector<const BoundPass<M>*>& passes,
                   GroupAlpha<M>& group) {
    if (group.lookups.empty()) return;
    group.places.resize(group.lookups.size());
    for (std::size_t l = 0; l < group.lookups.size(); ++l) {
        const auto& coords = mesh.coords[group.lookups[l].set];
        group.places[l].resize(coords.size());
        for (std::size_t v = 0; v < coords.size(); ++v)
            group.places[l][v] = texel_place(group.lookups[l], coords[v]);
    }
    for (std::size_t p = 0; p < passes.size(); ++p)
        if (!group.of_pass[p].empty()) group.outcomes[p].resize(mesh.triangles.size());
    std::vector<AlphaKnown> known(group.lookups.size());
    std::array<AlphaKnown, max_units> units{};
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const MeshTriangle& t = mesh.triangles[k];
        for (std::size_t l = 0; l < known.size(); ++l) {
            const auto& place = group.places[l];
            known[l] = is_convex(group.lookups[l], t.flags)
                           ? alpha_known(group.lookups[l], {place[t.vertex[0]], place[t.vertex[1]],
                                                            place[t.vertex[2]]})
                           : AlphaKnown::nothing;
        }
        const auto* const own = common_alpha(mesh, t);
        for (std::size_t p = 0; p < passes.size(); ++p) {
            const auto& of_pass = group.of_pass[p];
            if (of_pass.empty()) continue;
            for (std::size_t u = 0; u < of_pass.size(); ++u)
                units[u] = of_pass[u] == GroupAlpha<M>::none ? AlphaKnown::nothing : known[of_pass[u]];
            group.outcomes[p][k] =
                alpha_outcome(*passes[p], std::span(units.data(), of_pass.size()), own);
        }
    }
}

}  // namespace twofold
