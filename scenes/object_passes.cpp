#include "scenes/object_passes.hpp"

#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "factor/view_table.hpp"
#include "scenes/camera.hpp"
#include "scenes/point_lit_passes.hpp"
#include "texunit/paraboloid.hpp"
#include "texunit/sphere_map.hpp"

namespace twofold {
namespace {

/// A unit that looks a factor up in its cube or sphere map, or on one paraboloid: the first image
/// or the second. Its vector arrives in eye space: the inverse of the view's rotation takes it back
/// to the world. A sphere map is in eye space itself: SPHERE_MAP knows the reflected view, and for
/// the normal, for which OpenGL has no such mode, the mesh holds the coordinates.
TextureUnitState factor_unit(const FrameBuilder& b, TexGen texgen, std::size_t first,
                             std::size_t image, const MapShape& shape) {
    TextureUnitState unit;
    unit.texture = first + image;
    if (shape.form == MapForm::sphere) {
        if (texgen == TexGen::reflection_map) unit.texgen = texgen_all(TexGen::sphere_map);
        return unit;
    }
    unit.texgen = texgen_all(texgen);
    unit.matrix = Mat4{glm::transpose(Mat3{b.view})};
    if (shape.form == MapForm::cube)
        unit.target = TextureTarget::cube_map;
    else
        unit.matrix =
            paraboloid_matrix(image == 0 ? Face::front : Face::back, shape.guard) * unit.matrix;
    return unit;
}

/// The term's colour times g(n.v) at each vertex, as a driver of the time would compute it.
std::vector<Vec4> viewed_colors(const FrameBuilder& b, const FactoredObject& object,
                                const ProductTerm& term, const Mesh& mesh) {
    const Mat4 model = model_matrix(object);
    std::vector<Vec4> colors;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 to_eye = b.scene.camera.eye - Vec3{model * Vec4{mesh.positions[i], 1.0}};
        const Vec3 normal = Mat3{model} * mesh.normals[i];
        const double lengths = length(normal) * length(to_eye);
        const double cosine = lengths > 0.0 ? dot(normal, to_eye) / lengths : 0.0;
        colors.emplace_back(term.scale_color * view_value(std::span(term.view), cosine), 1.0);
    }
    return colors;
}

/// Where each normal lies in a sphere map, in eye space.
std::vector<Vec4> sphere_coordinates(const FrameBuilder& b, const FactoredObject& object,
                                     const Mesh& mesh) {
    const Mat3 turn = Mat3{b.view} * Mat3{model_matrix(object)};
    std::vector<Vec4> coordinates;
    for (const Vec3 normal : mesh.normals)
        coordinates.emplace_back(to_sphere_map(normalized(turn * normal)), 0.0, 1.0);
    return coordinates;
}

/// The term's colour times t1 at each vertex.
std::vector<Vec4> row_colors(const ProductTerm& term) {
    std::vector<Vec4> colors;
    for (const Rgb value : term.vertices) colors.emplace_back(term.scale_color * value, 1.0);
    return colors;
}

/// Where a term's images and mesh went in the frame.
struct PlacedTerm {
    const ProductTerm& term;
    std::size_t textures;
    std::size_t mesh;
};

/// The object's mesh, or a copy of it with what the term needs at its vertices.
PlacedTerm place(FrameBuilder& b, const FactoredObject& object, const ProductTerm& term,
                 std::size_t textures) {
    const bool viewed = !term.view.empty();
    const bool spherical = term.t1.shape.form == MapForm::sphere;
    const std::size_t own = b.meshes.at(object.mesh);
    if (!viewed && !spherical && term.vertices.empty()) return {term, textures, own};
    Mesh mesh = b.frame.meshes[own];
    mesh.colors = row_colors(term);
    if (viewed) mesh.colors = viewed_colors(b, object, term, mesh);
    if (spherical) mesh.texcoords[0] = sphere_coordinates(b, object, mesh);
    b.frame.meshes.push_back(std::move(mesh));
    return {term, textures, b.frame.meshes.size() - 1};
}

/// The unit of t1: of a map of directions, or of one over the mesh's own coordinates.
TextureUnitState first_unit(const FrameBuilder& b, const PlacedTerm& placed, std::size_t image) {
    if (placed.term.t1.shape.form == MapForm::chart) return unit_with(placed.textures);
    return factor_unit(b, TexGen::normal_map, placed.textures, image, placed.term.t1.shape);
}

/// One pass: one image of each map. A sum of two maps takes ADD in place of MODULATE. Where t1 is
/// in the vertex colours, one unit is enough.
PassState term_state(const FrameBuilder& b, const FactoredObject& object, const PlacedTerm& placed,
                     std::size_t i, std::size_t j) {
    const ProductTerm& term = placed.term;
    const MapShape& shape = term.t2.shape;
    PassState state = object_state(b, object);
    state.color = Vec4{term.scale_color, 1.0};
    if (shape.form == MapForm::dual_paraboloid)
        state.alpha_test = AlphaTest{CompareFunc::gequal, 1.0};
    const bool by_vertex = !term.vertices.empty();
    if (!by_vertex) state.units[0] = first_unit(b, placed, i);
    if (!term.constant_t2)
        state.units[by_vertex ? 0 : 1] =
            factor_unit(b, TexGen::reflection_map, placed.textures + term.t1.real.size(), j, shape);
    std::optional<TextureUnitState>& last = state.units[term.constant_t2 || by_vertex ? 0 : 1];
    last->env.rgb_scale = term.combiner_scale;
    if (term.sum_of_maps) last->env.mode = TexEnvMode::add;
    return state;
}

/// Adds a term to what is drawn, or takes it off: Cd - Cs. Alpha, which says what is covered, is
/// not taken off.
PassState blended_over(PassState state, const ProductTerm& term) {
    if (term.subtract) state.color_mask[3] = false;
    const BlendEquation equation =
        term.subtract ? BlendEquation::reverse_subtract : BlendEquation::add;
    return drawn_over(std::move(state), {BlendFactor::one, BlendFactor::one, equation, Vec4{0.0}});
}

std::size_t t1_images(const ProductTerm& term) {
    return term.vertices.empty() ? term.t1.real.size() : 1;
}

std::size_t t2_images(const ProductTerm& term) {
    return term.constant_t2 ? 1 : term.t2.real.size();
}

/// The four passes of the paper: every pixel's n and r_v lie on one face each; the alpha test keeps
/// the pass that has both. Its reference is 1: a footprint wholly inside the opaque disc, which
/// reaches past the rim, gives exactly 1 in every preset, so no pixel is lost at the seam and every
/// pixel drawn has alpha 1. Further products are added or taken off right after the first of the
/// same faces: where two passes overlap at the seam, the later one begins the sum anew. A t2 that
/// is 1 everywhere needs no faces. Cube and sphere maps hold all directions: one pass.
void add_term_passes(FrameBuilder& b, const FactoredObject& object,
                     const std::vector<PlacedTerm>& placed) {
    const ProductTerm& first = placed[0].term;
    for (std::size_t i = 0; i < t1_images(first); ++i)
        for (std::size_t j = 0; j < t2_images(first); ++j)
            for (std::size_t k = 0; k < placed.size(); ++k) {
                PassState state = term_state(b, object, placed[k], i, j);
                if (k > 0) state = blended_over(std::move(state), placed[k].term);
                b.frame.passes.push_back({state, placed[k].mesh});
            }
}

/// A pass for each light, then one for p(v).
void add_lit_passes(FrameBuilder& b, const FactoredObject& object, const FactoredLighting& lighting,
                    std::size_t textures) {
    const ProductTerm& term = lighting.terms[0];
    std::vector<PassLight> lights;
    for (std::size_t k = 0; k < lighting.lights.size(); ++k)
        lights.push_back({normalized(Mat3{b.view} * lighting.lights.direction(k)),
                          term.scale_color * lighting.lights.weight(k)});
    const Mesh mesh = b.frame.meshes[b.meshes.at(object.mesh)];
    add_point_lit(b.frame, mesh, object_state(b, object), lights, term.combiner_scale, textures);
}

/// Doubles what the object shows: C = 1 x Cd + Cd, where the scale exceeds what the combiner can
/// do.
void add_doubling_pass(FrameBuilder& b, const FactoredObject& object) {
    b.frame.passes.push_back(
        {drawn_over(object_state(b, object), {BlendFactor::dst_color, BlendFactor::one}),
         b.meshes.at(object.mesh)});
}

}  // namespace

PassState object_state(const FrameBuilder& b, const FactoredObject& object) {
    PassState state;
    state.modelview = b.view * model_matrix(object);
    state.projection = b.projection;
    state.normalize = object.scale != 1.0;
    state.cull = CullFace::back;
    state.depth_test = DepthTest{CompareFunc::lequal, true};
    return state;
}

std::size_t add_factor_textures(Frame& frame, const ProductTerm& term, bool as_float) {
    const std::size_t first = frame.textures.size();
    for (const FactorMap* map : {&term.t1, &term.t2})
        for (const Texture& image : as_float ? map->real : map->bytes)
            frame.textures.push_back(image);
    return first;
}

void add_object_passes(FrameBuilder& b, const FactoredObject& object,
                       const FactoredLighting& lighting, std::span<const std::size_t> textures) {
    if (lighting.model == Model::mccool) {
        add_lit_passes(b, object, lighting, textures[0]);
    } else {
        std::vector<PlacedTerm> placed;
        for (std::size_t k = 0; k < lighting.terms.size(); ++k)
            placed.push_back(place(b, object, lighting.terms[k], textures[k]));
        add_term_passes(b, object, placed);
    }
    for (int i = 0; i < lighting.doubling_passes; ++i) add_doubling_pass(b, object);
}

std::size_t pass_count(const FactoredLighting& lighting) {
    const ProductTerm& first = lighting.terms.at(0);
    const auto doubling = static_cast<std::size_t>(lighting.doubling_passes);
    if (lighting.model == Model::mccool) return lighting.lights.size() + 1 + doubling;
    return t1_images(first) * t2_images(first) * lighting.terms.size() + doubling;
}

}  // namespace twofold
