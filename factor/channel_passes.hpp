#pragma once
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
    struct Sums;  ///< of a pass: over the columns, and |u|^2

    Sums pass(PassKind kind, const std::vector<std::optional<RowPass>>& asked);
    std::vector<ChannelLanes> unknowns(const std::vector<std::optional<RowPass>>& asked) const;
    Sums sample_pass(PassKind kind, const std::vector<ChannelLanes>& x, const ChannelLanes& keep);
    void add_regulariser(Sums& sums, PassKind kind, const std::vector<ChannelLanes>& x,
                         const ChannelLanes& keep);

    std::vector<const WeightedSystem*> systems_;
    int threads_;
    std::vector<ChannelLanes> u_;  ///< a value a row, once a pass has set it
};

}  // namespace twofold
