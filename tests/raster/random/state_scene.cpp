#include "tests/raster/random/state_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/frame.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/texture_images.hpp"
#include "tests/raster/builders.hpp"
#include "tests/raster/random/random_parts.hpp"
#include "texunit/atomic_file.hpp"
#include "texunit/image_file.hpp"

namespace twofold::test {
namespace {

std::string mesh_name(std::size_t i) { return fmt::format("mesh{:03}", i); }
std::string texture_name(std::size_t i) { return fmt::format("texture{:03}", i); }

PackedTexels packed(const std::vector<Rgba8>& texels) {
    PackedTexels result;
    for (const Rgba8 t : texels) result.bytes.insert(result.bytes.end(), {t.b, t.g, t.r, t.a});
    return result;
}

PackedTexels packed(const std::vector<Rgba32f>& texels) { return packed(as_bytes(texels)); }

PackedTexels packed(const PackedTexels& texels) { return texels; }

Vec4 vec4_of(const Rgba32f& t) { return {t[0], t[1], t[2], t[3]}; }

/// The checkerboard that floats were made of, if they were.
std::optional<Checkerboard> checkerboard_in(int width, int height, const Texels& texels) {
    const auto* floats = std::get_if<std::vector<Rgba32f>>(&texels);
    if (floats == nullptr) return std::nullopt;
    const auto other = std::find_if(floats->begin(), floats->end(),
                                    [&](const Rgba32f& t) { return t != floats->front(); });
    Checkerboard board{width, height, 1, vec4_of(floats->front()), vec4_of(floats->front())};
    if (other != floats->end()) board.second = vec4_of(*other);
    for (board.cell = 1; board.cell <= 3; ++board.cell)
        if (std::get<std::vector<Rgba32f>>(checkerboard(board).texels) == *floats) return board;
    return std::nullopt;
}

TextureImageSpec image_spec(int width, int height, const Texels& texels,
                            std::vector<std::string>& notes) {
    if (const auto board = checkerboard_in(width, height, texels)) return *board;
    if (std::holds_alternative<std::vector<Rgba32f>>(texels))
        notes.emplace_back(floats_became_bytes);
    return InlineTexels{width, height, std::visit([](const auto& t) { return packed(t); }, texels)};
}

TextureSpec texture_spec(const Texture& texture, std::vector<std::string>& notes) {
    TextureSpec spec;
    spec.images.push_back(image_spec(texture.width, texture.height, texture.texels, notes));
    for (const TextureFace& face : texture.cube_faces)
        spec.images.push_back(image_spec(face.width, face.height, face.texels, notes));
    spec.base_format = texture.base_format;
    spec.border = texture.border;
    spec.mipmaps = texture.mipmaps.empty() ? Mipmaps::none : Mipmaps::box;
    return spec;
}

ImageSpec image_of(const Frame& frame) {
    return {frame.width,        frame.height,     Rgb{frame.clear_color},
            frame.color_format, frame.depth_bits, frame.clear_depth};
}

ScenePass scene_pass(const Pass& pass) {
    ScenePass result{mesh_name(pass.mesh), {}, true, pass.state};
    for (std::size_t u = 0; u < max_units; ++u)
        if (const auto& unit = pass.state.units[u]; unit && unit->texture)
            result.textures[u] = texture_name(*unit->texture);
    return result;
}

/// A scene clears to alpha 0 and has no first picture.
bool needs_background(const Frame& frame) {
    return frame.initial_color.has_value() || frame.clear_color.w != 0.0;
}

ByteImage background_of(const Frame& frame) {
    if (frame.initial_color) return *frame.initial_color;
    const auto size =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    return {frame.width, frame.height, std::vector<Rgba8>(size, byte_color(frame.clear_color))};
}

/// Draws the background's texels, one a pixel, and touches no depth.
ScenePass background_pass() {
    ScenePass pass{"background", {"background"}, true, {}};
    pass.state.window_space = true;
    TextureUnitState unit;
    unit.target = TextureTarget::rectangle;
    unit.min_filter = unit.mag_filter = Filter::nearest;
    unit.env.mode = TexEnvMode::replace;
    pass.state.units[0] = unit;
    return pass;
}

/// Beyond the window on every side, so that no rule of edges counts.
Mesh background_mesh(int width, int height) {
    Mesh mesh = rectangle(-1, -1, width + 1, height + 1);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.texcoords[0][i] = {mesh.positions[i].x, height - mesh.positions[i].y, 0.0, 1.0};
    return mesh;
}

/// Whether a texel that replaces a pixel is the byte that it was in the file.
bool keeps_bytes(const RandomState& state) {
    const CustomSettings& s = state.custom;
    return state.preset != Preset::custom ||
           (s.texel_bits == 8 && (s.framebuffer_bits == 0 || s.framebuffer_bits == 8));
}

void add_background(const Frame& frame, const std::string& file, StateScene& result) {
    result.background = background_of(frame);
    result.notes.push_back("what the picture holds at the start is a first pass");
    result.scene.meshes["background"] = InlineMesh{background_mesh(frame.width, frame.height)};
    result.scene.textures["background"] = {{TextureFile{file}}, BaseFormat::rgba, Mipmaps::none};
    result.scene.passes.push_back(background_pass());
}

}  // namespace

StateScene scene_of(const RandomState& state, const std::string& background_file) {
    const Frame& frame = state.frame;
    StateScene result;
    result.scene.title =
        fmt::format("a random state, drawn with {} threads, passes {}", state.options.threads,
                    state.options.fuse ? "fused" : "one by one");
    result.scene.image = image_of(frame);
    result.scene.presets = {state.preset};
    result.scene.custom = state.custom;
    for (std::size_t i = 0; i < frame.meshes.size(); ++i)
        result.scene.meshes[mesh_name(i)] = InlineMesh{frame.meshes[i]};
    for (std::size_t i = 0; i < frame.textures.size(); ++i)
        result.scene.textures[texture_name(i)] = texture_spec(frame.textures[i], result.notes);
    if (needs_background(frame)) {
        add_background(frame, background_file, result);
        if (!keeps_bytes(state)) result.notes.emplace_back(background_is_rounded);
    }
    for (const Pass& pass : frame.passes) result.scene.passes.push_back(scene_pass(pass));
    return result;
}

std::vector<std::string> write_state(const RandomState& state, const std::filesystem::path& folder,
                                     const std::string& name) {
    const std::string background = name + "-background.png";
    const StateScene made = scene_of(state, background);
    std::filesystem::create_directories(folder);
    write_file_atomically(folder / (name + ".json"), scene_to_json(made.scene));
    if (made.background) write_file_atomically(folder / background, encode_png(*made.background));
    return made.notes;
}

RandomState read_state(const RandomState& written, const std::filesystem::path& path) {
    const Scene scene = read_scene(path);
    RandomState state = written;
    state.custom = scene.custom;
    state.frame = make_frame(scene, load_assets(scene), {}, state.preset);
    return state;
}

}  // namespace twofold::test
