#include "factor/environment_form.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

const Vec3 x_axis(1.0, 0.0, 0.0), y_axis(0.0, 1.0, 0.0), z_axis(0.0, 0.0, 1.0);

/// A cube's face: its centre, and the directions in which its columns and rows run.
struct CubeSide {
    Vec3 centre, right, down;
};

MapPoint on_cube(const CubeSide& side, double a, double b) {
    const double square = 1.0 + a * a + b * b;
    return {normalized(side.centre + a * side.right + b * side.down),
            1.0 / (square * std::sqrt(square))};
}

/// Debevec's angular map: the angle from forward grows with the distance from the centre.
MapPoint on_probe(double a, double b) {
    const double radius = std::sqrt(a * a + b * b);
    if (radius > 1.0) return {};
    const double t = exact::pi * radius;
    const double over = t > 1e-6 ? exact::sin(t) / t : 1.0;
    return {normalized(Vec3(exact::pi * over * a, -exact::pi * over * b, -exact::cos(t))),
            exact::pi * exact::pi * over};
}

MapPoint on_paraboloid(double sign, double guard, double a, double b) {
    const double x = a / guard, y = -b / guard;
    const double square = x * x + y * y;
    if (square > 1.0) return {};
    const double over = 1.0 / (1.0 + square);
    return {Vec3(2.0 * over * x, 2.0 * over * y, sign * (1.0 - square) * over),
            4.0 * over * over / (guard * guard)};
}

SquareMap cube_map_at(int column, int row, int size, const CubeSide& side) {
    return {column * size, row * size, size,
            [side](double a, double b) { return on_cube(side, a, b); }};
}

std::vector<SquareMap> cross_maps(int size, bool upright) {
    const CubeSide up{y_axis, x_axis, -z_axis}, left{-x_axis, -z_axis, -y_axis},
        forward{-z_axis, x_axis, -y_axis}, right{x_axis, z_axis, -y_axis},
        down{-y_axis, x_axis, z_axis}, back{z_axis, -x_axis, -y_axis},
        back_below{z_axis, x_axis, y_axis};
    return {cube_map_at(1, 0, size, up),
            cube_map_at(0, 1, size, left),
            cube_map_at(1, 1, size, forward),
            cube_map_at(2, 1, size, right),
            cube_map_at(1, 2, size, down),
            upright ? cube_map_at(1, 3, size, back_below) : cube_map_at(3, 1, size, back)};
}

/// @source OpenGL 1.3, table 3.20: s runs along the columns and t down the rows
constexpr int opengl_layout = 1;
/// @source OpenEXR, ImfEnvmap.h: each face as it is seen from inside
constexpr int openexr_layout = -1;

std::vector<SquareMap> strip_maps(int size, bool upright, double hand) {
    const std::array<CubeSide, 6> sides{{{x_axis, -hand * z_axis, -y_axis},
                                         {-x_axis, hand * z_axis, -y_axis},
                                         {y_axis, x_axis, hand * z_axis},
                                         {-y_axis, x_axis, -hand * z_axis},
                                         {z_axis, hand * x_axis, -y_axis},
                                         {-z_axis, -hand * x_axis, -y_axis}}};
    std::vector<SquareMap> maps;
    for (int i = 0; i < 6; ++i)
        maps.push_back(cube_map_at(upright ? 0 : i, upright ? i : 0, size,
                                   sides[static_cast<std::size_t>(i)]));
    return maps;
}

std::vector<SquareMap> paraboloid_maps(int size, bool upright, double guard) {
    const auto face = [guard](double sign) {
        return [sign, guard](double a, double b) { return on_paraboloid(sign, guard, a, b); };
    };
    return {{0, 0, size, face(1.0)}, {upright ? 0 : size, upright ? size : 0, size, face(-1.0)}};
}

/// Edge of a map where the picture has `across` x `along` of them in either order.
int map_size(int width, int height, int across, int along) {
    const int size = width / across;
    return size >= 1 && size * across == width && size * along == height ? size : 0;
}

[[noreturn]] void fail(std::string_view name, int width, int height, std::string_view wanted) {
    throw Error(ExitCode::bad_file,
                fmt::format("{}: {} x {} texels are not {}", name, width, height, wanted));
}

}  // namespace

std::vector<SquareMap> maps_of(EnvironmentForm form, double guard, int width, int height,
                               std::string_view name) {
    const auto size_of = [&](int across, int along, std::string_view wanted) {
        const int flat = map_size(width, height, across, along);
        const int upright = map_size(width, height, along, across);
        if (flat + upright == 0) fail(name, width, height, wanted);
        return std::pair(flat + upright, upright > 0);
    };
    if (form == EnvironmentForm::probe) {
        if (width != height) fail(name, width, height, "the square of an angular probe");
        return {{0, 0, width, on_probe}};
    }
    if (form == EnvironmentForm::cube_cross) {
        const auto [size, upright] = size_of(4, 3, "a cross of 4 x 3 or 3 x 4 faces");
        return cross_maps(size, upright);
    }
    if (form == EnvironmentForm::dual_paraboloid) {
        const auto [size, upright] = size_of(2, 1, "a pair of square maps");
        return paraboloid_maps(size, upright, guard);
    }
    const auto [size, upright] = size_of(6, 1, "a strip of six faces");
    return strip_maps(size, upright,
                      form == EnvironmentForm::cube_strip ? opengl_layout : openexr_layout);
}

}  // namespace twofold
