#include "raster/visible_surface.hpp"

#include <limits>

#include "raster/assemble.hpp"
#include "raster/coverage.hpp"
#include "raster/frame_check.hpp"
#include "raster/interpolate.hpp"

namespace twofold {
namespace {

/// Binary64 on any snap grid.
struct SurfaceModel : Ideal64 {
    SnapRule rule;
    SnapRule snap() const { return rule; }
};

/// The nearest point found so far at each pixel.
struct DepthBuffer {
    int width, height;
    std::vector<double> depth;
    std::vector<SurfacePoint> point;

    void keep_nearest(int x, int y, double z, const SurfacePoint& p) {
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x);
        if (!(z <= depth[i])) return;
        depth[i] = z;
        point[i] = p;
    }
};

/// The weights of the mesh's vertices travel as the texture coordinates of unit 0, so clipped
/// pieces and perspective need no code of their own.
std::array<double, 3> vertex_weights(const WindowTriangle<SurfaceModel>& triangle,
                                     const EdgeValues& edge) {
    const auto at = interpolate_coords<SurfaceModel>(edge, triangle, 0);
    const double sum = at.s + at.t + at.q;
    return {at.s / sum, at.t / sum, at.q / sum};
}

/// The corners of the mesh's triangles in clip space, three a triangle: each carries its own unit
/// weight.
std::vector<ClipVertex> weighted_corners(const PassState& state, const Mesh& mesh,
                                         const std::vector<AssembledTriangle>& triangles,
                                         const Viewport& viewport) {
    static constexpr std::array<Vec4, 3> weight{Vec4{1, 0, 0, 0}, Vec4{0, 1, 0, 0},
                                                Vec4{0, 0, 0, 1}};
    const auto constants = vertex_constants<SurfaceModel::Vertex>(state, viewport);
    std::vector<ClipVertex> corners;
    for (const AssembledTriangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            ClipVertex v{};
            const auto position = words_of<SurfaceModel::Vertex>(position_of(mesh, t.vertex[k]));
            v.clip = to_vec4<SurfaceModel::Vertex>(
                multiply<SurfaceModel::Vertex>(constants.composite, position));
            v.coords[0] = weight[k];
            corners.push_back(v);
        }
    return corners;
}

/// Triangle k made of corners 3k, 3k + 1, 3k + 2.
std::vector<AssembledTriangle> counted_triangles(std::size_t n) {
    std::vector<AssembledTriangle> triangles;
    for (std::uint32_t i = 0; i < 3 * n; i += 3) triangles.push_back({{i, i + 1, i + 2}, i});
    return triangles;
}

void draw_pass(const SurfaceModel& m, const Frame& frame, std::uint32_t pass, DepthBuffer& buffer) {
    const PassState state = normalized(frame.passes[pass].state);
    const Mesh& mesh = frame.meshes[frame.passes[pass].mesh];
    const WindowRules rules = window_rules(state, {frame.width, frame.height}, m.snap());
    const auto triangles = assemble(mesh.primitive, mesh.indices, state.provoking_vertex);
    const int bits = m.snap().fraction_bits;
    DrawCounters ignored;
    for_each_window_triangle(
        m, weighted_corners(state, mesh, triangles, rules.viewport),
        counted_triangles(triangles.size()), rules, ignored,
        [&](std::size_t k, const WindowTriangle<SurfaceModel>& triangle,
            const TriangleSetup& setup) {
            for_each_covered_pixel(
                setup, bits, {0, 0, buffer.width, buffer.height},
                [&](int x, int y, const EdgeValues& edge) {
                    buffer.keep_nearest(
                        x, y, interpolate_depth<SurfaceModel>(edge, triangle),
                        {pass, triangles[k].vertex, vertex_weights(triangle, edge)});
                });
        });
}

}  // namespace

VisibleSurface visible_surface(const Frame& frame, SnapRule snap) {
    check_frame(frame);
    const std::size_t size =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    constexpr double nothing = std::numeric_limits<double>::infinity();
    DepthBuffer buffer{frame.width, frame.height, std::vector<double>(size, nothing),
                       std::vector<SurfacePoint>(size)};
    for (std::uint32_t pass = 0; pass < frame.passes.size(); ++pass)
        draw_pass({{}, snap}, frame, pass, buffer);
    VisibleSurface surface{frame.width, frame.height, std::vector<std::int32_t>(size, -1), {}};
    for (std::size_t i = 0; i < size; ++i) {
        if (buffer.depth[i] == nothing) continue;
        surface.point_of_pixel[i] = static_cast<std::int32_t>(surface.points.size());
        surface.points.push_back(buffer.point[i]);
    }
    return surface;
}

}  // namespace twofold
