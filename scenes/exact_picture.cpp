#include "scenes/exact_picture.hpp"

#include <glm/matrix.hpp>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "raster/visible_surface.hpp"
#include "scenes/camera.hpp"
#include "texunit/ideal64.hpp"

namespace twofold {
namespace {

/// One object's mesh and its way into the world.
struct WorldMesh {
    const Mesh& mesh;
    Mat4 model;

    Vec3 position(std::uint32_t vertex) const {
        return Vec3{model * Vec4{mesh.positions[vertex], 1.0}};
    }
    /// Up to length: the model matrix is a rotation times a uniform scale.
    Vec3 normal(std::uint32_t vertex) const { return Mat3{model} * mesh.normals[vertex]; }
};

/// (n, v) at a surface point. A normal that faces away is kept; v is then moved to the horizon, the
/// nearest direction in which such a surface can be seen.
SurfaceView view_of(const WorldMesh& world, const SurfacePoint& point, Vec3 eye) {
    Vec3 position{0.0}, normal{0.0};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = point.vertex[k];
        position += point.weights[k] * world.position(vertex);
        normal += point.weights[k] * world.normal(vertex);
    }
    return {normalized(normal), normalized(eye - position)};
}

bool turned_away(const SurfaceView& at) { return dot(at.n, at.v) < least_view_cosine; }

SurfaceView at_horizon(const SurfaceView& at) {
    const double cosine = dot(at.n, at.v);
    const Vec3 tangent = at.v - cosine * at.n;
    return {at.n, normalized(normalized(tangent) + least_view_cosine * at.n)};
}

/// The surface points of one material, and which of all points they are.
struct MaterialViews {
    std::vector<SurfaceView> at;
    std::vector<std::size_t> point;
};

struct SceneViews {
    std::map<std::string, MaterialViews> of_material;
    std::size_t turned_away = 0;
};

SceneViews collect_views(const Scene& scene, const SceneAssets& assets,
                         const VisibleSurface& surface) {
    SceneViews views;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const FactoredObject& object = scene.objects[surface.points[i].pass];
        const WorldMesh world{assets.meshes.at(object.mesh), model_matrix(object)};
        SurfaceView at = view_of(world, surface.points[i], scene.camera.eye);
        if (turned_away(at)) {
            ++views.turned_away;
            at = at_horizon(at);
        }
        MaterialViews& material = views.of_material[object.material];
        material.at.push_back(at);
        material.point.push_back(i);
    }
    return views;
}

/// Radiance at each surface point.
std::vector<Rgb> radiance_at(const SceneViews& views, std::size_t points, const LitScene& lit,
                             int threads) {
    std::vector<Rgb> radiance(points);
    for (const auto& [name, material] : views.of_material) {
        const auto values =
            outgoing_radiance(lit.brdfs.at(name), lit.lights.lights, material.at, threads);
        for (std::size_t i = 0; i < values.size(); ++i) radiance[material.point[i]] = values[i];
    }
    return radiance;
}

void append_pixel(Framebuffer& picture, const Rgb& c, double alpha) {
    const std::array<double, 4> value{Ideal64::clamp01(c.x), Ideal64::clamp01(c.y),
                                      Ideal64::clamp01(c.z), alpha};
    picture.values.push_back(value);
    picture.bytes.push_back({Ideal64::to_unorm8(value[0]), Ideal64::to_unorm8(value[1]),
                             Ideal64::to_unorm8(value[2]), Ideal64::to_unorm8(value[3])});
}

}  // namespace

ExactPicture exact_picture(const Scene& scene, const SceneAssets& assets, const LitScene& lit,
                           int threads) {
    const VisibleSurface surface = visible_surface(make_surface_frame(scene, assets));
    const SceneViews views = collect_views(scene, assets, surface);
    const auto radiance = radiance_at(views, surface.points.size(), lit, threads);
    ExactPicture result{{surface.width, surface.height, {}, {}, {}}, views.turned_away};
    for (const std::int32_t point : surface.point_of_pixel) {
        if (point < 0)
            append_pixel(result.picture, scene.image.background, 0.0);
        else
            append_pixel(result.picture, radiance[static_cast<std::size_t>(point)] / lit.white,
                         1.0);
    }
    return result;
}

}  // namespace twofold
