#include "scenes/mesh_file.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "scenes/mesh_normals.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

auto as_tuple(Vec3 a) { return std::tuple(a.x, a.y, a.z); }

/// For each vertex the number of its position; equal positions (0 equals -0) have equal numbers.
std::vector<std::uint32_t> position_numbers(const std::vector<Vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return as_tuple(positions[a]) < as_tuple(positions[b]);
    });
    std::vector<std::uint32_t> numbers(positions.size());
    std::uint32_t number = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (positions[order[i]] != positions[order[i - 1]]) ++number;
        numbers[order[i]] = number;
    }
    return numbers;
}

Edge edge_between(std::uint32_t a, std::uint32_t b) { return std::minmax({a, b}); }

Vec3 bounding_box_centre(const Mesh& mesh) {
    if (mesh.positions.empty()) return Vec3(0.0);
    Vec3 low = mesh.positions[0];
    Vec3 high = low;
    for (const Vec3& p : mesh.positions)
        for (int c = 0; c < 3; ++c) {
            low[c] = p[c] < low[c] ? p[c] : low[c];
            high[c] = p[c] > high[c] ? p[c] : high[c];
        }
    return low * 0.5 + high * 0.5;
}

/// Counts runs of equal edges in the sorted list: a run's length is the number of triangles there.
void count_edges(std::vector<Edge> edges, MeshReport& report) {
    std::stable_sort(edges.begin(), edges.end());
    for (auto run = edges.begin(); run != edges.end();) {
        const auto end = std::find_if(run, edges.end(), [&](const Edge& e) { return e != *run; });
        if (end - run == 1) ++report.boundary_edges;
        if (end - run > 2) ++report.non_manifold_edges;
        run = end;
    }
}

/// Each triangle makes a tetrahedron with the centre; inward ones take away. Degenerate ones add
/// zero.
double signed_volume(const Mesh& mesh) {
    const Vec3 centre = bounding_box_centre(mesh);
    const auto corner = [&](std::size_t i) { return mesh.positions[mesh.indices[i]] - centre; };
    return ordered_sum(mesh.indices.size() / 3, [&](std::size_t t) {
        return dot(corner(3 * t), cross(corner(3 * t + 1), corner(3 * t + 2))) / 6.0;
    });
}

bool is_degenerate(const Mesh& mesh, std::size_t i) {
    const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[k]]; };
    return area_vector(corner(i), corner(i + 1), corner(i + 2)) == Vec3(0.0);
}

}  // namespace

MeshReport inspect(const Mesh& mesh) {
    const auto number = position_numbers(mesh.positions);
    MeshReport report;
    report.triangles = mesh.indices.size() / 3;
    std::vector<Edge> edges;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        if (is_degenerate(mesh, i)) {
            ++report.degenerate;
            continue;
        }
        const auto a = number[mesh.indices[i]];
        const auto b = number[mesh.indices[i + 1]];
        const auto c = number[mesh.indices[i + 2]];
        edges.insert(edges.end(), {edge_between(a, b), edge_between(b, c), edge_between(c, a)});
    }
    count_edges(std::move(edges), report);
    report.signed_volume = signed_volume(mesh);
    report.inverted = report.signed_volume < 0.0;
    return report;
}

}  // namespace twofold
