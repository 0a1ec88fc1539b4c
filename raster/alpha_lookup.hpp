#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "raster/alpha_lanes.hpp"
#include "raster/bind.hpp"
#include "raster/level_bounds.hpp"

/// The alphas of a unit's texture, so that those of a triangle's lookups can be bounded.
namespace twofold {

/// What is known of the alpha that a unit's lookups give all over a triangle; as find_alphas() of
/// alpha_lanes.hpp numbers it.
enum class AlphaKnown : std::uint8_t { nothing, zero, one };

/// An image as far as its alpha goes: lanes::AlphaGrid with its memory.
struct AlphaLevel {
    int width, height;
    int cell_bits;      ///< a cell has 2^cell_bits texels a side
    int columns, rows;  ///< cells
    std::vector<std::uint32_t> count;

    bool operator==(const AlphaLevel&) const = default;
};

/// A unit's lookup as far as its alpha goes.
struct AlphaLookup {
    std::size_t set;  ///< of coordinates
    bool in_texels, divide_by_q;
    std::vector<AlphaLevel> levels;
    std::vector<double> reach;  ///< level_reaches()

    /// Of a level, by the places in the base.
    lanes::AlphaGrid grid(std::size_t level) const {
        const AlphaLevel &l = levels[level], &base = levels[0];
        return {l.width,
                l.height,
                l.cell_bits,
                l.columns,
                l.count.data(),
                static_cast<float>(l.width) / static_cast<float>(base.width),
                static_cast<float>(l.height) / static_cast<float>(base.height)};
    }
    /// What coordinates are multiplied by to be places in the base.
    std::array<double, 2> scale() const {
        if (in_texels) return {1.0, 1.0};
        return {static_cast<double>(levels[0].width), static_cast<double>(levels[0].height)};
    }
    bool operator==(const AlphaLookup&) const = default;
};

/// Cells a side at most: the grids of four textures stay in the nearest caches.
inline constexpr int most_cells = 128;

/// Lookups whose alpha can be bounded: images clamped to their edge, combined by MODULATE of alpha
/// without a scale.
template <NumericModel M>
bool alpha_is_bounded(const BoundUnit<M>& unit) {
    const TextureUnitState& s = unit.state;
    return s.target != TextureTarget::cube_map && s.wrap_s == Wrap::clamp_to_edge &&
           s.wrap_t == Wrap::clamp_to_edge && s.env.mode == TexEnvMode::modulate &&
           unit.env.alpha_scale == 1;
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
AlphaLevel alpha_level(const M& m, const UploadedImage<M>& image) {
    int cell_bits = 0;
    while (std::max(image.width, image.height) >> cell_bits > most_cells) ++cell_bits;
    const int cell = 1 << cell_bits;
    const int columns = (image.width + cell - 1) / cell, rows = (image.height + cell - 1) / cell;
    AlphaLevel level{image.width, image.height, cell_bits, columns, rows, {}};
    const auto stride = static_cast<std::size_t>(columns) + 1;
    level.count.resize(stride * (static_cast<std::size_t>(rows) + 1));
    for (int j = 0; j < rows; ++j) {
        std::uint32_t left = 0;
        for (int i = 0; i < columns; ++i) {
            const AlphaKnown known = cell_alpha(m, image, cell, i, j);
            left += known == AlphaKnown::zero ? 1u : (known == AlphaKnown::one ? 1u << 16 : 0u);
            const std::size_t at =
                static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i);
            level.count[at + stride + 1] = level.count[at + 1] + left;
        }
    }
    return level;
}

template <NumericModel M>
AlphaLookup alpha_lookup(const M& m, const BoundUnit<M>& unit, std::size_t set) {
    AlphaLookup lookup{set,
                       unit.state.target == TextureTarget::rectangle,
                       unit.state.divide_by_q,
                       {},
                       level_reaches(unit)};
    for (const UploadedImage<M>& image : levels_read(unit))
        lookup.levels.push_back(alpha_level(m, image));
    return lookup;
}

/// Places of vertices in a base image, in texels; rounded to binary32, which the margins of
/// alpha_lanes.cpp allow for.
struct TexelColumns {
    std::vector<float> u, v;
};

template <class Real>
void place_texels(const AlphaLookup& lookup, const std::vector<std::array<Real, 4>>& coords,
                  TexelColumns& out) {
    out.u.resize(coords.size());
    out.v.resize(coords.size());
    const auto [width, height] = lookup.scale();
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

}  // namespace twofold
