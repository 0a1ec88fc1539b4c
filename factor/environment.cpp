#include "factor/environment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "factor/environment_values.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

constexpr int tile_edge = 16;  // 16 x 16 cells are one block of lights
constexpr int patch_edge = 8;  // 8 x 8 cells are one patch of it

/// A grid of cells over the picture; with m > 1 over the picture cut into m x m pieces a texel.
struct CellGrid {
    int box = 1;
    int split = 1;
    int fine_width = 0, fine_height = 0;  ///< texels after the cut
    int columns = 0, rows = 0;            ///< cells
};

/// Half-open ranges of fine texels.
struct CellExtent {
    int x0, x1, y0, y1;
};

std::int64_t quotient_up(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

CellGrid choose_grid(int width, int height, int cells) {
    CellGrid grid;
    while (quotient_up(width, grid.box) * quotient_up(height, grid.box) > cells) {
        ++grid.box;
    }
    const std::int64_t texels = static_cast<std::int64_t>(width) * height;
    while (grid.box == 1 && texels * (grid.split + 1) * (grid.split + 1) <= cells) {
        ++grid.split;
    }
    grid.fine_width = width * grid.split;
    grid.fine_height = height * grid.split;
    grid.columns = static_cast<int>(quotient_up(grid.fine_width, grid.box));
    grid.rows = static_cast<int>(quotient_up(grid.fine_height, grid.box));
    return grid;
}

/// Solid angle of one texel of each row: rows are summed exactly by differences of cosines, which
/// also makes all of them together 4 pi.
std::vector<double> row_solid_angles(int width, int height) {
    std::vector<double> angles;
    double above = 1.0;
    for (int y = 0; y < height; ++y) {
        const double below = exact::cos(exact::pi * (y + 1) / height);
        angles.push_back(2.0 * exact::pi / width * (above - below));
        above = below;
    }
    return angles;
}

/// World direction of a point of the picture, in texels from its left upper corner.
Vec3 picture_direction(double x, double y, int width, int height) {
    const double t = exact::pi * y / height;
    const double p = 2.0 * exact::pi * x / width - exact::pi;
    const double sine = exact::sin(t);
    return normalized(Vec3(sine * exact::sin(p), exact::cos(t), -sine * exact::cos(p)));
}

CellExtent cell_extent(const CellGrid& grid, int column, int row) {
    return {column * grid.box, std::min((column + 1) * grid.box, grid.fine_width), row * grid.box,
            std::min((row + 1) * grid.box, grid.fine_height)};
}

/// Sum over the fine texels of a cell, rows from the top, of value(x, y) times solid angle.
template <class Value>
double cell_sum(const CellExtent& cell, const std::vector<double>& solid_angles,
                const Value& value) {
    const std::size_t width = static_cast<std::size_t>(cell.x1 - cell.x0);
    const std::size_t height = static_cast<std::size_t>(cell.y1 - cell.y0);
    return ordered_sum(width * height, [&](std::size_t i) {
        const int x = cell.x0 + static_cast<int>(i % width);
        const int y = cell.y0 + static_cast<int>(i / width);
        return value(x, y) * solid_angles[static_cast<std::size_t>(y)];
    });
}

Rgb cell_weight(const FloatImage& image, const CellGrid& grid, const CellExtent& cell,
                const std::vector<double>& solid_angles) {
    Rgb weight;
    for (int c = 0; c < 3; ++c) {
        weight[c] = cell_sum(cell, solid_angles, [&](int x, int y) {
            const std::size_t row = static_cast<std::size_t>(y / grid.split);
            const std::size_t column = static_cast<std::size_t>(x / grid.split);
            const std::size_t width = static_cast<std::size_t>(image.width);
            return radiance_value(image, row * width + column, c);
        });
    }
    return weight;
}

/// The cells of one square of the grid, rows from the top, in four smaller squares where it is
/// larger than a patch of lights.
void append_square(std::vector<CellExtent>& cells, const CellGrid& grid, int left, int top,
                   int edge) {
    if (edge > patch_edge) {
        const int half = edge / 2;
        for (int quarter = 0; quarter < 4; ++quarter) {
            append_square(cells, grid, left + quarter % 2 * half, top + quarter / 2 * half, half);
        }
        return;
    }
    for (int row = top; row < std::min(top + edge, grid.rows); ++row) {
        for (int column = left; column < std::min(left + edge, grid.columns); ++column) {
            cells.push_back(cell_extent(grid, column, row));
        }
    }
}

/// All cells, tile by tile from the left upper corner.
std::vector<CellExtent> tiled_cells(const CellGrid& grid) {
    std::vector<CellExtent> cells;
    for (int top = 0; top < grid.rows; top += tile_edge) {
        for (int left = 0; left < grid.columns; left += tile_edge) {
            append_square(cells, grid, left, top, tile_edge);
        }
    }
    return cells;
}

DistantLights cell_lights(const FloatImage& image, const CellGrid& grid) {
    const auto solid_angles = row_solid_angles(grid.fine_width, grid.fine_height);
    DistantLights lights;
    for (const CellExtent& cell : tiled_cells(grid)) {
        lights.push_back(picture_direction(0.5 * (cell.x0 + cell.x1), 0.5 * (cell.y0 + cell.y1),
                                           grid.fine_width, grid.fine_height),
                         cell_weight(image, grid, cell, solid_angles));
    }
    return lights;
}

double total_solid_angle(const CellGrid& grid) {
    const auto solid_angles = row_solid_angles(grid.fine_width, grid.fine_height);
    const auto cells = tiled_cells(grid);
    return ordered_sum(cells.size(), [&](std::size_t k) {
        return cell_sum(cells[k], solid_angles, [](int, int) { return 1.0; });
    });
}

EnvironmentReport describe(const FloatImage& image, const CellGrid& grid) {
    const auto solid_angles = row_solid_angles(image.width, image.height);
    const std::size_t width = static_cast<std::size_t>(image.width);
    EnvironmentReport report =
        describe_values(image, [&](std::size_t i) { return solid_angles[i / width]; });
    report.box = grid.box;
    report.split = grid.split;
    report.cells = grid.columns * grid.rows;
    report.solid_angle = total_solid_angle(grid);
    return report;
}

}  // namespace

Environment latitude_longitude(const FloatImage& image, const EnvironmentSettings& settings,
                               std::string_view name) {
    check_cells(settings.cells);
    check_size(image, name);
    if (!settings.repair) {
        refuse_non_finite(image, name);
    }
    const CellGrid grid = choose_grid(image.width, image.height, settings.cells);
    return {bound_blocks(cell_lights(image, grid)), describe(image, grid)};
}

DistantLights constant_environment(Rgb radiance, int cells) {
    check_cells(cells);
    // Twice as wide as high, like every latitude-longitude map, so that cells are nearly square.
    const int width = cells < 2 ? 1 : 2;
    const FloatImage white{width, 1, 1, std::vector<float>(static_cast<std::size_t>(width), 1.0F)};
    const DistantLights lights = cell_lights(white, choose_grid(width, 1, cells));
    DistantLights result;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        result.push_back(lights.direction(k), lights.weight(k) * radiance);
    }
    return bound_blocks(std::move(result));
}

}  // namespace twofold
