#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "factor/solver.hpp"

namespace twofold {

/// Most factors of a product: t1, t2 and g.
inline constexpr std::size_t max_factors = 3;

/// Where the unknowns of each factor begin, and past the last one their number.
using FactorStarts = std::vector<std::size_t>;

/// A vector that is 0 but at some unknowns.
struct SparseVector {
    std::vector<std::uint32_t> index;
    Vector value;
};

/// The freedom that samples of a product leave: among the texels that rows connect, one factor may
/// be multiplied by what another is divided by. A system falls into components, each with a gauge
/// of its own. Unknowns that no row touches are counted to the first of them.
class Gauge {
  public:
    /// @param row_weight rows of weight 0 connect nothing
    /// @tparam Matrix SparseMatrix or LogMatrix
    template <class Matrix>
    Gauge(const Matrix& rows, std::span<const double> row_weight, const FactorStarts& starts);

    /// Components that hold unknowns of two factors or more.
    std::size_t components() const { return parts_.size(); }

    /// Takes the first two factors of each component to one mean, and a third to mean 0, without
    /// changing their sum at any sample.
    Vector balanced(Vector x) const;

    /// The directions D z of the freedom in unknowns D x, orthonormal: one a component with two
    /// factors, two with three. @param column_scale D
    std::vector<SparseVector> null_vectors(const Vector& column_scale) const;

  private:
    /// The unknowns of a component, factor by factor, ascending.
    using Part = std::array<std::vector<std::uint32_t>, max_factors>;
    std::vector<Part> parts_;
};

/// y without its parts along orthonormal directions.
Vector without(Vector y, const std::vector<SparseVector>& directions);

}  // namespace twofold
