#pragma once
#include <span>
#include <vector>

#include "factor/sparse_matrix.hpp"
#include "factor/vector_arithmetic.hpp"

/// Sums of signed products, M(x, y) ~ sum over the terms of u_j(x) v_j(y), in least squares of the
/// absolute error over the pairs that exist. On a whole matrix that is its truncated SVD; where
/// pairs are missing (n.r <= 0) there is no SVD, and alternating least squares takes its place:
/// with the v_j fixed the u_j solve a linear system, and the other way round.
/// @source seed paper, equation 2; Fournier 1995; Kautz & McCool 1999
namespace twofold {

/// One argument of the products.
struct BilinearSide {
    SparseMatrix footprint;    ///< a row a sample: what it reads of this side's unknowns
    SparseMatrix regulariser;  ///< rows that should vanish; may have none
};

/// @param weight row weights, one a sample; 0 leaves a sample out
struct BilinearProblem {
    const BilinearSide& first;
    const BilinearSide& second;
    std::span<const double> values;
    std::span<const double> weight;
};

/// The terms of one side, one vector of unknowns each.
using TermVectors = std::vector<Vector>;

struct SignedSum {
    TermVectors first;        ///< u_j times the singular value
    TermVectors second;       ///< v_j, orthonormal
    Vector objective;         ///< rms of the weighted errors: [0] of 0, then after each round
    bool stationary = false;  ///< the last round lowered the objective by less than 1e-5 of itself
};

/// Fits `terms` products, each first alone to what the earlier ones leave, then all together in at
/// most `rounds` rounds of the two sides. The result is ordered as an SVD is: the v_j orthonormal,
/// the u_j orthogonal with falling lengths, each v_j with a sum >= 0.
SignedSum fit_signed_sum(const BilinearProblem& problem, std::size_t terms, int rounds,
                         int threads);

/// The same sum of products with the columns of an SVD.
void make_orthogonal(TermVectors& first, TermVectors& second);

}  // namespace twofold
