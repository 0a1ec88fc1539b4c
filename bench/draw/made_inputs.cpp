#include <algorithm>
#include <glm/matrix.hpp>

#include "bench/draw/inputs.hpp"
#include "scenes/camera.hpp"
#include "scenes/mesh_shapes.hpp"
#include "texunit/paraboloid.hpp"

namespace twofold::bench {
namespace {

constexpr int largest_texture = 256;
constexpr Vec4 scale_color{0.9, 0.8, 0.7, 1.0};

/// A smooth factor with some detail: a square of 4 x 4 texels is lighter than the next.
Rgba8 factor_texel(Vec3 d, int x, int y, bool opaque) {
    const double detail = ((x ^ y) & 4) == 0 ? 40.0 : 0.0;
    const auto byte = [&](double c) {
        return static_cast<std::uint8_t>(140.0 + 70.0 * c + detail);
    };
    return {byte(d.x), byte(d.y), byte(d.z), static_cast<std::uint8_t>(opaque ? 255 : 0)};
}

/// Three texels are left around the disc.
double guard_of(int edge) { return (edge - 6.0) / edge; }

Texture factor_texture(Face face, int edge) {
    const double guard = guard_of(edge);
    std::vector<Rgba8> texels;
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            texels.push_back(factor_texel(texel_direction({face, x, y}, edge, guard), x, y,
                                          texel_is_opaque(x, y, edge, guard)));
    return {edge, edge, std::move(texels)};
}

/// Both units' coordinates, the second turned by 45 degrees.
void add_coordinates(Mesh& mesh) {
    mesh.texcoords = {};
    for (const Vec3& p : mesh.positions) {
        mesh.texcoords[0].emplace_back(0.5 + 0.45 * p.x, 0.5 + 0.45 * p.y, 0.0, 1.0);
        mesh.texcoords[1].emplace_back(0.5 + 0.3 * (p.x - p.y), 0.5 + 0.3 * (p.x + p.y), 0.0, 1.0);
    }
    mesh.colors.assign(mesh.positions.size(), scale_color);
}

/// In perspective: w varies by 3 to 1 across the picture, which the quad fills.
Vec4 quad_corner(Vec3 p) {
    const double w = 1.0 + 0.5 * p.x;
    return {p.x * w, p.y * w, 0.0, w};
}

}  // namespace

Inputs make_inputs(const std::string& drawing, int squares, int size) {
    const Camera camera{{1.4, 1.3, 3.2}, Vec3{0.0}, {0.0, 1.0, 0.0}, 36.5, 1.0, 8.0};
    Inputs in;
    in.drawing = drawing;
    in.size = size;
    in.mesh = squares == 0 ? quad_mesh() : sphere_mesh(squares);
    add_coordinates(in.mesh);
    if (squares == 0)
        for (const Vec3& p : in.mesh.positions) in.clip.push_back(quad_corner(p));
    in.modelview = view_matrix(camera);
    in.projection = projection_matrix(camera, 1.0);
    const int edge = std::clamp(size, 16, largest_texture);
    for (std::size_t f = 0; f < 2; ++f) {
        const Face face = f == 0 ? Face::front : Face::back;
        const Mat4 to_map =
            paraboloid_matrix(face, guard_of(edge)) * Mat4{glm::transpose(Mat3{in.modelview})};
        for (std::size_t u = 0; u < 2; ++u) {
            in.textures[u][f] = factor_texture(face, edge);
            in.texture_matrices[u][f] = to_map;
        }
    }
    return in;
}

}  // namespace twofold::bench
