#include "raster/frame_check.hpp"

#include <fmt/format.h>

#include "raster/transform.hpp"
#include "texunit/error.hpp"
#include "texunit/texture_format.hpp"

namespace twofold {
namespace {

template <class... Args>
void require(bool condition, fmt::format_string<Args...> text, Args&&... args) {
    if (!condition) throw Error(ExitCode::failure, fmt::format(text, std::forward<Args>(args)...));
}

bool size_in_range(int width, int height) {
    return width >= 0 && height >= 0 && width <= largest_edge && height <= largest_edge &&
           static_cast<std::size_t>(width) * static_cast<std::size_t>(height) <= largest_area;
}

void check_mesh(const Mesh& mesh, std::size_t i) {
    const std::size_t n = mesh.positions.size();
    const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
    require(fits(mesh.normals.size()), "mesh {}: {} normals for {} positions", i,
            mesh.normals.size(), n);
    for (const auto& set : mesh.texcoords)
        require(fits(set.size()), "mesh {}: {} texcoords for {} positions", i, set.size(), n);
    require(fits(mesh.secondary_colors.size()), "mesh {}: {} secondary colors for {} positions", i,
            mesh.secondary_colors.size(), n);
    require(fits(mesh.position_w.size()), "mesh {}: {} position_w for {} positions", i,
            mesh.position_w.size(), n);
    require(fits(mesh.colors.size()), "mesh {}: {} colors for {} positions", i, mesh.colors.size(),
            n);
    require(mesh.primitive != Primitive::triangles || mesh.indices.size() % 3 == 0,
            "mesh {}: {} indices are not triangles", i, mesh.indices.size());
    for (const std::uint32_t index : mesh.indices)
        require(index < n, "mesh {}: index {} names none of {} vertices", i, index, n);
}

void check_image(int width, int height, const Texels& texels, std::size_t i) {
    require(width > 0 && height > 0 && size_in_range(width, height),
            "texture {}: size {} x {} is out of range", i, width, height);
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (const auto* packed = std::get_if<PackedTexels>(&texels)) {
        const std::size_t wanted = bytes_of(packed->format, width, height);
        require(packed->bytes.size() == wanted, "texture {}: {} bytes for {} x {}, not {}", i,
                packed->bytes.size(), width, height, wanted);
        return;
    }
    const auto* bytes = std::get_if<std::vector<Rgba8>>(&texels);
    const std::size_t stored =
        bytes ? bytes->size() : std::get<std::vector<Rgba32f>>(texels).size();
    require(stored == size, "texture {}: {} texels for {} x {}", i, stored, width, height);
}

/// @source EXT_texture_compression_s3tc for compressed images
template <class Image>
void check_border(int border, const Image& image, std::size_t i) {
    require(border == 0 || border == 1, "texture {}: border {} is not 0 or 1", i, border);
    if (border == 0) return;
    require(image.width > 2 && image.height > 2,
            "texture {}: {} x {} has nothing inside its border", i, image.width, image.height);
    const auto* packed = std::get_if<PackedTexels>(&image.texels);
    require(!packed || !is_block_compressed(packed->format),
            "texture {}: compressed texels have no border", i);
}

/// The levels of a face or of the base: an image and its mipmaps.
template <class Image>
void check_levels(const Texture& texture, const Image& base, std::size_t i) {
    const auto check = [&](const auto& image) {
        check_image(image.width, image.height, image.texels, i);
        check_border(texture.border, image, i);
    };
    check(base);
    for (const TextureImage& image : base.mipmaps) check(image);
}

void check_texture(const Texture& texture, std::size_t i) {
    check_levels(texture, texture, i);
    require(texture.cube_faces.empty() || texture.cube_faces.size() == 5,
            "texture {}: a cube map has 5 further faces, not {}", i, texture.cube_faces.size());
    for (const TextureFace& face : texture.cube_faces) {
        check_levels(texture, face, i);
        require(face.width == texture.width && face.height == texture.width,
                "texture {}: a face of {} x {} in a cube map of {}", i, face.width, face.height,
                texture.width);
        require(face.mipmaps.size() == texture.mipmaps.size(),
                "texture {}: a face of {} mipmaps in a cube map of {}", i, face.mipmaps.size(),
                texture.mipmaps.size());
    }
}

void check_pass(const Pass& pass, std::size_t i, const Frame& frame) {
    require(pass.mesh < frame.meshes.size(), "pass {}: no mesh {}", i, pass.mesh);
    require(!pass.state.combiners || (pass.state.combiners->stages.size() >= 1 &&
                                      pass.state.combiners->stages.size() <= 8),
            "pass {}: {} combiner stages are not 1 to 8", i,
            pass.state.combiners ? pass.state.combiners->stages.size() : 0);
    for (const auto& unit : pass.state.units) {
        if (!unit) continue;
        require(!unit->texture || *unit->texture < frame.textures.size(), "pass {}: no texture {}",
                i, unit->texture.value_or(0));
        for (const int k : {unit->env.rgb_scale, unit->env.alpha_scale})
            require(k == 1 || k == 2 || k == 4, "pass {}: scale {} is not 1, 2 or 4", i, k);
    }
    if (needs_normals(pass.state))
        require(invertible(Mat3{pass.state.modelview}),
                "pass {}: modelview is singular, so it transforms no normals", i);
}

}  // namespace

void check_frame(const Frame& frame) {
    require(size_in_range(frame.width, frame.height), "picture: size {} x {} is out of range",
            frame.width, frame.height);
    require(frame.depth_bits == 16 || frame.depth_bits == 24,
            "picture: depth_bits {} is not 16 or 24", frame.depth_bits);
    require(!frame.initial_color || (frame.initial_color->width == frame.width &&
                                     frame.initial_color->height == frame.height),
            "picture: its initial colours have another size");
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) check_mesh(frame.meshes[i], i);
    for (std::size_t i = 0; i < frame.textures.size(); ++i) check_texture(frame.textures[i], i);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) check_pass(frame.passes[i], i, frame);
}

}  // namespace twofold
