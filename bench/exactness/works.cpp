#include <memory>

#include "bench/exactness/work.hpp"
#include "factor/directions.hpp"
#include "factor/factorize.hpp"
#include "factor/lighting.hpp"
#include "raster/transform.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/random.hpp"
#include "texunit/vertex_arithmetic.hpp"

/// Compiled with contraction off as twofold_exact and on as twofold_fused (CMakeLists.txt), as is
/// all that it calls.
namespace twofold {
namespace {

template <class Function>
price::Work function_work(const char* name, double low, double high, const Function& f) {
    std::vector<double> x(4096);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = low + (high - low) * random_unit(1, i);
    return {name, [x = std::move(x), y = std::vector<double>(4096), f]() mutable {
                for (std::size_t i = 0; i < x.size(); ++i) y[i] = f(x[i]);
            }};
}

DistantLights many_lights() {
    DistantLights lights;
    for (const SurfaceView& at : surface_views(2048, 3)) lights.push_back(at.n, Rgb(0.01));
    return bound_blocks(std::move(lights));
}

price::Work lighting_work(const char* name, const Brdf& brdf) {
    return {name, [brdf, lights = many_lights(), at = surface_views(200, 0)] {
                outgoing_radiance(brdf, lights, at, 1);
            }};
}

/// The solvers and everything around them: 5,000 samples, 512 unknowns a map.
price::Work fit_work(const char* name, Solver solver) {
    FactorSettings settings;
    settings.map_size = 16;
    settings.solver = solver;
    settings.iteration_limit = 40;
    settings.tolerance = 0.0;
    LightingSamples samples{surface_views(5000, 0), {}};
    samples.radiance = outgoing_radiance(ModifiedPhong{}, many_lights(), samples.at, 1);
    return {name,
            [settings, samples = std::move(samples)] { factorize(samples, {}, settings, 1.0, 1); }};
}

/// 4,096 vertices with a normal and a reflection map, as the paper's passes have them.
template <class Float>
price::Work vertex_work(const char* name) {
    PassState state;
    for (std::size_t u = 0; u < 2; ++u) {
        state.units[u].emplace();
        state.units[u]->texgen = texgen_all(u == 0 ? TexGen::normal_map : TexGen::reflection_map);
    }
    Mesh mesh;
    for (const SurfaceView& at : surface_views(4096, 1)) {
        mesh.positions.push_back(at.n + at.v);
        mesh.normals.push_back(at.n);
    }
    return {name, [state, mesh = std::move(mesh)] {
                transform_mesh<IeeeArithmetic<Float>>(state, mesh, {Vec3(100.0), Vec3(100.0)});
            }};
}

}  // namespace

std::vector<price::Work> works() {
    return {function_work("exp", -20.0, 5.0, exact::exp),
            function_work("log", 1e-4, 4.0, exact::log),
            function_work("pow", 0.3, 1.0, [](double x) { return exact::pow(x, 20.5); }),
            lighting_work("L_o, modified Phong", ModifiedPhong{}),
            lighting_work("L_o, Cook-Torrance", CookTorrance{}),
            fit_work("fit by QMR", Solver::qmr),
            fit_work("fit by LSMR", Solver::lsmr),
            vertex_work<double>("vertices, binary64"),
            vertex_work<float>("vertices, binary32")};
}

}  // namespace twofold
