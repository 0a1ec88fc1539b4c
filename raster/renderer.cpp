#include "raster/renderer.hpp"

#include "raster/fast.hpp"
#include "raster/reference.hpp"

namespace twofold {

std::string_view name_of(Pipeline pipeline) {
    return pipeline == Pipeline::fast ? "fast" : "reference";
}

std::optional<Pipeline> pipeline_named(std::string_view name) {
    for (const Pipeline p : {Pipeline::fast, Pipeline::reference})
        if (name == name_of(p)) return p;
    return std::nullopt;
}

Framebuffer render(const Frame& frame, Preset preset, const CustomSettings& custom,
                   const DrawOptions& options) {
    if (options.pipeline == Pipeline::reference) return render_reference(frame, preset, custom);
    return render_fast(frame, preset, custom, {options.threads, options.fuse});
}

}  // namespace twofold
