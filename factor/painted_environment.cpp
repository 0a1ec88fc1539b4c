#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "factor/environment.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

bool usable_direction(Vec3 d) {
    const double squared = dot(d, d);
    return squared > 1e-200 && squared < 1e200;
}

bool usable_radiance(Rgb c) {
    return c.x >= 0.0 && c.y >= 0.0 && c.z >= 0.0 && std::isfinite(c.x + c.y + c.z);
}

Vec3 checked_direction(Vec3 d, const std::string& what) {
    if (!usable_direction(d)) {
        throw Error(ExitCode::failure,
                    fmt::format("{}: direction ({}, {}, {}) is none", what, d.x, d.y, d.z));
    }
    return normalized(d);
}

Rgb checked_radiance(Rgb c, const std::string& what) {
    if (!usable_radiance(c)) {
        throw Error(
            ExitCode::failure,
            fmt::format("{}: ({}, {}, {}) must be finite and not negative", what, c.x, c.y, c.z));
    }
    return c;
}

double cosine_of_half_angle(const DiscLight& disc, const std::string& what) {
    if (!(disc.half_angle > 0.0 && disc.half_angle <= 180.0)) {
        throw Error(
            ExitCode::failure,
            fmt::format("{}: half angle {} is not within 0 to 180 degrees", what, disc.half_angle));
    }
    return disc.half_angle == 180.0 ? -1.0 : exact::cos(disc.half_angle * exact::pi / 180.0);
}

/// Directions of all texel centres, rows from the top (the convention of latitude_longitude).
std::vector<Vec3> texel_directions(int width, int height) {
    std::vector<Vec3> directions;
    for (int y = 0; y < height; ++y) {
        const double t = exact::pi * (y + 0.5) / height;
        for (int x = 0; x < width; ++x) {
            const double p = 2.0 * exact::pi * (x + 0.5) / width - exact::pi;
            directions.emplace_back(exact::sin(t) * exact::sin(p), exact::cos(t),
                                    -exact::sin(t) * exact::cos(p));
        }
    }
    return directions;
}

void put_texel(FloatImage& image, std::size_t texel, Rgb radiance) {
    for (int c = 0; c < 3; ++c) {
        image.samples[3 * texel + static_cast<std::size_t>(c)] = static_cast<float>(radiance[c]);
    }
}

void put_disc(FloatImage& image, const std::vector<Vec3>& directions, const DiscLight& disc,
              const std::string& what) {
    const Vec3 axis = checked_direction(disc.direction, what);
    const double least_cosine = cosine_of_half_angle(disc, what);
    checked_radiance(disc.radiance, what);
    std::size_t covered = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        if (dot(directions[i], axis) >= least_cosine) {
            put_texel(image, i, disc.radiance);
            ++covered;
        }
    }
    if (covered == 0) {
        throw Error(ExitCode::failure,
                    fmt::format("{}: half angle {} degrees covers no texel centre of a {} x {} map",
                                what, disc.half_angle, image.width, image.height));
    }
}

}  // namespace

FloatImage paint(const PaintedEnvironment& environment, int width, int height) {
    if (width < 1 || height < 1 || width > 16384 || height > 16384) {
        throw Error(ExitCode::failure,
                    fmt::format("a painted environment cannot be {} x {}", width, height));
    }
    const auto directions = texel_directions(width, height);
    FloatImage image{width, height, 3, std::vector<float>(3 * directions.size())};
    checked_radiance(environment.background, "background");
    for (std::size_t i = 0; i < directions.size(); ++i) {
        put_texel(image, i, environment.background);
    }
    for (std::size_t k = 0; k < environment.discs.size(); ++k) {
        put_disc(image, directions, environment.discs[k], fmt::format("disc {}", k));
    }
    return image;
}

DistantLights directional_lights(std::span<const DirectionalLight> lights) {
    DistantLights result;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::string what = fmt::format("directional light {}", k);
        result.push_back(checked_direction(lights[k].direction, what),
                         checked_radiance(lights[k].irradiance, what));
    }
    return bound_blocks(std::move(result));
}

}  // namespace twofold
