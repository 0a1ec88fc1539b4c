#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "raster/pass.hpp"
#include "texunit/numeric_model.hpp"

/// What the vector loops need to know of a pass to shade its fragments.
namespace twofold::lanes {

inline constexpr std::size_t lane_units = 2;  ///< texture units that vectors know

/// A texture with one texel of surroundings on its left and lower sides and two on the others, as
/// the wrap modes see them: every texel of a footprint is there without a question.
template <class Texel>
struct Image {
    const Texel* texels;
    int width, height;  ///< without surroundings
    int stride;         ///< texels from a row to the next
};

/// How fragments choose among levels: what select_levels() of texunit/mipmap.hpp reads.
struct LevelRule {
    double bias = 0.0;
    double magnified_to = 0.0;  ///< the level of detail up to which the base is magnified
    bool linear = false;        ///< the filter for minification
    bool nearest = false;       ///< the level next to the level of detail, else the one below it
    bool blends = false;        ///< that one with the next
};

template <class Texel>
struct Unit {
    Image<Texel> image;
    Wrap wrap_s, wrap_t;
    bool linear;  ///< where levels are chosen: for magnification
    bool divide_by_q;
    bool in_texels;
    bool replace;  ///< else MODULATE
    int rgb_scale, alpha_scale;
    /// What of s, t, r, q makes places in 1/256 texel, with LINEAR from the centre of texel (0, 0):
    /// the coordinate times `scale`, less q times `shift`.
    std::array<double, 4> scale, shift;
    /// What fragments choose from, `image` first, in one memory and with one stride; empty: there
    /// is no choice.
    std::span<const Image<Texel>> levels;
    LevelRule rule;
};

template <class Texel>
struct Shader {
    std::size_t units;
    std::array<Unit<Texel>, lane_units> unit;
};

/// How a preset of integers rounds. Its numbers have at most 24 bits and the filter's weights 16,
/// so that binary64 holds sums and products exactly until they are rounded.
struct Rounding {
    bool cuts_colors;     ///< colours are iterated as Coarse8's, else as Nv17's
    double weight_steps;  ///< the filter's weights are cut to 1 / weight_steps
    bool filters_once;    ///< the four weights at once, else along s, then along t
    double filter_half;   ///< added before the filter cuts
    struct Quotient {
        double add, factor;
        double identity;  ///< the b that leaves a alone; not 1.0 everywhere
    } product;            ///< a b becomes floor((a b + add) factor)
    double one;           ///< 1.0 in the texture units
    /// A colour c becomes c finish_factor, then floor(that + finish_half) if it rounds.
    double finish_factor, finish_half;
    bool finish_rounds;
};

struct RoundedShader : Shader<Color<double>> {
    Rounding rounding;
};

/// Whether a lookup blends four texels. Where only some of a unit's fragments do, the others'
/// weights are 0, which leaves the lesser texel.
template <class Texel>
bool reads_four(const Unit<Texel>& unit) {
    return unit.linear || (!unit.levels.empty() && unit.rule.linear);
}

}  // namespace twofold::lanes
