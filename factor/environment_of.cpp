#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "factor/environment_form.hpp"
#include "factor/environment_values.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

constexpr int patch_edge = 8;  // 8 x 8 cells are one patch of lights

/// What each texel of the picture shows.
struct TexelView {
    std::vector<Vec3> direction;
    std::vector<double> solid_angle;  ///< 0: shows nothing
};

TexelView views_of(const FloatImage& image, const std::vector<SquareMap>& maps) {
    TexelView views{std::vector<Vec3>(texel_count(image)),
                    std::vector<double>(texel_count(image), 0.0)};
    for (const SquareMap& map : maps)
        for (int y = 0; y < map.size; ++y)
            for (int x = 0; x < map.size; ++x) {
                const MapPoint point = map.at((2 * x + 1) / static_cast<double>(map.size) - 1.0,
                                              (2 * y + 1) / static_cast<double>(map.size) - 1.0);
                const auto texel =
                    static_cast<std::size_t>(map.top + y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(map.left + x);
                views.direction[texel] = point.direction;
                views.solid_angle[texel] = point.density;
            }
    const double total =
        ordered_sum(views.solid_angle.size(), [&](std::size_t i) { return views.solid_angle[i]; });
    for (double& angle : views.solid_angle) angle *= 4.0 * exact::pi / total;
    return views;
}

/// The picture with 0 where it shows nothing.
FloatImage without_surround(FloatImage image, const TexelView& views) {
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < views.solid_angle.size(); ++i)
        if (views.solid_angle[i] == 0.0)
            std::fill_n(image.samples.begin() + static_cast<std::ptrdiff_t>(i * channels), channels,
                        0.0F);
    return image;
}

int quotient_up(int a, int b) { return (a + b - 1) / b; }

int box_size(const std::vector<SquareMap>& maps, int cells) {
    const auto count = [&](int box) {
        std::int64_t sum = 0;
        for (const SquareMap& map : maps)
            sum += std::int64_t{quotient_up(map.size, box)} * quotient_up(map.size, box);
        return sum;
    };
    int box = 1;
    while (box < maps.front().size && count(box) > cells) ++box;
    return box;
}

/// One light of the texels [x0, x1) x [y0, y1) of the picture, unless they show nothing.
void append_light(DistantLights& lights, const FloatImage& image, const TexelView& views, int x0,
                  int x1, int y0, int y1) {
    Vec3 direction(0.0);
    Rgb weight(0.0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x);
            direction += views.solid_angle[i] * views.direction[i];
            for (int c = 0; c < 3; ++c)
                weight[c] += radiance_value(image, i, c) * views.solid_angle[i];
        }
    if (length(direction) > 0.0) lights.push_back(normalized(direction), weight);
}

/// The cells of a map, patch by patch.
void append_map(DistantLights& lights, const FloatImage& image, const TexelView& views,
                const SquareMap& map, int box) {
    const int edge = quotient_up(map.size, box);
    for (int top = 0; top < edge; top += patch_edge)
        for (int left = 0; left < edge; left += patch_edge)
            for (int row = top; row < std::min(top + patch_edge, edge); ++row)
                for (int column = left; column < std::min(left + patch_edge, edge); ++column)
                    append_light(lights, image, views, map.left + column * box,
                                 map.left + std::min((column + 1) * box, map.size),
                                 map.top + row * box,
                                 map.top + std::min((row + 1) * box, map.size));
}

}  // namespace

Environment environment_of(const FloatImage& image, const EnvironmentSettings& settings,
                           std::string_view name) {
    if (settings.form == EnvironmentForm::latlong) return latitude_longitude(image, settings, name);
    check_cells(settings.cells);
    check_size(image, name);
    const auto maps = maps_of(settings.form, settings.guard, image.width, image.height, name);
    const TexelView views = views_of(image, maps);
    const FloatImage shown = without_surround(image, views);
    if (!settings.repair) refuse_non_finite(shown, name);
    DistantLights lights;
    const int box = box_size(maps, settings.cells);
    for (const SquareMap& map : maps) append_map(lights, shown, views, map, box);
    EnvironmentReport report =
        describe_values(shown, [&](std::size_t i) { return views.solid_angle[i]; });
    report.box = box;
    report.cells = static_cast<int>(lights.size());
    report.solid_angle =
        ordered_sum(views.solid_angle.size(), [&](std::size_t i) { return views.solid_angle[i]; });
    return {bound_blocks(std::move(lights)), report};
}

DistantLights placed(DistantLights lights, const EnvironmentPlacement& placement) {
    if (placement == EnvironmentPlacement{}) return lights;
    const Vec3 across = cross(placement.forward, placement.up);
    if (!(length(across) > 1e-9 * length(placement.forward) * length(placement.up)))
        throw Error(ExitCode::failure, "environment: 'forward' and 'up' span no plane");
    const Vec3 forward = normalized(placement.forward);
    const Vec3 right = normalized(across), up = cross(right, forward);
    DistantLights result;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Vec3 d = lights.direction(k);
        const double x = placement.mirror ? -d.x : d.x;
        result.push_back(normalized(x * right + d.y * up - d.z * forward),
                         placement.scale * lights.weight(k));
    }
    return bound_blocks(std::move(result));
}

}  // namespace twofold
