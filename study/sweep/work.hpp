#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"
#include "texunit/custom.hpp"
#include "texunit/preset.hpp"

namespace twofold {

/// What the rasterizer does for one frame, counted by the reference.
struct FrameWork {
    int passes = 0;
    std::uint64_t texture_bytes = 0;  ///< of all images as the preset stores them
    std::uint64_t texture_reads = 0;  ///< bytes, if a pass reads each of its textures once
    std::uint64_t fragments = 0, written = 0, alpha_failed = 0, depth_failed = 0;
    std::uint64_t vertices = 0;       ///< of all passes
    std::uint64_t texel_fetches = 0;  ///< if no fragment is left out and nothing is cached
    std::uint64_t unit_cycles = 0;    ///< fragments times the texture cycles that each needs
    std::uint64_t blended = 0;        ///< fragments of passes that read the framebuffer's colour
};

/// The settings of `custom` with only what decides coverage and the alpha test of factored objects:
/// frames that differ in the rest do the same work.
CustomSettings counted_settings(const CustomSettings& custom);

/// @throws as render_reference
FrameWork work_of(const Frame& frame, Preset preset, const CustomSettings& custom);

/// The same work with the textures of another frame, which may store other texels.
FrameWork with_textures_of(FrameWork work, const Frame& frame);

/// What a card's published rates are, and where they are published.
struct CardRates {
    const char* name;
    double clock;      ///< core, Hz
    int pipes;         ///< pixels a clock
    int units;         ///< texture units a pipe
    double bandwidth;  ///< bytes a second
    const char* source;
};

/// The paper's card. Boards with narrower memory than the reference's were sold under its name.
extern const CardRates mx440_8x;

/// A model, no measurement: the least time in which the card can do a frame's work.
struct CardPrediction {
    double fill_seconds = 0.0;    ///< fragments through the pipes
    double memory_seconds = 0.0;  ///< colour, depth and each texture once a pass over the bus
    double seconds = 0.0;         ///< the larger: both go on side by side
};

CardPrediction predict(const FrameWork& work, const Frame& frame, const CardRates& rates);

/// What the model counts and leaves out, for whoever reads its figures.
std::string model_text(const CardRates& rates);

}  // namespace twofold
