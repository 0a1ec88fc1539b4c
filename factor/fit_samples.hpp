#pragma once
#include <array>
#include <cstddef>

#include "factor/samples.hpp"
#include "factor/system.hpp"

namespace twofold {

/// The samples of a fit as its system takes them: where each lies in the maps (factor/
/// sample_rows.hpp), and the radiance of each channel by itself. That is 40 bytes a sample where
/// directions and radiance are 72, and nothing is rounded further: samples can be made, added and
/// dropped in batches, and give the bits that they give together. They end in another order than
/// they came in (factor/row_order.hpp), that of their places in the maps.
class FitSamples {
  public:
    /// @param settings those of the fit
    /// @param count samples that will be added in all
    /// @throws Error if a setting is out of range
    FitSamples(const FactorSettings& settings, std::size_t count);

    /// @throws Error if there are more pairs than radiances or fewer, or more than `count` in all
    void add(const LightingSamples& batch, int threads);

    const FactorSettings& settings() const { return settings_; }
    /// Of what was added so far, by channel, in any order.
    const std::array<Vector, 3>& radiance() const { return radiance_; }

    /// What the fit is made of, moved out.
    struct Parts {
        LogRows left;
        std::array<Vector, 3> radiance;  ///< by channel, with room for the rows of the regulariser
    };
    /// @throws Error if fewer than `count` samples were added
    Parts parts(int threads = 1) &&;

  private:
    void order_to(std::size_t end, int threads);  ///< the rows from ordered_ on

    FactorSettings settings_;
    std::size_t count_;
    std::size_t ordered_ = 0;  ///< rows that are in order
    SparseMatrix regulariser_;
    SampleRows at_;
    std::array<Vector, 3> radiance_;
};

}  // namespace twofold
