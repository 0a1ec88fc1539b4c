#include "factor/environment_values.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "texunit/error.hpp"
#include "texunit/ordered_sum.hpp"

namespace twofold {
namespace {

int colour_channels(const FloatImage& image) { return image.channels >= 3 ? 3 : 1; }

/// The value as the file has it.
double stored_value(const FloatImage& image, std::size_t texel, int channel) {
    const std::size_t sample =
        texel * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(channel);
    return static_cast<double>(image.samples[sample]);
}

/// The part of the report that counts values.
EnvironmentReport count_values(const FloatImage& image) {
    EnvironmentReport report;
    for (std::size_t texel = 0; texel < texel_count(image); ++texel) {
        for (int c = 0; c < colour_channels(image); ++c) {
            const double value = stored_value(image, texel, c);
            const bool finite = std::isfinite(value);
            report.non_finite += finite ? 0 : 1;
            report.negative += finite && value < 0.0 ? 1 : 0;
            report.least_value = finite && value < report.least_value ? value : report.least_value;
        }
    }
    report.ignored_channels = image.channels - colour_channels(image);
    report.negative_share = static_cast<double>(report.negative) /
                            (static_cast<double>(texel_count(image)) * colour_channels(image));
    return report;
}

struct BrightestTexel {
    std::size_t texel = 0;
    double share = 0.0;
};

/// The texel with most radiance * solid angle, the first of equals, and its share of all.
BrightestTexel brightest_texel(const FloatImage& image,
                               const std::function<double(std::size_t)>& solid_angle) {
    const auto energy = [&](std::size_t i) {
        return (radiance_value(image, i, 0) + radiance_value(image, i, 1) +
                radiance_value(image, i, 2)) *
               solid_angle(i);
    };
    BrightestTexel brightest;
    double most = 0.0;
    for (std::size_t i = 0; i < texel_count(image); ++i) {
        brightest.texel = energy(i) > most ? i : brightest.texel;
        most = energy(i) > most ? energy(i) : most;
    }
    const double total = ordered_sum(texel_count(image), energy);
    brightest.share = total > 0.0 ? most / total : 0.0;
    return brightest;
}

}  // namespace

void check_size(const FloatImage& image, std::string_view name) {
    constexpr int limit = 16384;
    const bool sane = image.width >= 1 && image.width <= limit && image.height >= 1 &&
                      image.height <= limit && image.channels >= 1 && image.channels != 2;
    const std::size_t texels =
        sane ? static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) : 0;
    if (!sane || image.samples.size() != texels * static_cast<std::size_t>(image.channels)) {
        throw Error(
            ExitCode::bad_file,
            fmt::format("{}: {} x {} texels of {} channels ({} values) are no environment", name,
                        image.width, image.height, image.channels, image.samples.size()));
    }
}

void check_cells(int cells) {
    if (cells < 1) {
        throw Error(ExitCode::failure, fmt::format("cells = {} must be 1 or more", cells));
    }
}

std::size_t texel_count(const FloatImage& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

double radiance_value(const FloatImage& image, std::size_t texel, int channel) {
    const double value = stored_value(image, texel, image.channels >= 3 ? channel : 0);
    return value > 0.0 && std::isfinite(value) ? value : 0.0;
}

void refuse_non_finite(const FloatImage& image, std::string_view name) {
    constexpr std::array<std::string_view, 3> names = {"red", "green", "blue"};
    for (std::size_t texel = 0; texel < texel_count(image); ++texel) {
        for (int c = 0; c < colour_channels(image); ++c) {
            const double value = stored_value(image, texel, c);
            if (!std::isfinite(value)) {
                const std::size_t width = static_cast<std::size_t>(image.width);
                throw Error(ExitCode::bad_file,
                            fmt::format("{}: texel ({}, {}), {}: {} is no radiance; ask for repair "
                                        "to read it as 0",
                                        name, texel % width, texel / width,
                                        names[static_cast<std::size_t>(c)], value));
            }
        }
    }
}

EnvironmentReport describe_values(const FloatImage& image,
                                  const std::function<double(std::size_t)>& solid_angle) {
    EnvironmentReport report = count_values(image);
    report.width = image.width;
    report.height = image.height;
    const BrightestTexel brightest = brightest_texel(image, solid_angle);
    const std::size_t width = static_cast<std::size_t>(image.width);
    report.brightest = {static_cast<int>(brightest.texel % width),
                        static_cast<int>(brightest.texel / width)};
    report.brightest_share = brightest.share;
    return report;
}

}  // namespace twofold
