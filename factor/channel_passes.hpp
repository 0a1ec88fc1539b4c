#pragma once
#include <array>
#include <vector>

#include "factor/channel_lanes.hpp"
#include "factor/row_pass.hpp"
#include "factor/system.hpp"

namespace twofold {

/// The passes of up to three channels over the rows that they share: every row's place in the maps
/// is read once for all of them. A channel has the bits that it has alone. `start` sets u of all.
class ChannelPasses {
  public:
    /// @param systems 1 to 3, all of one left side; they must live as long
    ChannelPasses(std::vector<const WeightedSystem*> systems, int threads);

    /// @param asked one a system; those that ask for nothing wait
    std::vector<PassResult> operator()(const std::vector<std::optional<RowPass>>& asked);

  private:
    struct Sums;                                ///< of a pass: over the columns, and |u|^2
    using Asked = std::vector<const RowPass*>;  ///< one a system; null of those that wait

    const LogMatrix& matrix() const { return systems_[0]->left().matrix; }
    Sums pass(PassKind kind, const Asked& asked);
    void set_unknowns(const Asked& asked);
    std::array<Vector, 3> scaled_columns(const Sums& sums) const;
    Sums row_pass(PassKind kind, const ChannelLanes& keep);
    std::vector<ChannelLanes> regulariser_pass(PassKind kind, const ChannelLanes& keep);

    std::vector<const WeightedSystem*> systems_;
    int threads_;
    std::vector<ChannelLanes> scale_;         ///< D
    std::vector<ChannelLanes> x_;             ///< D^-1 y, padded, of the pass
    std::vector<ChannelLanes> u_;             ///< a value a row, once a pass has set it
    std::vector<ChannelLanes> rest_columns_;  ///< sums of the regulariser's rows over the columns
};

}  // namespace twofold
