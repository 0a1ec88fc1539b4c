#include "scenes/frame.hpp"

#include <fmt/format.h>

#include <glm/matrix.hpp>
#include <optional>
#include <span>
#include <utility>

#include "factor/view_table.hpp"
#include "scenes/camera.hpp"
#include "scenes/historical.hpp"
#include "scenes/scene_names.hpp"
#include "texunit/error.hpp"
#include "texunit/paraboloid.hpp"
#include "texunit/texture_limits.hpp"

namespace twofold {
namespace {

/// Where the meshes and textures of a scene went in the frame.
struct FrameBuilder {
    const Scene& scene;
    Frame frame;
    std::map<std::string, std::size_t> meshes;
    std::map<std::string, std::size_t> textures;
    Mat4 view, projection;
};

/// @throws Error if the preset's chip does not take textures of this size (T09)
void require_size(const Scene& scene, const std::string& field, Preset preset, TextureTarget target,
                  const Texture& texture) {
    const auto limit = size_limit(preset, target, texture);
    const int width = texture.width - 2 * texture.border;
    const int height = texture.height - 2 * texture.border;
    if (!limit || (limit->allows(width) && limit->allows(height))) return;
    throw Error(
        ExitCode::failure,
        fmt::format("{}: {}: {} x {}: preset {} takes {}sides up to {} for a {}", scene.file, field,
                    width, height, name_of(preset), limit->powers_of_two ? "powers of two as " : "",
                    limit->largest, scene_io::name_in(scene_io::target_names, target)));
}

FrameBuilder start(const Scene& scene, const SceneAssets& assets) {
    const ImageSpec& image = scene.image;
    const double aspect = image.height > 0 ? static_cast<double>(image.width) / image.height : 1.0;
    FrameBuilder b{
        scene, {}, {}, {}, view_matrix(scene.camera), projection_matrix(scene.camera, aspect)};
    b.frame.width = image.width;
    b.frame.height = image.height;
    b.frame.clear_color = Vec4{image.background, 0.0};
    b.frame.clear_depth = image.clear_depth;
    b.frame.color_format = image.color_format;
    b.frame.depth_bits = image.depth_bits;
    for (const auto& [name, mesh] : assets.meshes) {
        b.meshes.emplace(name, b.frame.meshes.size());
        b.frame.meshes.push_back(mesh);
    }
    for (const auto& [name, texture] : assets.textures) {
        b.textures.emplace(name, b.frame.textures.size());
        b.frame.textures.push_back(texture);
    }
    return b;
}

PassState object_state(const FrameBuilder& b, const FactoredObject& object) {
    PassState state;
    state.modelview = b.view * model_matrix(object);
    state.projection = b.projection;
    state.normalize = object.scale != 1.0;
    state.cull = CullFace::back;
    state.depth_test = DepthTest{CompareFunc::lequal, true};
    return state;
}

/// Adds the images of a product; the result is the index of t1's first, t2's follow: the front and
/// the back of each, or a cube map each.
std::size_t add_factor_textures(Frame& frame, const ProductTerm& term, bool as_float) {
    const std::size_t first = frame.textures.size();
    for (const FactorMap* map : {&term.t1, &term.t2})
        for (const Texture& image : as_float ? map->real : map->bytes)
            frame.textures.push_back(image);
    return first;
}

/// A unit that looks a factor up in its cube map, or on one paraboloid: the first image or the
/// second. Its vector arrives in eye space: the inverse of the view's rotation takes it back to the
/// world.
TextureUnitState factor_unit(const FrameBuilder& b, TexGen texgen, std::size_t first,
                             std::size_t image, const MapShape& shape) {
    TextureUnitState unit;
    unit.texture = first + image;
    unit.texgen = texgen_all(texgen);
    unit.matrix = Mat4{glm::transpose(Mat3{b.view})};
    if (shape.form == MapForm::cube)
        unit.target = TextureTarget::cube_map;
    else
        unit.matrix =
            paraboloid_matrix(image == 0 ? Face::front : Face::back, shape.guard) * unit.matrix;
    return unit;
}

/// Adds the object's mesh once more, its vertex colours those of the term times g(n.v) at each
/// vertex, as a driver of the time would compute them.
std::size_t add_viewed_mesh(FrameBuilder& b, const FactoredObject& object,
                            const ProductTerm& term) {
    Mesh mesh = b.frame.meshes[b.meshes.at(object.mesh)];
    const Mat4 model = model_matrix(object);
    mesh.colors.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 to_eye = b.scene.camera.eye - Vec3{model * Vec4{mesh.positions[i], 1.0}};
        const Vec3 normal = Mat3{model} * mesh.normals[i];
        const double lengths = length(normal) * length(to_eye);
        const double cosine = lengths > 0.0 ? dot(normal, to_eye) / lengths : 0.0;
        mesh.colors.emplace_back(term.scale_color * view_value(std::span(term.view), cosine), 1.0);
    }
    b.frame.meshes.push_back(std::move(mesh));
    return b.frame.meshes.size() - 1;
}

/// Where a term's images and mesh went in the frame.
struct PlacedTerm {
    const ProductTerm& term;
    std::size_t textures;
    std::size_t mesh;
};

PlacedTerm place(FrameBuilder& b, const FactoredObject& object, const ProductTerm& term,
                 std::size_t textures) {
    return {term, textures,
            term.view.empty() ? b.meshes.at(object.mesh) : add_viewed_mesh(b, object, term)};
}

/// One pass: one image of each map.
PassState term_state(const FrameBuilder& b, const FactoredObject& object, const PlacedTerm& placed,
                     std::size_t i, std::size_t j) {
    const FactorMap& t1 = placed.term.t1;
    PassState state = object_state(b, object);
    state.color = Vec4{placed.term.scale_color, 1.0};
    if (t1.shape.form == MapForm::dual_paraboloid)
        state.alpha_test = AlphaTest{CompareFunc::gequal, 1.0};
    state.units[0] = factor_unit(b, TexGen::normal_map, placed.textures, i, t1.shape);
    if (!placed.term.constant_t2)
        state.units[1] =
            factor_unit(b, TexGen::reflection_map, placed.textures + t1.real.size(), j, t1.shape);
    std::optional<TextureUnitState>& last = state.units[placed.term.constant_t2 ? 0 : 1];
    last->env.rgb_scale = placed.term.combiner_scale;
    return state;
}

/// The four passes of the paper: every pixel's n and r_v lie on one face each; the alpha test keeps
/// the pass that has both. Its reference is 1: a footprint wholly inside the opaque disc, which
/// reaches past the rim, gives exactly 1 in every preset, so no pixel is lost at the seam and every
/// pixel drawn has alpha 1. Further products are added right after the first of the same faces:
/// where two passes overlap at the seam, the later one begins the sum anew. A t2 that is 1
/// everywhere needs no faces. Cube maps hold all directions: one pass.
void add_term_passes(FrameBuilder& b, const FactoredObject& object,
                     const std::vector<PlacedTerm>& placed) {
    const std::size_t images = placed[0].term.t1.real.size();
    const std::size_t t2_images = placed[0].term.constant_t2 ? 1 : images;
    for (std::size_t i = 0; i < images; ++i)
        for (std::size_t j = 0; j < t2_images; ++j)
            for (std::size_t k = 0; k < placed.size(); ++k) {
                PassState state = term_state(b, object, placed[k], i, j);
                if (k > 0) {
                    state.depth_test = DepthTest{CompareFunc::equal, false};
                    state.blend = Blend{BlendFactor::one, BlendFactor::one};
                }
                b.frame.passes.push_back({state, placed[k].mesh});
            }
}

/// Doubles what the object shows: C = 1 x Cd + Cd, where the scale exceeds what the combiner can
/// do.
void add_doubling_pass(FrameBuilder& b, const FactoredObject& object) {
    PassState state = object_state(b, object);
    state.depth_test = DepthTest{CompareFunc::equal, false};
    state.blend = Blend{BlendFactor::dst_color, BlendFactor::one};
    b.frame.passes.push_back({state, b.meshes.at(object.mesh)});
}

void add_explicit_pass(FrameBuilder& b, const ScenePass& pass, Preset preset) {
    PassState state = pass.state;
    if (!pass.own_matrices) {
        state.modelview = b.view;
        state.projection = b.projection;
    }
    for (std::size_t u = 0; u < state.units.size(); ++u)
        if (auto& unit = state.units[u]; unit && !pass.textures[u].empty()) {
            unit->texture = b.textures.at(pass.textures[u]);
            require_size(b.scene, "textures." + pass.textures[u], preset, unit->target,
                         b.frame.textures[*unit->texture]);
        }
    b.frame.passes.push_back({state, b.meshes.at(pass.mesh)});
}

const FactoredLighting& lighting_of(const FactoredMaterials& materials, const std::string& name) {
    const auto it = materials.find(name);
    if (it == materials.end())
        throw Error(ExitCode::failure, "material '" + name + "' was not factored");
    return it->second;
}

}  // namespace

bool samples_float_textures(Preset preset) {
    return preset == Preset::ideal64 || preset == Preset::float32;
}

Frame make_frame(const Scene& scene, const SceneAssets& assets, const FactoredMaterials& materials,
                 Preset preset) {
    FrameBuilder b = start(scene, assets);
    std::map<std::string, std::vector<std::size_t>> factor_textures;
    for (const FactoredObject& object : scene.objects) {
        const FactoredLighting& lighting = lighting_of(materials, object.material);
        const FactorMap& t1 = lighting.terms.at(0).t1;
        require_size(
            scene, "factorization.map_size", preset,
            t1.shape.form == MapForm::cube ? TextureTarget::cube_map : TextureTarget::texture_2d,
            t1.bytes[0]);
        std::vector<std::size_t>& textures = factor_textures[object.material];
        for (std::size_t k = textures.size(); k < lighting.terms.size(); ++k)
            textures.push_back(
                add_factor_textures(b.frame, lighting.terms[k], samples_float_textures(preset)));
        std::vector<PlacedTerm> placed;
        for (std::size_t k = 0; k < lighting.terms.size(); ++k)
            placed.push_back(place(b, object, lighting.terms[k], textures[k]));
        add_term_passes(b, object, placed);
        for (int i = 0; i < lighting.doubling_passes; ++i) add_doubling_pass(b, object);
    }
    for (const HistoricalObject& object : scene.historical)
        add_historical(b.frame, object, assets.meshes.at(object.mesh),
                       assets.factor_sets.at(object.factors), scene.camera);
    for (const ScenePass& pass : scene.passes) add_explicit_pass(b, pass, preset);
    return std::move(b.frame);
}

Frame make_surface_frame(const Scene& scene, const SceneAssets& assets) {
    FrameBuilder b = start(scene, assets);
    for (const FactoredObject& object : scene.objects)
        b.frame.passes.push_back({object_state(b, object), b.meshes.at(object.mesh)});
    return std::move(b.frame);
}

}  // namespace twofold
