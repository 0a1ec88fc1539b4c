#pragma once
#include <optional>
#include <string_view>

#include "raster/framebuffer.hpp"
#include "raster/pass.hpp"
#include "texunit/custom.hpp"

/// Draws a frame by the pipeline that is asked for. Both give the same bytes.
namespace twofold {

/// `reference` is the specification and counts its work; `fast` is what a picture is drawn with.
enum class Pipeline { fast, reference };

std::string_view name_of(Pipeline pipeline);
std::optional<Pipeline> pipeline_named(std::string_view name);

struct DrawOptions {
    Pipeline pipeline = Pipeline::fast;
    int threads = 1;   ///< of the fast pipeline; all of the machine for 0
    bool fuse = true;  ///< of the fast pipeline: see FastOptions
};

/// @return counters are 0 unless the pipeline is `reference`
/// @throws as render_reference
Framebuffer render(const Frame& frame, Preset preset, const CustomSettings& custom = {},
                   const DrawOptions& options = {});

}  // namespace twofold
