#pragma once
#include "raster/lanes.hpp"
#include "texunit/coarse8.hpp"
#include "texunit/custom.hpp"

/// The presets whose integers vectors hold in binary64, as lanes::Rounding.
namespace twofold {

/// floor((x + add) factor) is x / one as the rounding says, for every product x of two numbers of
/// [0, one]. x / one and x / one + 1/2 lie on a grid of 1 / (2 one). The middle between two of its
/// places is taken, 1 / (4 one) > 2^-26 from each, so that the two roundings of the factor and of
/// the product, which together stray by less than 2^-28, never pass an integer.
inline lanes::Rounding::Quotient quotient_of(ProductRounding rounding, double one) {
    switch (rounding) {
        case ProductRounding::nearest:
            return {0.5 * one + 0.25, 1.0 / one, one};
        case ProductRounding::floor:
            return {0.25, 1.0 / one, one};
        case ProductRounding::shift:
            break;
    }
    const double parts = one / 255.0 * 256.0;
    return {0.0, 1.0 / parts, parts};
}

inline lanes::Rounding rounding_of(const Custom& m) {
    const CustomSettings& s = m.settings();
    const double one = m.one(), byte = one / 255.0;
    lanes::Rounding rule{};
    rule.weight_steps = 1 << s.filter_weight_bits;
    rule.filters_once = s.filter_rounding == FilterRounding::once;
    rule.filter_half = s.filter_rounding == FilterRounding::floor ? 0.0 : 0.5;
    rule.product = quotient_of(s.product_rounding, one);
    rule.one = one;
    rule.finish_factor = 1.0 / byte;
    rule.finish_rounds = s.framebuffer_bits != 0;
    rule.finish_half = 0.5;
    return rule;
}

inline lanes::Rounding rounding_of(const Coarse8&) {
    lanes::Rounding rule{};
    rule.cuts_colors = true;
    rule.weight_steps = 16.0;
    rule.filters_once = true;
    rule.product = quotient_of(ProductRounding::shift, 255.0);
    rule.one = 255.0;
    rule.finish_factor = 1.0;
    return rule;
}

/// Whether binary64 holds what the filter computes before it rounds: one step after the other
/// always, the four weights at once up to a width.
inline bool filter_is_exact(const lanes::Rounding& rule) {
    return !rule.filters_once || rule.one * rule.weight_steps * rule.weight_steps <= 0x1p53;
}

}  // namespace twofold
