#pragma once
#include <functional>

#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"
#include "texunit/custom.hpp"

/// The fast pipeline: tiles, spans, vectors, threads and fused passes, with the bytes of
/// render_reference().
namespace twofold {

struct FastOptions {
    int threads = 1;   ///< all of the machine for 0
    bool fuse = true;  ///< passes over the same geometry share it, and skip what cannot be seen
};

/// A frame made ready for one preset: textures uploaded, memory for the picture at hand. `draw` may
/// be called any number of times; each draws the whole frame anew.
struct FastFrame {
    std::function<void()> draw;
    std::function<Framebuffer()> picture;  ///< of the last draw(); its counters are all 0
};

/// @param frame must outlive the result
/// @throws as render_reference
FastFrame prepare_fast(const Frame& frame, Preset preset, const CustomSettings& custom = {},
                       FastOptions options = {});

/// The picture of render_reference(), except for its counters, which are 0: only the reference
/// looks at every fragment.
/// @throws as render_reference
Framebuffer render_fast(const Frame& frame, Preset preset, const CustomSettings& custom = {},
                        FastOptions options = {});

}  // namespace twofold
