#include "raster/fast.hpp"

#include <memory>

#include "raster/reference.hpp"

namespace twofold {

FastFrame prepare_fast(const Frame& frame, Preset preset, const CustomSettings& custom,
                       FastOptions) {
    const auto picture = std::make_shared<Framebuffer>();
    return {[=, &frame] { *picture = render_reference(frame, preset, custom); },
            [=] { return *picture; }};
}

Framebuffer render_fast(const Frame& frame, Preset preset, const CustomSettings& custom,
                        FastOptions options) {
    const FastFrame fast = prepare_fast(frame, preset, custom, options);
    fast.draw();
    return fast.picture();
}

}  // namespace twofold
