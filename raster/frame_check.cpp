#include "raster/frame_check.hpp"

#include <fmt/format.h>

#include "raster/transform.hpp"
#include "texunit/error.hpp"

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
    require(fits(mesh.texcoords.size()), "mesh {}: {} texcoords for {} positions", i,
            mesh.texcoords.size(), n);
    require(fits(mesh.colors.size()), "mesh {}: {} colors for {} positions", i, mesh.colors.size(),
            n);
    require(mesh.indices.size() % 3 == 0, "mesh {}: {} indices are not triangles", i,
            mesh.indices.size());
    for (const std::uint32_t index : mesh.indices)
        require(index < n, "mesh {}: index {} names none of {} vertices", i, index, n);
}

void check_texture(const Texture& texture, std::size_t i) {
    require(texture.width > 0 && texture.height > 0 && size_in_range(texture.width, texture.height),
            "texture {}: size {} x {} is out of range", i, texture.width, texture.height);
    const std::size_t stored =
        std::visit([](const auto& texels) { return texels.size(); }, texture.texels);
    const std::size_t size =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    require(stored == size, "texture {}: {} texels for {} x {}", i, stored, texture.width,
            texture.height);
}

void check_pass(const Pass& pass, std::size_t i, const Frame& frame) {
    require(pass.mesh < frame.meshes.size(), "pass {}: no mesh {}", i, pass.mesh);
    for (const auto& unit : pass.state.units) {
        if (!unit) continue;
        require(!unit->texture || *unit->texture < frame.textures.size(), "pass {}: no texture {}",
                i, unit->texture.value_or(0));
        const int k = unit->rgb_scale;
        require(k == 1 || k == 2 || k == 4, "pass {}: rgb_scale {} is not 1, 2 or 4", i, k);
    }
    if (needs_normals(pass.state))
        require(invertible(Mat3{pass.state.modelview}),
                "pass {}: modelview is singular, so it transforms no normals", i);
}

}  // namespace

void check_frame(const Frame& frame) {
    require(size_in_range(frame.width, frame.height), "picture: size {} x {} is out of range",
            frame.width, frame.height);
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) check_mesh(frame.meshes[i], i);
    for (std::size_t i = 0; i < frame.textures.size(); ++i) check_texture(frame.textures[i], i);
    for (std::size_t i = 0; i < frame.passes.size(); ++i) check_pass(frame.passes[i], i, frame);
}

}  // namespace twofold
