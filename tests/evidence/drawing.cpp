#include "tests/evidence/drawing.hpp"

#include <algorithm>

#include "raster/reference.hpp"
#include "tests/evidence/surface_memory.hpp"
#include "texunit/error.hpp"

namespace twofold::evidence {
namespace {

/// A surface: what was last rendered, and the passes that have been added since. A frame holds no
/// depth buffer at its start, so with depth-tested passes it keeps all of them and is drawn again
/// from its beginning.
struct Target {
    Frame frame;
    ByteImage pixels;
    std::size_t passes_drawn = 0;
    std::map<std::string, std::size_t> generated;  ///< textures in the frame that do not change
};

bool tests_depth(const Frame& frame) {
    return std::any_of(frame.passes.begin(), frame.passes.end(),
                       [](const Pass& pass) { return pass.state.depth_test.has_value(); });
}

/// Starts the target's frame anew from `pixels`.
void restart(Target& target, ByteImage pixels) {
    target.frame.meshes.clear();
    target.frame.textures.clear();
    target.frame.passes.clear();
    target.frame.initial_color = pixels;
    target.pixels = std::move(pixels);
    target.passes_drawn = 0;
    target.generated.clear();
}

/// The target's pixels after everything that was added.
const ByteImage& contents(Target& target, Preset preset) {
    const Frame& frame = target.frame;
    if (target.passes_drawn == frame.passes.size()) return target.pixels;
    ByteImage drawn{frame.width, frame.height, render_reference(frame, preset).bytes};
    target.passes_drawn = frame.passes.size();
    if (tests_depth(frame))
        target.pixels = std::move(drawn);
    else
        restart(target, std::move(drawn));
    return target.pixels;
}

Target target_of(const SurfaceDescription& surface, const Description& description) {
    Target target;
    target.frame.width = surface.width;
    target.frame.height = surface.height;
    target.frame.color_format = surface.format;
    target.frame.depth_bits = description.depth_bits;
    target.frame.clear_depth = description.depth_clear;
    restart(target,
            as_stored(picture_of(surface.initial, surface.width, surface.height), surface.format));
    return target;
}

/// Everything that is drawn onto, and how textures and targets become passes.
class Canvas {
  public:
    Canvas(const Description& description, Preset preset)
        : description_(description), preset_(preset) {
        for (const auto& [name, surface] : description.surfaces)
            targets_.emplace(name, target_of(surface, description));
    }

    void execute(const Command& command) {
        Target& target = targets_.at(command.target);
        if (const auto* fill = std::get_if<FillCommand>(&command.what))
            write_memory(*fill, command.target, target);
        else
            add(std::get<DrawCommand>(command.what), target);
    }

    ByteImage framebuffer() { return contents(targets_.at(framebuffer_name), preset_); }

  private:
    void write_memory(const FillCommand& fill, const std::string& name, Target& target) {
        if (tests_depth(target.frame))
            throw Error(ExitCode::failure, description_.id + ": draws: '" + name +
                                               "' is written directly after depth-tested draws");
        const SurfaceDescription& surface = description_.surfaces.at(name);
        restart(target,
                as_stored(picture_of(fill.texels, surface.width, surface.height), surface.format));
    }

    void add(const DrawCommand& draw, Target& target) {
        const StateDescription& state = description_.states.at(draw.state);
        PassState pass = state.pass;
        // All surfaces are read before the pass is added, the target itself among them: a pass
        // reads what was there before it.
        for (std::size_t u = 0; u < max_units; ++u)
            if (!state.textures[u].empty()) bring_up_to_date(state.textures[u]);
        for (std::size_t u = 0; u < max_units; ++u)
            if (!state.textures[u].empty())
                pass.units[u]->texture = texture_in(state.textures[u], target);
        target.frame.passes.push_back({std::move(pass), target.frame.meshes.size()});
        target.frame.meshes.push_back(placed(draw.mesh, state.pass));
    }

    /// Draws what waits on the surface that a texture reads. That may clear the frame of the target
    /// itself, so it comes before any texture is put there.
    void bring_up_to_date(const std::string& texture) {
        if (const auto* view = std::get_if<SurfaceView>(&description_.textures.at(texture).source))
            contents(targets_.at(view->surface), preset_);
    }

    /// The index of the named texture in the target's frame, put there if it is not yet.
    std::size_t texture_in(const std::string& name, Target& target) {
        const auto known = target.generated.find(name);
        if (known != target.generated.end()) return known->second;
        const TextureDescription& texture = description_.textures.at(name);
        const std::size_t index = target.frame.textures.size();
        if (const auto* view = std::get_if<SurfaceView>(&texture.source)) {
            target.frame.textures.push_back(viewed(texture, view->surface));
        } else {
            target.frame.textures.push_back(generated(texture));
            target.generated.emplace(name, index);
        }
        return index;
    }

    Texture viewed(const TextureDescription& texture, const std::string& surface) {
        const ByteImage& pixels = contents(targets_.at(surface), preset_);
        PackedTexels texels = reread(memory_of(pixels, description_.surfaces.at(surface).format),
                                     texture.format, texture.width, texture.height);
        if (texture.swap_red_and_blue) texels = with_red_and_blue_swapped(std::move(texels));
        return {.width = texture.width, .height = texture.height, .texels = std::move(texels)};
    }

    static TextureImage level_of(const TextureDescription& texture, std::size_t level) {
        const TexelRule& rule = std::get<std::vector<TexelRule>>(texture.source)[level];
        const int width = std::max(1, texture.width >> level);
        const int height = std::max(1, texture.height >> level);
        ByteImage picture = picture_of(rule, width, height);
        if (texture.swap_red_and_blue) picture = with_red_and_blue_swapped(std::move(picture));
        return {width, height, stored(picture, texture.format)};
    }

    static Texture generated(const TextureDescription& texture) {
        TextureImage base = level_of(texture, 0);
        Texture result{
            .width = base.width, .height = base.height, .texels = std::move(base.texels)};
        const std::size_t levels = std::get<std::vector<TexelRule>>(texture.source).size();
        for (std::size_t level = 1; level < levels; ++level)
            result.mipmaps.push_back(level_of(texture, level));
        return result;
    }

    /// The mesh with window depth in 0..1 instead of steps of the depth buffer.
    Mesh placed(Mesh mesh, const PassState& state) const {
        if (state.window_space)
            for (Vec3& position : mesh.positions) position.z /= (1 << description_.depth_bits) - 1;
        return mesh;
    }

    const Description& description_;
    Preset preset_;
    std::map<std::string, Target> targets_;
};

}  // namespace

ByteImage draw(const Description& description, Preset preset) {
    Canvas canvas(description, preset);
    for (const Command& command : description.commands) canvas.execute(command);
    return canvas.framebuffer();
}

}  // namespace twofold::evidence
