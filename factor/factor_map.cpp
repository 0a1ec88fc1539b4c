#include "factor/factor_map.hpp"

#include <fmt/format.h>

#include <cmath>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"

namespace twofold {

namespace {

void require_finite(double value, std::size_t index, const MapShape& shape,
                    const std::string& name) {
    if (std::isfinite(value)) return;
    const ParaboloidTexel texel = texel_at(index, shape);
    throw Error(ExitCode::failure,
                fmt::format("factor {}: texel ({}, {}) of the {} face is {}", name, texel.x,
                            texel.y, texel.face == Face::front ? "front" : "back", value));
}

bool is_opaque(std::size_t index, const MapShape& shape) {
    const ParaboloidTexel texel = texel_at(index, shape);
    return texel_is_opaque(texel.x, texel.y, shape.size, shape.guard);
}

Rgba32f real_texel(const std::array<double, 3>& rgb, bool opaque) {
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
            opaque ? 1.0F : 0.0F};
}

Rgba8 byte_texel(const std::array<double, 3>& rgb, bool opaque) {
    return {to_byte(rgb[0]), to_byte(rgb[1]), to_byte(rgb[2]),
            opaque ? std::uint8_t{255} : std::uint8_t{0}};
}

}  // namespace

NormalisedChannel normalised(std::span<const double> log_texels, const MapShape& shape,
                             const std::string& name) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < log_texels.size(); ++j) {
        require_finite(log_texels[j], j, shape, name);
        if (is_opaque(j, shape)) largest = max(largest, log_texels[j]);
    }
    // Divided as logarithms: nothing overflows, however far the maximum is from 1.
    NormalisedChannel channel{std::vector<double>(log_texels.size()), largest};
    for (std::size_t j = 0; j < log_texels.size(); ++j) {
        channel.texel[j] = exact::exp(min(log_texels[j] - largest, 0.0));
    }
    return channel;
}

NormalisedChannel black_channel(const MapShape& shape) {
    return {std::vector<double>(shape.texels(), 0.0), 0.0};
}

FactorMap make_factor_map(const std::array<NormalisedChannel, 3>& channels, const MapShape& shape,
                          const std::string& name) {
    FactorMap map{shape, {}, {}, {}};
    for (std::size_t face = 0; face < 2; ++face) {
        std::vector<Rgba32f> real(shape.face_texels());
        std::vector<Rgba8> bytes(shape.face_texels());
        for (std::size_t i = 0; i < shape.face_texels(); ++i) {
            const std::size_t j = face * shape.face_texels() + i;
            std::array<double, 3> rgb{};
            for (std::size_t c = 0; c < 3; ++c) {
                rgb[c] = channels[c].texel[j];
                require_finite(rgb[c], j, shape, fmt::format("{} {}", name, channel_name(c)));
            }
            real[i] = real_texel(rgb, is_opaque(j, shape));
            bytes[i] = byte_texel(rgb, is_opaque(j, shape));
        }
        map.real[face] = {shape.size, shape.size, std::move(real)};
        map.bytes[face] = {shape.size, shape.size, std::move(bytes)};
    }
    for (std::size_t c = 0; c < 3; ++c) map.loss[c] = byte_loss(channels[c].texel, shape);
    return map;
}

ByteLoss byte_loss(std::span<const double> texels, const MapShape& shape) {
    std::array<std::size_t, 256> histogram{};
    std::size_t opaque = 0;
    for (std::size_t j = 0; j < texels.size(); ++j) {
        if (!is_opaque(j, shape)) continue;
        ++opaque;
        ++histogram[to_byte(texels[j])];
    }
    int levels = 0;
    for (const std::size_t count : histogram) levels += count > 0 ? 1 : 0;
    return {levels > 0 ? levels - 1 : 0,
            static_cast<double>(histogram[0]) / static_cast<double>(opaque)};
}

std::uint8_t to_byte(double x) {
    return static_cast<std::uint8_t>(to_fixed_half_up(255.0 * x, 0, 255));
}

ScaleSplit split_scale(Rgb c) {
    ScaleSplit split;
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(c[i]) && c[i] >= 0.0) continue;
        throw Error(ExitCode::failure,
                    fmt::format("factor: scale constant of channel {} is {}",
                                channel_name(static_cast<std::size_t>(i)), c[i]));
    }
    const double largest = max_component(c);
    while (split.combiner_scale < 4 && split.combiner_scale < largest) split.combiner_scale *= 2;
    double scale = split.combiner_scale;
    for (; scale < largest; scale *= 2.0) ++split.doubling_passes;
    split.color = c / scale;

    if (split.doubling_passes > 0) {
        split.warnings.push_back(
            fmt::format("scale constant {:.6g} exceeds the combiner's 4: {} doubling passes needed",
                        largest, split.doubling_passes));
    }
    for (int i = 0; i < 3; ++i) {
        if (c[i] == 0.0 || split.color[i] >= 1.0 / 510.0) continue;
        split.warnings.push_back(
            fmt::format("channel {} vanishes: vertex colour {:.6g} is 0 in 8 bits",
                        channel_name(static_cast<std::size_t>(i)), split.color[i]));
    }
    return split;
}

const char* channel_name(std::size_t channel) {
    return channel == 0 ? "red" : channel == 1 ? "green" : "blue";
}

}  // namespace twofold
