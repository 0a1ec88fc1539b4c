#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/raster/random/random_parts.hpp"

/// Meshes of every kind of triangle that has made trouble. Shapes are thought of in the window and
/// then put where the view sees them there.
namespace twofold::test {
namespace {

/// A mesh while shapes are added to it.
struct Builder {
    Dice& dice;
    const View& view;
    double radius;  ///< pixels, of a usual triangle
    double grid;    ///< positions are multiples of it; 0: any
    bool few_depths;
    std::vector<Spot> spots{};
    std::vector<std::uint32_t> indices{};

    double on_grid(double x) const { return grid > 0.0 ? std::floor(x / grid) * grid : x; }
    double depth() {
        if (few_depths) return dice.one_of({0.25, 0.5, 0.75});
        return dice.chance(0.03) ? dice.real(-0.5, 1.5) : dice.real(0.02, 0.98);
    }
    Spot near(const Spot& centre, double reach) {
        return {on_grid(centre.x + dice.real(-reach, reach)),
                on_grid(centre.y + dice.real(-reach, reach)), depth()};
    }
    Spot anywhere() {
        return {on_grid(dice.real(-0.1, 1.1) * view.width),
                on_grid(dice.real(-0.1, 1.1) * view.height), depth()};
    }
    std::uint32_t add(const Spot& spot) {
        spots.push_back(spot);
        return static_cast<std::uint32_t>(spots.size() - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        indices.insert(indices.end(), {a, b, c});
    }
};

void add_plain(Builder& b, double radius) {
    const Spot centre = b.anywhere();
    const std::uint32_t first = b.add(b.near(centre, radius));
    b.add(b.near(centre, radius));
    b.add(b.near(centre, radius));
    b.triangle(first, first + 1, first + 2);
}

/// Thinner than a pixel, as long as a usual triangle.
void add_sliver(Builder& b) {
    const Spot from = b.anywhere(), to = b.near(from, b.radius);
    Spot beside = to;
    beside.x += b.dice.one_of({1.0 / 16, -1.0 / 16, 0.0, 0.3});
    beside.y += b.dice.one_of({1.0 / 16, -1.0 / 16, 0.0, 0.3});
    const std::uint32_t first = b.add(from);
    b.add(to);
    b.add(beside);
    b.triangle(first, first + 1, first + 2);
}

/// Triangles around a point, which share its edges.
void add_fan(Builder& b) {
    const Spot centre = b.anywhere();
    const auto n = static_cast<std::uint32_t>(b.dice.integer(3, 8));
    const std::uint32_t first = b.add(centre);
    for (std::uint32_t k = 0; k < n; ++k) b.add(b.near(centre, b.radius));
    for (std::uint32_t k = 0; k < n; ++k) b.triangle(first, first + 1 + k, first + 1 + (k + 1) % n);
}

/// All of one depth, or of one plane through the window, so that copies tie with it.
void add_cover(Builder& b) {
    const double left = b.depth(), right = b.dice.chance(0.5) ? left : b.depth();
    const double w = b.view.width, h = b.view.height, beyond = b.dice.chance(0.2) ? 10.0 * w : 0.0;
    const std::uint32_t first = b.add({-beyond, h, left});
    b.add({w + beyond, h, right});
    b.add({w, 0, right});
    b.add({0, 0, left});
    b.triangle(first, first + 1, first + 2);
    b.triangle(first, first + 2, first + 3);
}

/// An earlier triangle again: the same vertices, turned or not.
void add_copy(Builder& b) {
    if (b.indices.empty()) return add_plain(b, b.radius);
    const std::size_t i = 3 * b.dice.index(b.indices.size() / 3);
    const std::array<std::uint32_t, 3> v{b.indices[i], b.indices[i + 1], b.indices[i + 2]};
    if (b.dice.chance(0.5)) return b.triangle(v[1], v[2], v[0]);
    const std::uint32_t first = b.add(b.spots[v[0]]);
    b.add(b.spots[v[1]]);
    b.add(b.spots[v[2]]);
    b.triangle(first, first + 1, first + 2);
}

void add_degenerate(Builder& b) {
    const std::uint32_t first = b.add(b.anywhere());
    b.add(b.near(b.spots[first], b.radius));
    b.triangle(first, first + 1, b.dice.chance(0.5) ? first : first + 1);
}

/// Reaches behind the eye in a perspective view, beyond the depth range in others.
void add_crossing(Builder& b) {
    add_plain(b, b.radius);
    Spot& last = b.spots.back();
    last.depth = b.dice.one_of({-0.125, -0.3, -2.0, 0.0, 5.0});
}

void add_shape(Builder& b, bool may_cover) {
    const double kind = b.dice.unit();
    if (kind < 0.45) return add_plain(b, b.radius);
    if (kind < 0.53) return add_plain(b, 0.7);
    if (kind < 0.60) return add_sliver(b);
    if (kind < 0.70) return add_fan(b);
    if (kind < 0.80) return add_copy(b);
    if (kind < 0.84) return add_degenerate(b);
    if (kind < 0.90) return add_crossing(b);
    if (!may_cover) return add_plain(b, b.radius);
    return kind < 0.96 ? add_cover(b) : add_plain(b, 30.0 * b.view.width);
}

std::vector<Vec4> random_coords(Dice& dice, const View& view, const std::vector<Spot>& spots) {
    const int kind = dice.integer(0, 4);
    const double turn = dice.real(-0.3, 0.3), zoom = dice.one_of({1.0, 1.0, 2.5, 0.1, 8.0});
    std::vector<Vec4> coords;
    for (const Spot& p : spots) {
        const double x = p.x / view.width, y = p.y / view.height;
        Vec4 c{zoom * (x + turn * y), zoom * (y - turn * x), 0.0, 1.0};
        if (kind == 3) c = {dice.real(-2, 3), dice.real(-2, 3), dice.real(-1, 1), 1.0};
        if (kind == 4) c.w = dice.chance(0.05) ? 0.0 : dice.real(-0.1, 2.0);
        coords.push_back(c);
    }
    return coords;
}

std::vector<Vec4> random_colors(Dice& dice, std::size_t n) {
    std::vector<Vec4> colors;
    for (std::size_t i = 0; i < n; ++i) colors.push_back(random_color(dice));
    return colors;
}

/// What the vertices of window space may have instead of w = 1. Not below 0: between vertices on
/// both sides of the eye colours are extrapolated, and no rule says how far.
std::vector<double> random_w(Dice& dice, std::size_t n) {
    std::vector<double> w;
    for (std::size_t i = 0; i < n; ++i)
        w.push_back(dice.chance(0.03) ? dice.one_of({0.0, 1e-30, -0.0, -1.0, 1e9})
                                      : dice.real(0.25, 4.0));
    return w;
}

Mesh mesh_of(Builder& b) {
    Mesh mesh;
    const std::size_t n = b.spots.size();
    for (const Spot& p : b.spots) mesh.positions.push_back(b.view.position_at(p));
    mesh.indices = std::move(b.indices);
    for (auto& set : mesh.texcoords)
        if (&set == mesh.texcoords.data() || b.dice.chance(0.2))
            set = random_coords(b.dice, b.view, b.spots);
    for (std::size_t i = 0; i < n; ++i) mesh.normals.push_back(random_direction(b.dice));
    if (b.dice.chance(0.5)) mesh.colors = random_colors(b.dice, n);
    if (b.dice.chance(0.3)) mesh.secondary_colors = random_colors(b.dice, n);
    if (b.view.space == Space::window && b.dice.chance(0.5)) mesh.position_w = random_w(b.dice, n);
    return mesh;
}

/// One vertex that no file would hold.
void spoil(Dice& dice, Mesh& mesh) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    mesh.positions[dice.index(mesh.positions.size())].x =
        dice.one_of({1e30, -1e30, 1e300, infinity, not_a_number, 1e18});
}

/// Any vertices in a row, as strips, fans, quads or polygons.
void add_row(Builder& b, int vertices) {
    Spot at = b.anywhere();
    for (int k = 0; k < vertices; ++k) {
        at = b.dice.chance(0.1) ? b.anywhere() : b.near(at, b.radius);
        b.add(at);
        b.indices.push_back(static_cast<std::uint32_t>(
            b.dice.chance(0.05) ? b.dice.index(b.spots.size()) : b.spots.size() - 1));
    }
}

Builder start(Dice& dice, const View& view, double area, int triangles) {
    const double window = std::sqrt(static_cast<double>(view.width) * view.height);
    const double radius = std::sqrt(area / triangles);
    const double grid = dice.one_of({0.0, 0.0, 0.0, 0.5, 1.0, 1.0 / 16});
    return {dice, view, radius < window ? radius : window, grid, dice.chance(0.4)};
}

}  // namespace

Mesh random_mesh(Dice& dice, const View& view, double area) {
    const int triangles = dice.chance(0.3) ? dice.integer(1, 3) : dice.integer(1, 40);
    const bool may_cover = static_cast<double>(view.width) * view.height < 0.4 * area;
    Builder b = start(dice, view, area, triangles);
    const auto primitive =
        dice.chance(0.25) ? dice.up_to(Primitive::polygon) : Primitive::triangles;
    if (primitive == Primitive::triangles)
        while (static_cast<int>(b.indices.size()) < 3 * triangles) add_shape(b, may_cover);
    else
        add_row(b, 2 * dice.integer(1, 3 + triangles / 2));
    if (primitive == Primitive::quads) b.indices.resize(b.indices.size() / 4 * 4);
    Mesh mesh = mesh_of(b);
    mesh.primitive = primitive;
    if (dice.chance(0.004)) spoil(dice, mesh);
    return mesh;
}

Mesh random_surface(Dice& dice, const View& view, double area) {
    Builder b = start(dice, view, area, 1);
    const auto nx = static_cast<std::uint32_t>(dice.integer(1, 5));
    const auto ny = static_cast<std::uint32_t>(dice.integer(1, 4));
    const double middle = dice.real(0.2, 0.8),
                 bulge = dice.chance(0.3) ? 0.0 : dice.real(-0.2, 0.2);
    std::vector<Vec3> normals;
    for (std::uint32_t j = 0; j <= ny; ++j)
        for (std::uint32_t i = 0; i <= nx; ++i) {
            const double u = static_cast<double>(i) / nx, v = static_cast<double>(j) / ny;
            const Vec3 n{2.4 * u - 1.2, 1.2 - 2.4 * v, 1.1 - u * u - v * v};
            b.add({(1.1 * u - 0.05) * view.width, (1.1 * v - 0.05) * view.height,
                   middle + bulge * (u * (1.0 - u) + v)});
            normals.push_back(normalized(n + 0.1 * random_direction(dice)));
        }
    for (std::uint32_t j = 0; j < ny; ++j)
        for (std::uint32_t i = 0; i < nx; ++i) {
            const std::uint32_t first = j * (nx + 1) + i, above = first + nx + 1;
            b.triangle(first, above, above + 1);
            b.triangle(first, above + 1, first + 1);
        }
    for (int k = dice.integer(0, 3); k > 0; --k) add_copy(b);
    if (dice.chance(0.2)) add_crossing(b);
    normals.resize(b.spots.size(), normals.front());
    Mesh mesh = mesh_of(b);
    mesh.normals = normals;
    return mesh;
}

}  // namespace twofold::test
