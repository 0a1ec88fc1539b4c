#include "scenes/historical.hpp"

#include <utility>

#include "scenes/camera.hpp"

namespace twofold {
namespace {

/// The combiner's scale that a colour needs, at most 4.
int combiner_scale_of(Rgb color) {
    int k = 1;
    while (k < 4 && k < max_component(color)) k *= 2;
    return k;
}

void add_highlight(Frame& frame, const Mesh& mesh, PassState state, const PassLight& light,
                   std::size_t texture) {
    VertexFactors factors = factors_at(mesh, state.modelview, light.direction);
    std::vector<Vec4> colors = lit_colors(factors, light.color);
    state.units[0] = unit_with(texture);
    add_vertex_pass(frame, mesh, state, std::move(factors.half), {}, std::move(colors));
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

void add_historical(Frame& frame, const HistoricalObject& object, const Mesh& mesh,
                    const FactorSet& set, const Camera& camera) {
    const PassState first = first_state(object, frame, camera);
    const Vec3 light = Mat3(view_matrix(camera)) * normalized(object.light);
    const std::size_t texture = frame.textures.size();
    frame.textures.insert(frame.textures.end(), set.textures.begin(), set.textures.end());
    const bool product = set.kind != FactorSet::Kind::highlight;
    if (product) {
        const Rgb color = object.diffuse * set.alpha * object.irradiance;
        const int k = combiner_scale_of(color);
        const PassLight scaled{light, color / static_cast<double>(k)};
        add_point_lit(frame, mesh, first, std::span(&scaled, 1), k, texture);
    }
    if (set.kind != FactorSet::Kind::product)
        add_highlight(frame, mesh,
                      product ? drawn_over(first, {BlendFactor::one, BlendFactor::one}) : first,
                      {light, object.specular * object.irradiance}, texture + (product ? 2 : 0));
}

}  // namespace twofold
