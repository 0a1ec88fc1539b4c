#include "scenes/point_lit_passes.hpp"

#include <utility>

namespace twofold {
namespace {

constexpr double guard = 0.875;

/// A direction in a frame about n whose axes turn without a jump unless n looks straight away from
/// the eye. Both in eye space. The maps are all but symmetric: which axes does not matter.
/// @source Frisvad, Building an Orthonormal Basis from a 3D Unit Vector Without Normalization, 2012
Vec3 in_surface_frame(Vec3 n, Vec3 d) {
    const double a = 1.0 / (n.z > -1.0 + 1e-9 ? 1.0 + n.z : 1e-9);
    const Vec3 x(1.0 - n.x * n.x * a, -n.x * n.y * a, -n.x);
    const Vec3 y(-n.x * n.y * a, 1.0 - n.y * n.y * a, -n.y);
    return {dot(x, d), dot(y, d), dot(n, d)};
}

/// A sum of two directions made unit; n where they cancel.
Vec3 halfway(Vec3 a, Vec3 b, Vec3 n) { return length(a + b) > 1e-9 ? normalized(a + b) : n; }

}  // namespace

VertexFactors factors_at(const Mesh& mesh, const Mat4& modelview, Vec3 light) {
    // The model is turned and scaled evenly: its matrix turns normals as well.
    const Mat3 turn(modelview);
    VertexFactors factors;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 n = normalized(turn * mesh.normals[i]);
        const Vec3 v = normalized(-Vec3(modelview * Vec4(mesh.positions[i], 1.0)));
        const auto coordinates = [&](Vec3 d) {
            return paraboloid_coordinates(in_surface_frame(n, d));
        };
        factors.light.push_back(coordinates(light));
        factors.half.push_back(coordinates(halfway(light, v, n)));
        factors.view.push_back(coordinates(v));
        factors.cosine.push_back(dot(n, light) > 0.0 ? dot(n, light) : 0.0);
    }
    return factors;
}

std::vector<Vec4> lit_colors(const VertexFactors& factors, Rgb color) {
    std::vector<Vec4> colors;
    for (const double cosine : factors.cosine) {
        const Rgb c = color * cosine;
        colors.emplace_back(c.x < 1.0 ? c.x : 1.0, c.y < 1.0 ? c.y : 1.0, c.z < 1.0 ? c.z : 1.0,
                            1.0);
    }
    return colors;
}

void add_vertex_pass(Frame& frame, const Mesh& mesh, const PassState& state,
                     std::vector<Vec4> first, std::vector<Vec4> second, std::vector<Vec4> colors) {
    Mesh drawn = mesh;
    drawn.texcoords = {};
    drawn.texcoords[0] = std::move(first);
    drawn.texcoords[1] = std::move(second);
    drawn.colors = std::move(colors);
    frame.passes.push_back({state, frame.meshes.size()});
    frame.meshes.push_back(std::move(drawn));
}

PassState drawn_over(PassState state, const Blend& blend) {
    state.depth_test = DepthTest{CompareFunc::equal, false};
    state.blend = blend;
    return state;
}

TextureUnitState unit_with(std::size_t texture) {
    TextureUnitState unit;
    unit.texture = texture;
    return unit;
}

void add_point_lit(Frame& frame, const Mesh& mesh, const PassState& first,
                   std::span<const PassLight> lights, int combiner_scale, std::size_t texture) {
    std::vector<Vec4> view;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        VertexFactors factors = factors_at(mesh, first.modelview, lights[k].direction);
        PassState state = k == 0 ? first : drawn_over(first, {BlendFactor::one, BlendFactor::one});
        state.units[0] = unit_with(texture);
        state.units[1] = unit_with(texture + 1);
        state.units[1]->env.rgb_scale = combiner_scale;
        std::vector<Vec4> colors = lit_colors(factors, lights[k].color);
        add_vertex_pass(frame, mesh, state, std::move(factors.light), std::move(factors.half),
                        std::move(colors));
        view = std::move(factors.view);
    }
    PassState state = drawn_over(first, {BlendFactor::zero, BlendFactor::src_color});
    state.units[0] = unit_with(texture);
    add_vertex_pass(frame, mesh, state, std::move(view), {}, {});
}

Vec4 paraboloid_coordinates(Vec3 d) {
    const double z = d.z > 0.0 ? d.z : 0.0;
    return {0.5 * (1.0 + z + guard * d.x), 0.5 * (1.0 + z + guard * d.y), 0.0, 1.0 + z};
}

}  // namespace twofold
