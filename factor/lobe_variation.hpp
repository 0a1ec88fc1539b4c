#pragma once
#include <cstddef>
#include <vector>

#include "factor/brdf.hpp"

namespace twofold {

/// How fast f(l, v; n) max(0, n.l) turns with the light: bounds of its first and second derivative
/// by the angle of l, the largest channel, as a table over n.v and the distance |l - r_v|. Entries
/// are the largest of finite differences over all directions at that distance or farther, times a
/// margin for what lies between.
class LobeVariation {
  public:
    struct Bounds {
        double first = 0.0, second = 0.0;
    };
    static constexpr std::size_t view_rows = 17;       ///< n.v = 0 to 1, evenly
    static constexpr std::size_t distance_steps = 40;  ///< close where the lobe is

    explicit LobeVariation(const Brdf& brdf, int threads);

    /// The row of the table that serves views with this n.v.
    static std::size_t row_of(double n_v);

    /// The bounds at a row for lights no nearer to r_v than distance_of(step).
    const Bounds& bounds(std::size_t row, std::size_t step) const {
        return table_[row * distance_steps + step];
    }
    static double distance_of(double position);

  private:
    std::vector<Bounds> table_;
};

}  // namespace twofold
