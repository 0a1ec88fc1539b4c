#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "raster/visible_surface.hpp"
#include "study/sweep/drawing.hpp"
#include "study/sweep/timing.hpp"
#include "study/sweep/work.hpp"

namespace twofold {

/// The work that cells have in common, kept as long as the next cell wants the same: cells that
/// share should follow one another.
class SharedWork {
  public:
    /// @param samples the most samples that any cell fits: the sums over the lights are formed once
    SharedWork(int samples, int threads, StepListener listen)
        : samples_(samples), threads_(threads), listen_(std::move(listen)) {}

    /// What the cell draws from, and what it took to make that.
    struct Inputs {
        CellInputs inputs;
        Seconds sampling;                     ///< the cell's share of the samples
        Seconds factoring;                    ///< all materials
        std::shared_ptr<const LitScene> lit;  ///< of `factored` cells
    };
    Inputs inputs_of(const Cell& cell);

    /// The exact picture; none for scenes with more than objects, of which it would show a part.
    std::shared_ptr<const Framebuffer> truth_of(const Cell& cell, const CellInputs& inputs);

    /// The cell's picture with nothing rounded: under ideal64 where it was drawn under its preset.
    std::shared_ptr<const Framebuffer> ideal_of(const Cell& cell, const CellInputs& inputs);

    /// The work of the cell's frame. Of `custom` cells that differ in what no work depends on, one
    /// is counted.
    FrameWork work_of(const Cell& cell, const Frame& frame);

    /// The pixels that see another surface on the cell's snap grid.
    std::vector<bool> outline_of(const Cell& cell, const CellInputs& inputs);

  private:
    /// A value, what it was made for and what it took.
    template <class T>
    struct Kept {
        std::string key;
        std::shared_ptr<const T> value;
        Seconds took;
    };
    template <class T, class Make>
    std::shared_ptr<const T> kept(Kept<T>& place, const std::string& key, Make make);

    std::shared_ptr<const SampledScene> samples_of(const Cell& cell, const CellKeys& keys);

    int samples_;
    int threads_;
    StepListener listen_;
    InputHashes files_;
    Kept<SceneAssets> assets_;
    Kept<SampledScene> sampled_;
    Kept<double> white_;
    Kept<LitScene> lit_;
    Kept<Framebuffer> truth_, ideal_;
    Kept<VisibleSurface> surface_;
    std::map<std::string, FrameWork> counted_;
};

}  // namespace twofold
