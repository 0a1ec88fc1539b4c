#include "scenes/surface_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "scenes/mesh_normals.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"
#include "texunit/random.hpp"

namespace twofold {
namespace {

using Corners = std::array<std::uint32_t, 3>;

Corners corners(const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t* first = mesh.indices.data() + 3 * triangle;
    return {first[0], first[1], first[2]};
}

/// Areas of the triangles, each added to those before it.
std::vector<double> running_areas(const Mesh& mesh) {
    std::vector<double> areas;
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const auto [a, b, c] = corners(mesh, t);
        sum += length(area_vector(mesh.positions[a], mesh.positions[b], mesh.positions[c]));
        areas.push_back(sum);
    }
    return areas;
}

/// A point of the mesh.
struct MeshPoint {
    Corners vertex;
    std::array<double, 3> weight;
};

/// Point `index` of a sequence, even over the area.
MeshPoint point_of(const Mesh& mesh, const std::vector<double>& areas, std::uint64_t sequence,
                   std::uint64_t index) {
    const auto number = [&](std::uint64_t k) { return random_unit(sequence, 8 * index + k); };
    const auto found = std::upper_bound(areas.begin(), areas.end(), number(0) * areas.back());
    const auto triangle =
        std::min<std::size_t>(static_cast<std::size_t>(found - areas.begin()), areas.size() - 1);
    const double root = std::sqrt(number(1)), along = number(2);
    return {corners(mesh, triangle), {1.0 - root, root * (1.0 - along), root * along}};
}

template <class Vector>
Vector interpolated(const std::vector<Vector>& values, const MeshPoint& at) {
    Vector sum(0.0);
    for (std::size_t k = 0; k < 3; ++k) sum += at.weight[k] * values[at.vertex[k]];
    return sum;
}

/// A view of the point, cosine-weighted about its normal.
SurfaceView view_of(const Surface& surface, const MeshPoint& at, std::uint64_t sequence,
                    std::uint64_t index) {
    const Vec3 n =
        unit_or(Mat3{surface.model} * interpolated(surface.mesh.normals, at), Vec3{0.0, 0.0, 1.0});
    const double square = random_unit(sequence, 8 * index + 3);
    const double turn = 2.0 * exact::pi * random_unit(sequence, 8 * index + 4);
    const double across = std::sqrt(square);
    const double along = max(std::sqrt(1.0 - square), least_view_cosine);
    return {n, normalized(about(n, across * exact::cos(turn), across * exact::sin(turn), along))};
}

TexelFootprint row_of(const Surface& surface, const MeshPoint& at, const FactorSettings& settings) {
    if (settings.surface_rows == SurfaceRow::vertices)
        return {{at.vertex[0], at.vertex[1], at.vertex[2], at.vertex[2]},
                {at.weight[0], at.weight[1], at.weight[2], 0.0}};
    const Vec4 place = interpolated(surface.mesh.texcoords[0], at);
    return footprint_at({place.x, place.y}, {settings.map_size, 1.0, MapForm::chart});
}

/// Joins vertices that lie at one place, as those of a seam do.
void join_places(const Mesh& mesh, SurfaceRows& rows) {
    std::map<std::array<double, 3>, std::uint32_t> first;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p = mesh.positions[i];
        const auto [found, fresh] = first.try_emplace({p.x, p.y, p.z}, i);
        if (fresh) continue;
        rows.neighbours[i].push_back(found->second);
        rows.neighbours[found->second].push_back(i);
    }
}

SurfaceRows vertex_rows(const Mesh& mesh) {
    SurfaceRows rows{std::vector<std::vector<std::uint32_t>>(mesh.positions.size()), 0};
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        const auto [a, b, c] = corners(mesh, t);
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
            rows.neighbours[from].push_back(to);
            rows.neighbours[to].push_back(from);
        }
    }
    join_places(mesh, rows);
    return rows;
}

[[noreturn]] void fail(const Surface& surface, const char* what) {
    throw Error(ExitCode::failure,
                "factorization.model: slf: the mesh '" + surface.name + "' " + what);
}

}  // namespace

SurfaceRows rows_of(const Surface& surface, const FactorSettings& settings) {
    const Mesh& mesh = surface.mesh;
    if (mesh.primitive != Primitive::triangles || mesh.indices.size() < 3)
        fail(surface, "is not made of triangles");
    if (!(running_areas(mesh).back() > 0.0)) fail(surface, "has no area");
    if (settings.surface_rows == SurfaceRow::vertices) return vertex_rows(mesh);
    if (mesh.texcoords[0].empty())
        fail(surface, "has no texture coordinates, which surface_rows texels needs");
    return chart_rows(settings.map_size);
}

SurfaceSamples surface_samples(const Surface& surface, const Brdf& brdf,
                               const DistantLights& lights, const FactorSettings& settings,
                               int count, std::uint64_t sequence, int threads) {
    const std::vector<double> areas = running_areas(surface.mesh);
    SurfaceSamples samples;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
        const MeshPoint at = point_of(surface.mesh, areas, sequence, i);
        samples.lighting.at.push_back(view_of(surface, at, sequence, i));
        samples.rows.push_back(row_of(surface, at, settings));
    }
    samples.lighting.radiance = outgoing_radiance(brdf, lights, samples.lighting.at, threads);
    return samples;
}

}  // namespace twofold
