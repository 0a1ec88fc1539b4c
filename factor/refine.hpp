#pragma once
#include <span>
#include <vector>

#include "factor/system.hpp"

/// The fit of what the hardware shows. The log fit interpolates logarithms, the texture unit
/// interpolates texels; and a sum of products has no logarithm to be linear in. From the log fit's
/// texels on, this fits P_i = sum over the terms of t1 t2 g, each factor filtered linearly, to L_i
/// itself, by Gauss-Newton on the logarithms of the texels: they stay positive by themselves, a
/// step moves all factors of all terms at once (alternating over the maps has the same fixed points
/// and gets there later), and the smoothness rows stay what they are.
namespace twofold {

/// The sample rows factor by factor, and the rows of the regulariser, of one term.
struct ProductRows {
    std::vector<SparseMatrix> factors;  ///< over the unknowns of t1, t2 and, if there is one, g
    SparseMatrix regulariser;           ///< over all unknowns of a term
    MapShape shape;
    std::size_t unknowns() const { return regulariser.columns(); }
};

ProductRows product_rows(const LogRows& rows);

/// What the products are fitted to: sum of weight_i^2 (P_i - target_i)^2 is made small.
struct ProductTarget {
    Vector radiance;
    Vector weight;  ///< 0 for left-out samples
};

/// The treated radiance of a channel with weights (L / mean)^exponent / L: at exponent 1 every
/// error counts as much as it shows, at 0 each counts relative to L, as in the log fit.
ProductTarget product_target(const ChannelRows& rows, std::size_t samples, double exponent);

/// The start of a sum of `terms` products that together are the one product: t2 is divided among
/// them by weights that sum to 1, each largest about one of the bright directions of t2.
/// @param x logarithms of one term @return those of all terms, one after another
Vector divided_terms(const Vector& x, std::size_t terms, const MapShape& shape);

struct Refined {
    Vector x;  ///< logarithms of all terms
    std::vector<double>
        objective{};  ///< rms of the weighted errors and the regulariser, [0] before
};

/// @param x logarithms of the terms, one after another
/// @param steps Gauss-Newton steps at most; a step that does not lower the objective is halved, and
///        after four halvings the fit ends
Refined refine(const ProductRows& rows, const ProductTarget& target, Vector x, int steps,
               int threads);

}  // namespace twofold
