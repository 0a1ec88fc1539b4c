#include "study/sweep/work.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "raster/plan.hpp"
#include "raster/reference.hpp"

namespace twofold {
namespace {

struct TexelBytes {
    std::uint64_t operator()(const std::vector<Rgba8>& texels) const { return 4 * texels.size(); }
    std::uint64_t operator()(const std::vector<Rgba32f>& texels) const {
        return 16 * texels.size();
    }
    std::uint64_t operator()(const PackedTexels& texels) const { return texels.bytes.size(); }
};

template <class Image>
std::uint64_t image_bytes(const Image& image) {
    std::uint64_t bytes = std::visit(TexelBytes{}, image.texels);
    for (const TextureImage& level : image.mipmaps) bytes += std::visit(TexelBytes{}, level.texels);
    return bytes;
}

std::uint64_t bytes_of(const Texture& texture) {
    std::uint64_t bytes = image_bytes(texture);
    for (const TextureFace& face : texture.cube_faces) bytes += image_bytes(face);
    return bytes;
}

/// Clocks that the textures of one fragment keep a pipe of two units busy; a unit that mixes two
/// levels counts twice. At least 1.
std::uint64_t cycles_of(const PassState& state) {
    int lookups = 0;
    for (const auto& unit : state.units)
        if (unit) lookups += unit->mip_filter == MipFilter::linear ? 2 : 1;
    return static_cast<std::uint64_t>(std::max(1, (lookups + 1) / 2));
}

/// The fragments that reach pass `p`, by the pass alone: tests come after.
std::uint64_t fragments_of(const Frame& frame, std::size_t p, Preset preset,
                           const CustomSettings& custom) {
    const PassState& full = frame.passes[p].state;
    Frame alone;
    alone.width = frame.width;
    alone.height = frame.height;
    alone.meshes = {frame.meshes[frame.passes[p].mesh]};
    PassState bare;
    bare.modelview = full.modelview;
    bare.projection = full.projection;
    bare.viewport = full.viewport;
    bare.window_space = full.window_space;
    bare.cull = full.cull;
    bare.scissor = full.scissor;
    alone.passes = {{bare, 0}};
    return render_reference(alone, preset, custom).counters.fragments;
}

bool same_geometry(const Pass& a, const Pass& b) {
    const PassState &s = a.state, &t = b.state;
    return a.mesh == b.mesh && s.modelview == t.modelview && s.projection == t.projection &&
           s.viewport == t.viewport && s.window_space == t.window_space && s.cull == t.cull &&
           s.scissor == t.scissor;
}

/// The fragments of each pass.
std::vector<std::uint64_t> pass_fragments(const Frame& frame, Preset preset,
                                          const CustomSettings& custom) {
    std::vector<std::uint64_t> fragments;
    for (std::size_t p = 0; p < frame.passes.size(); ++p) {
        const bool known = p > 0 && same_geometry(frame.passes[p], frame.passes[p - 1]);
        fragments.push_back(known ? fragments.back() : fragments_of(frame, p, preset, custom));
    }
    return fragments;
}

}  // namespace

// Databases of cards also list boards of this name with 64 and 32 bits of memory.
const CardRates mx440_8x{"GeForce4 MX440 8x (NV18)",
                         275e6,
                         2,
                         2,
                         8.0e9,
                         "published data of the reference board: 275 MHz, 2 pipes of 2 texture "
                         "units (550 million pixels "
                         "and 1,100 million texels a second), 128 bits of DDR memory at 250 MHz"};

CustomSettings counted_settings(const CustomSettings& custom) {
    CustomSettings counted;
    counted.snap_bits = custom.snap_bits;
    counted.snap_bias = custom.snap_bias;
    counted.product_rounding = custom.product_rounding;
    return counted;
}

FrameWork with_textures_of(FrameWork work, const Frame& frame) {
    work.texture_bytes = work.texture_reads = 0;
    for (const Texture& texture : frame.textures) work.texture_bytes += bytes_of(texture);
    for (const Pass& pass : frame.passes)
        for (const auto& unit : normalized(frame, pass).units)
            if (unit && unit->texture)
                work.texture_reads += bytes_of(frame.textures[*unit->texture]);
    return work;
}

FrameWork work_of(const Frame& frame, Preset preset, const CustomSettings& custom) {
    const DrawCounters counters = render_reference(frame, preset, custom).counters;
    const auto fragments = pass_fragments(frame, preset, custom);
    FrameWork work;
    work.passes = static_cast<int>(frame.passes.size());
    work.fragments = counters.fragments;
    work.written = counters.written;
    work.alpha_failed = counters.alpha_failed;
    work.depth_failed = counters.depth_failed;
    for (std::size_t p = 0; p < frame.passes.size(); ++p) {
        const PassState state = normalized(frame, frame.passes[p]);
        work.vertices += frame.meshes[frame.passes[p].mesh].positions.size();
        work.texel_fetches += fragments[p] * static_cast<std::uint64_t>(texel_fetches(state));
        work.unit_cycles += fragments[p] * cycles_of(state);
        if (state.blend) work.blended += fragments[p];
    }
    return with_textures_of(work, frame);
}

CardPrediction predict(const FrameWork& work, const Frame& frame, const CardRates& rates) {
    const auto real = [](std::uint64_t count) { return static_cast<double>(count); };
    const double pixels = static_cast<double>(frame.width) * frame.height;
    const double color_bytes = frame.color_format == ColorFormat::rgba8888 ? 4.0 : 2.0;
    const double depth_bytes = frame.depth_bits == 16 ? 2.0 : 4.0;
    const double tested = real(work.fragments - work.alpha_failed);
    CardPrediction p;
    p.fill_seconds = real(work.unit_cycles) / (rates.clock * rates.pipes);
    p.memory_seconds = (pixels * (color_bytes + depth_bytes) + tested * depth_bytes +
                        real(work.written) * (color_bytes + depth_bytes) +
                        real(work.blended) * color_bytes + real(work.texture_reads)) /
                       rates.bandwidth;
    p.seconds = std::max(p.fill_seconds, p.memory_seconds);
    return p;
}

std::string model_text(const CardRates& rates) {
    return fmt::format(
        "A model, not a measurement: the least time in which a {} could draw the frame, the larger "
        "of fragments over the pipes' rate and bytes over the memory's, from {}. Clearing, depth, "
        "colour and every texture once a pass are counted. Vertices, the bus, the driver and the "
        "chip's early depth test are not: no rate of theirs is published that could be checked.",
        rates.name, rates.source);
}

}  // namespace twofold
