#include "scenes/vertex_lighting.hpp"

#include <algorithm>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "scenes/camera.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

/// The largest that SPECULAR_EXPONENT takes. @source OpenGL 1.3, table 2.8
constexpr double largest_shininess = 128.0;

/// A material of fixed-function lighting.
struct GlMaterial {
    Rgb diffuse{0.0}, specular{0.0};
    double shininess = 0.0;
};

struct GlMaterialOf {
    GlMaterial operator()(const ModifiedPhong& phong) const {
        const double peak = (phong.exponent + 2.0) / (2.0 * exact::pi);
        return {phong.diffuse / exact::pi, peak * phong.specular,
                std::min(largest_shininess, 4.0 * phong.exponent)};
    }
    GlMaterial operator()(const CookTorrance& metal) const {
        double square = 0.0, peak = 0.0;
        for (const BeckmannLobe& lobe : metal.lobes) {
            square += lobe.weight * lobe.m * lobe.m;
            peak += lobe.weight / (lobe.m * lobe.m);
        }
        const double constant = metal.constant == CookTorranceConstant::pi1981 ? 1.0 : 0.25;
        return {metal.diffuse / exact::pi, constant * peak / exact::pi * metal.specular * metal.f0,
                std::min(largest_shininess, 2.0 / square)};
    }
    GlMaterial operator()(const MeasuredBrdf&) const {
        throw Error(ExitCode::failure,
                    "a measured material has no form for fixed-function lighting");
    }
};

/// The sum of OpenGL's terms over the lights. @source OpenGL 1.3, equation 2.4
Rgb gl_lighting(const GlMaterial& material, const DistantLights& lights, const SurfaceView& at) {
    Rgb sum(0.0);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Vec3 l = lights.direction(k);
        const double n_l = dot(at.n, l);
        if (!(n_l > 0.0)) continue;
        const double n_h = std::max(0.0, dot(at.n, normalized(l + at.v)));
        const double highlight = exact::pow(n_h, material.shininess);
        sum += lights.weight(k) * (n_l * material.diffuse + highlight * material.specular);
    }
    return sum;
}

/// (n, v) of every vertex in the world.
std::vector<SurfaceView> vertex_views(const Mesh& mesh, const FactoredObject& object, Vec3 eye) {
    const Mat4 model = model_matrix(object);
    std::vector<SurfaceView> views;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 position{model * Vec4{mesh.positions[i], 1.0}};
        views.push_back({normalized(Mat3{model} * mesh.normals[i]), normalized(eye - position)});
    }
    return views;
}

/// A frame of one pass an object, each with its own copy of its mesh, whose colours are what
/// `radiance_of` gives for its vertices.
template <class RadianceOf>
Frame vertex_lit(const Scene& scene, const SceneAssets& assets, double white,
                 RadianceOf&& radiance_of) {
    Frame frame = make_surface_frame(scene, assets);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const FactoredObject& object = scene.objects[i];
        Mesh mesh = assets.meshes.at(object.mesh);
        const auto views = vertex_views(mesh, object, scene.camera.eye);
        mesh.colors.clear();
        for (const Rgb& radiance : radiance_of(object.material, views))
            mesh.colors.emplace_back(glm::clamp(radiance / white, Rgb(0.0), Rgb(1.0)), 1.0);
        frame.passes[i].mesh = frame.meshes.size();
        frame.meshes.push_back(std::move(mesh));
    }
    return frame;
}

}  // namespace

Frame make_vertex_sum_frame(const Scene& scene, const SceneAssets& assets,
                            const SampledScene& sampled, double white, int threads) {
    return vertex_lit(scene, assets, white, [&](const std::string& material, const auto& views) {
        return outgoing_radiance(sampled.brdfs.at(material), sampled.lights.lights, views, threads);
    });
}

Frame make_vertex_lights_frame(const Scene& scene, const SceneAssets& assets,
                               const SampledScene& sampled, double white, int lights) {
    Scene few = scene;
    few.environment->cells = lights;
    const DistantLights list = make_lights(few).lights;
    return vertex_lit(scene, assets, white, [&](const std::string& name, const auto& views) {
        const GlMaterial material = std::visit(GlMaterialOf{}, sampled.brdfs.at(name));
        std::vector<Rgb> radiance;
        for (const SurfaceView& at : views) radiance.push_back(gl_lighting(material, list, at));
        return radiance;
    });
}

}  // namespace twofold
