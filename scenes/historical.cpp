#include "scenes/historical.hpp"

#include <glm/matrix.hpp>

#include "scenes/camera.hpp"

namespace twofold {
namespace {

constexpr double guard = 0.875;

/// What the passes need of each vertex.
struct VertexFactors {
    std::vector<Vec4> light, half, view;  ///< texture coordinates
    std::vector<double> cosine;           ///< max(0, n.l)
};

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

/// Draws of one object.
struct HistoricalPasses {
    Frame& frame;
    const Mesh& mesh;
    PassState state;

    void add(const PassState& pass, std::vector<Vec4> first, std::vector<Vec4> second,
             std::vector<Vec4> colors) {
        Mesh drawn = mesh;
        drawn.texcoords = {};
        drawn.texcoords[0] = std::move(first);
        drawn.texcoords[1] = std::move(second);
        drawn.colors = std::move(colors);
        frame.passes.push_back({pass, frame.meshes.size()});
        frame.meshes.push_back(std::move(drawn));
    }
};

/// A later pass over the same surface.
PassState over(PassState state, Blend blend) {
    state.depth_test = DepthTest{CompareFunc::equal, false};
    state.blend = blend;
    return state;
}

TextureUnitState unit_with(std::size_t texture) {
    TextureUnitState unit;
    unit.texture = texture;
    return unit;
}

std::vector<Vec4> colors_of(const VertexFactors& factors, Rgb scale) {
    std::vector<Vec4> colors;
    for (const double cosine : factors.cosine) {
        const Rgb c = scale * cosine;
        colors.emplace_back(c.x < 1.0 ? c.x : 1.0, c.y < 1.0 ? c.y : 1.0, c.z < 1.0 ? c.z : 1.0,
                            1.0);
    }
    return colors;
}

void add_product(HistoricalPasses& passes, const VertexFactors& factors, Rgb scale,
                 std::size_t texture) {
    int k = 1;
    while (k < 4 && k < max_component(scale)) k *= 2;
    PassState state = passes.state;
    state.units[0] = unit_with(texture);
    state.units[1] = unit_with(texture + 1);
    state.units[1]->env.rgb_scale = k;
    passes.add(state, factors.light, factors.half,
               colors_of(factors, scale / static_cast<double>(k)));
    state = over(passes.state, Blend{BlendFactor::zero, BlendFactor::src_color});
    state.units[0] = unit_with(texture);
    passes.add(state, factors.view, {}, {});
}

void add_highlight(HistoricalPasses& passes, const VertexFactors& factors, Rgb scale,
                   std::size_t texture, bool first) {
    PassState state =
        first ? passes.state : over(passes.state, Blend{BlendFactor::one, BlendFactor::one});
    state.units[0] = unit_with(texture);
    passes.add(state, factors.half, {}, colors_of(factors, scale));
}

PassState first_state(const HistoricalObject& object, const Frame& frame, const Camera& camera) {
    const FactoredObject placed{object.mesh, "", object.translation, object.scale,
                                object.rotate_y_degrees};
    PassState state;
    state.modelview = view_matrix(camera) * model_matrix(placed);
    state.projection = projection_matrix(camera, static_cast<double>(frame.width) / frame.height);
    state.cull = CullFace::back;
    state.depth_test = DepthTest{CompareFunc::lequal, true};
    return state;
}

}  // namespace

Vec4 paraboloid_coordinates(Vec3 d) {
    const double z = d.z > 0.0 ? d.z : 0.0;
    return {0.5 * (1.0 + z + guard * d.x), 0.5 * (1.0 + z + guard * d.y), 0.0, 1.0 + z};
}

void add_historical(Frame& frame, const HistoricalObject& object, const Mesh& mesh,
                    const FactorSet& set, const Camera& camera) {
    HistoricalPasses passes{frame, mesh, first_state(object, frame, camera)};
    const Vec3 light = Mat3(view_matrix(camera)) * normalized(object.light);
    const VertexFactors factors = factors_at(mesh, passes.state.modelview, light);
    const std::size_t texture = frame.textures.size();
    frame.textures.insert(frame.textures.end(), set.textures.begin(), set.textures.end());
    const bool product = set.kind != FactorSet::Kind::highlight;
    if (product)
        add_product(passes, factors, object.diffuse * set.alpha * object.irradiance, texture);
    if (set.kind != FactorSet::Kind::product)
        add_highlight(passes, factors, object.specular * object.irradiance,
                      texture + (product ? 2 : 0), !product);
}

}  // namespace twofold
