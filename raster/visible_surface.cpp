#include "raster/visible_surface.hpp"

#include <limits>

#include "raster/assemble.hpp"
#include "raster/coverage.hpp"
#include "raster/frame_check.hpp"
#include "raster/interpolate.hpp"
#include "texunit/gl13.hpp"
#include "texunit/ideal64.hpp"

namespace twofold {
namespace {

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
template <NumericModel M>
std::array<double, 3> vertex_weights(const WindowTriangle<M>& triangle,
                                     const std::array<std::int64_t, 3>& edge) {
    const auto at = interpolate_coords<M>(edge, triangle, 0);
    const double sum = at.s + at.t + at.q;
    return {at.s / sum, at.t / sum, at.q / sum};
}

/// The vertices of the mesh in clip space, three a triangle: each carries its own unit weight.
template <NumericModel M>
std::vector<ClipVertex> weighted_vertices(const PassState& state, const Mesh& mesh,
                                          const Viewport& viewport) {
    static constexpr std::array<Vec4, 3> corner{Vec4{1, 0, 0, 0}, Vec4{0, 1, 0, 0},
                                                Vec4{0, 0, 0, 1}};
    const auto constants = vertex_constants<typename M::Vertex>(state, viewport);
    std::vector<ClipVertex> vertices(mesh.indices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec4 position{mesh.positions[mesh.indices[i]], 1.0};
        vertices[i].clip = to_vec4<typename M::Vertex>(
            multiply<typename M::Vertex>(constants.composite, words_of<typename M::Vertex>(position)));
        vertices[i].coords[0] = corner[i % 3];
    }
    return vertices;
}

std::vector<std::uint32_t> counting(std::size_t n) {
    std::vector<std::uint32_t> indices(n);
    for (std::size_t i = 0; i < n; ++i) indices[i] = static_cast<std::uint32_t>(i);
    return indices;
}

template <NumericModel M>
void draw_pass(const Frame& frame, std::uint32_t pass, DepthBuffer& buffer) {
    const PassState state = normalized(frame.passes[pass].state);
    const Mesh& mesh = frame.meshes[frame.passes[pass].mesh];
    const Viewport viewport = viewport_of(frame.width, frame.height, M::snap);
    DrawCounters ignored;
    for_each_window_triangle<M>(
        weighted_vertices<M>(state, mesh, viewport), counting(mesh.indices.size()), viewport,
        state.cull, ignored,
        [&](std::size_t k, const WindowTriangle<M>& triangle, const TriangleSetup& setup) {
            for_each_covered_pixel(
                setup, M::snap.fraction_bits, buffer.width, buffer.height,
                [&](int x, int y, const std::array<std::int64_t, 3>& edge) {
                    buffer.keep_nearest(
                        x, y, interpolate_depth<M>(edge, triangle),
                        {pass, static_cast<std::uint32_t>(k), vertex_weights<M>(triangle, edge)});
                });
        });
}

template <NumericModel M>
VisibleSurface surface_of(const Frame& frame) {
    const std::size_t size =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    constexpr double nothing = std::numeric_limits<double>::infinity();
    DepthBuffer buffer{frame.width, frame.height, std::vector<double>(size, nothing),
                       std::vector<SurfacePoint>(size)};
    for (std::uint32_t pass = 0; pass < frame.passes.size(); ++pass)
        draw_pass<M>(frame, pass, buffer);
    VisibleSurface surface{frame.width, frame.height, std::vector<std::int32_t>(size, -1), {}};
    for (std::size_t i = 0; i < size; ++i) {
        if (buffer.depth[i] == nothing) continue;
        surface.point_of_pixel[i] = static_cast<std::int32_t>(surface.points.size());
        surface.points.push_back(buffer.point[i]);
    }
    return surface;
}

}  // namespace

VisibleSurface visible_surface(const Frame& frame, SnapGrid grid) {
    check_frame(frame);
    return grid == SnapGrid::ideal64 ? surface_of<Ideal64>(frame) : surface_of<Gl13>(frame);
}

}  // namespace twofold
