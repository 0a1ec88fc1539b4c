#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bench/check.hpp"
#include "bench/tables.hpp"
#include "scenes/camera.hpp"
#include "texunit/random.hpp"

/// Primitives, shading, culling, secondary colour and fog.
namespace twofold::bench {
namespace {

constexpr std::array primitive_names{"triangles", "triangle_strip", "triangle_fan",
                                     "quads",     "quad_strip",     "polygon"};

void number_vertices(Mesh& mesh) {
    mesh.colors.clear();
    mesh.indices.clear();
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.indices.push_back(v);
        mesh.colors.push_back(color_of(random_bytes(21, v)));
    }
}

/// The vertices moved onto odd sixteenths of a pixel, where every snap leaves them and no edge
/// along an axis meets a pixel's centre: OpenGL leaves open whose a pixel on a shared edge is.
Mesh on_grid(Mesh mesh) {
    constexpr double eighths = 8.0 * table_size / 2.0;
    for (Vec3& p : mesh.positions)
        for (int i = 0; i < 2; ++i) p[i] = (std::floor(p[i] * eighths) + 0.5) / eighths;
    return mesh;
}

/// Squares of 4 x 4 pixels, an eighth of a pixel aside, so that their diagonals miss the pixel
/// centres too.
Mesh squares_aside() {
    Mesh mesh = squares(8, 22, false);
    for (Vec3& p : mesh.positions) p = {p.x / 2.0 + 0.25 / table_size, p.y / 2.0, p.z};
    return mesh;
}

/// A band of 11 columns, vertices below and above in turn.
Mesh band() {
    Mesh mesh;
    for (int i = 0; i < 12; ++i)
        for (const double y : {-0.6, 0.72}) mesh.positions.emplace_back(i / 6.03 - 0.9, y, 0.0);
    number_vertices(mesh);
    return mesh;
}

/// A convex outline, counter-clockwise; its first vertex serves as a fan's centre.
Mesh outline() {
    Mesh mesh;
    for (const Vec2 p :
         {Vec2(0.9, 0.11), Vec2(0.63, 0.62), Vec2(0.05, 0.87), Vec2(-0.58, 0.66), Vec2(-0.91, 0.03),
          Vec2(-0.67, -0.6), Vec2(-0.02, -0.93), Vec2(0.61, -0.7)})
        mesh.positions.emplace_back(p.x, p.y, 0.0);
    number_vertices(mesh);
    return mesh;
}

Mesh mesh_of(Primitive primitive) {
    Mesh mesh;
    switch (primitive) {
        case Primitive::triangles:
            mesh = squares_aside();
            break;
        case Primitive::quads:
            mesh = squares_aside();
            number_vertices(mesh);
            break;
        case Primitive::triangle_strip:
        case Primitive::quad_strip:
            mesh = band();
            break;
        case Primitive::triangle_fan:
        case Primitive::polygon:
            mesh = outline();
            break;
    }
    mesh.primitive = primitive;
    return on_grid(std::move(mesh));
}

Frame flat_frame(Primitive primitive, ProvokingVertex provoking) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {mesh_of(primitive)};
    PassState state;
    state.shade_model = ShadeModel::flat;
    state.provoking_vertex = provoking;
    frame.passes = {{state, 0}};
    return frame;
}

/// Colours arrive as they are.
std::vector<Check> flat_checks() {
    std::vector<Check> checks;
    for (std::size_t p = 0; p < primitive_names.size(); ++p)
        for (const ProvokingVertex provoking : {ProvokingVertex::last, ProvokingVertex::first})
            checks.push_back({fmt::format("flat {}, {} vertex provokes", primitive_names[p],
                                          provoking == ProvokingVertex::last ? "last" : "first"),
                              {0, 10},
                              0,
                              [=] {
                                  return std::vector<Frame>{
                                      flat_frame(static_cast<Primitive>(p), provoking)};
                              }});
    return checks;
}

Frame smooth_frame(bool secondary) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares(4, 23, false)};
    Mesh& mesh = frame.meshes[0];
    if (secondary)
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            mesh.secondary_colors.push_back(color_of(random_bytes(24, v)));
    PassState state;
    state.color_sum = secondary;
    frame.passes = {{state, 0}};
    return frame;
}

/// Squares of random winding: half of them face away.
Frame cull_frame(CullFace cull) {
    Frame frame = empty_frame(table_size);
    frame.meshes = {squares(16, 25, true)};
    auto& indices = frame.meshes[0].indices;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        if (random_u32(26, i / 6) % 2 == 0) std::swap(indices[i], indices[i + 1]);
    PassState state;
    state.cull = cull;
    frame.passes = {{state, 0}};
    return frame;
}

/// A plane that runs away from the eye, in 64 x 64 squares: OpenGL allows fog by the vertex, as
/// ours is, and by the fragment, as Mesa's; on small squares both are the same.
Frame fog_frame(const Fog& fog) {
    Frame frame = empty_frame(128);
    frame.meshes = {squares(64, 26, true)};
    for (Vec3& p : frame.meshes[0].positions) p = {3.0 * p.x, p.y, -5.5 - 4.5 * p.y};
    frame.meshes[0].colors.clear();
    PassState state;
    state.projection = projection_matrix(Camera{}, 1.0);
    state.color = color_of({255, 51, 102, 153});
    state.fog = fog;
    frame.passes = {{state, 0}};
    return frame;
}

std::vector<Check> fog_checks() {
    constexpr std::array names{"linear", "exp", "exp2"};
    std::vector<Check> checks;
    for (std::size_t m = 0; m < names.size(); ++m) {
        const Fog fog{static_cast<FogMode>(m), 0.2, 2.0, 8.0, Rgb{0.2, 0.6, 1.0}};
        checks.push_back({fmt::format("fog {}", names[m]), {1, 10}, 0, [=] {
                              return std::vector<Frame>{fog_frame(fog)};
                          }});
    }
    return checks;
}

}  // namespace

/// Smooth colours: both interpolate in floating point and round once.
std::vector<Check> primitive_checks() {
    std::vector<Check> checks = flat_checks();
    checks.push_back(
        {"smooth colours", {1, 0}, 0, [] { return std::vector<Frame>{smooth_frame(false)}; }});
    checks.push_back(
        {"secondary colour", {1, 0}, 0, [] { return std::vector<Frame>{smooth_frame(true)}; }});
    checks.push_back(
        {"cull face", {0, 0}, 0, [] {
             return std::vector<Frame>{cull_frame(CullFace::front), cull_frame(CullFace::back)};
         }});
    for (Check& check : fog_checks()) checks.push_back(std::move(check));
    return checks;
}

}  // namespace twofold::bench
