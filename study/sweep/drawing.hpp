#pragma once
#include <functional>
#include <memory>

#include "raster/framebuffer.hpp"
#include "scenes/lighting.hpp"
#include "study/sweep/cell.hpp"

namespace twofold {

/// What a cell draws from: loaded and computed once, shared by cells.
struct CellInputs {
    std::shared_ptr<const SceneAssets> assets;
    std::shared_ptr<const SampledScene> sampled;
    double white = 1.0;
    std::shared_ptr<const FactoredMaterials> materials;  ///< of `factored` cells only
};

/// A cell ready to be drawn any number of times, by one thread.
struct Drawing {
    std::shared_ptr<const Frame> frame;  ///< what the rasterizer draws; none for `exact`
    std::function<void()> draw;          ///< all that a new view of the scene costs
    std::function<Framebuffer()> picture;
};

/// @param cell must outlive the result, as must inputs
/// @throws Error if the preset's chip does not take the scene, or the technique a material
Drawing prepare(const Cell& cell, const CellInputs& inputs);

/// The frame with another filter in all of its units.
/// @throws Error for trilinear if a side of a texture is not a power of two
Frame with_filter(Frame frame, TexelFilter filter);

}  // namespace twofold
