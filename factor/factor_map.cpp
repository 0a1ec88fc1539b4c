#include "factor/factor_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/fixed.hpp"

namespace twofold {

namespace {

void require_finite(double value, std::size_t index, const MapShape& shape,
                    const std::string& name) {
    if (std::isfinite(value)) return;
    const MapTexel texel = texel_at(index, shape);
    throw Error(ExitCode::failure,
                fmt::format("factor {}: texel ({}, {}) of the {} face is {}", name, texel.x,
                            texel.y, face_name(texel.face, shape.form), value));
}

bool is_opaque(std::size_t index, const MapShape& shape) {
    return is_opaque(texel_at(index, shape), shape);
}

Rgba32f real_texel(const std::array<double, 3>& rgb, bool opaque) {
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
            opaque ? 1.0F : 0.0F};
}

Rgba8 byte_texel(const std::array<double, 3>& rgb, bool opaque) {
    return {to_byte(rgb[0]), to_byte(rgb[1]), to_byte(rgb[2]),
            opaque ? std::uint8_t{255} : std::uint8_t{0}};
}

/// The faces as textures: paraboloids one each, a cube's in one.
std::vector<Texture> textures_of(std::vector<Texels> faces, const MapShape& shape) {
    std::vector<Texture> textures;
    for (std::size_t face = 0; face < faces.size(); ++face)
        if (face == 0 || shape.form == MapForm::dual_paraboloid)
            textures.push_back({shape.size, shape.size, std::move(faces[face])});
        else
            textures[0].cube_faces.push_back({shape.size, shape.size, std::move(faces[face])});
    return textures;
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

NormalisedChannel normalised_values(std::vector<double> texels, const MapShape& shape) {
    double largest = 0.0;
    for (std::size_t j = 0; j < texels.size(); ++j)
        if (is_opaque(j, shape)) largest = max(largest, texels[j]);
    if (!(largest > 0.0)) return black_channel(shape);
    for (double& texel : texels) texel = min(texel / largest, 1.0);
    return {std::move(texels), exact::log(largest)};
}

double maximum_of(const NormalisedChannel& channel) {
    const bool black = *std::max_element(channel.texel.begin(), channel.texel.end()) == 0.0;
    return black ? 0.0 : exact::exp(channel.log_maximum);
}

NormalisedChannel limited(const NormalisedChannel& channel, const MapShape& shape, double limit) {
    if (limit == 1.0) return channel;
    NormalisedChannel result{std::vector<double>(channel.texel.size()),
                             channel.log_maximum + exact::log(limit)};
    std::size_t opaque = 0, clipped = 0;
    for (std::size_t j = 0; j < channel.texel.size(); ++j) {
        result.texel[j] = min(channel.texel[j] / limit, 1.0);
        if (!is_opaque(j, shape)) continue;
        ++opaque;
        clipped += channel.texel[j] > limit ? 1U : 0U;
    }
    result.clipped_share = static_cast<double>(clipped) / static_cast<double>(opaque);
    return result;
}

double percentile(const NormalisedChannel& channel, const MapShape& shape, double percent) {
    std::vector<double> values;
    for (std::size_t j = 0; j < channel.texel.size(); ++j)
        if (is_opaque(j, shape)) values.push_back(channel.texel[j]);
    std::stable_sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(percent / 100.0 *
                                           static_cast<double>(values.size() - 1))];
}

NormalisedChannel white_channel(const MapShape& shape) {
    return {std::vector<double>(shape.texels(), 1.0)};
}

NormalisedChannel black_channel(const MapShape& shape) {
    return {std::vector<double>(shape.texels(), 0.0), 0.0};
}

FactorMap make_factor_map(const std::array<NormalisedChannel, 3>& channels, const MapShape& shape,
                          const std::string& name) {
    FactorMap map{shape, {}, {}, {}};
    std::vector<Texels> reals, byte_faces;
    for (std::size_t face = 0; face < shape.faces(); ++face) {
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
        reals.emplace_back(std::move(real));
        byte_faces.emplace_back(std::move(bytes));
    }
    map.real = textures_of(std::move(reals), shape);
    map.bytes = textures_of(std::move(byte_faces), shape);
    for (std::size_t c = 0; c < 3; ++c) {
        map.loss[c] = byte_loss(channels[c].texel, shape);
        map.loss[c].clipped_share = channels[c].clipped_share;
    }
    return map;
}

std::vector<Texture> faces_of(const std::vector<Texture>& images) {
    std::vector<Texture> faces;
    for (const Texture& image : images) {
        faces.push_back({image.width, image.height, image.texels});
        for (const TextureFace& face : image.cube_faces)
            faces.push_back({face.width, face.height, face.texels});
    }
    return faces;
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

const char* face_name(std::size_t face, MapForm form) {
    constexpr std::array paraboloids{"front", "back"};
    constexpr std::array cube{"px", "nx", "py", "ny", "pz", "nz"};
    if (form == MapForm::dual_paraboloid) return paraboloids[face];
    return form == MapForm::cube ? cube[face] : name_of(form);
}

const char* channel_name(std::size_t channel) {
    return channel == 0 ? "red" : channel == 1 ? "green" : "blue";
}

}  // namespace twofold
