#include "factor/closed_form.hpp"

#include <algorithm>

#include "factor/lighting.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {

namespace {

std::vector<Vec3> texel_directions(const MapShape& shape) {
    std::vector<Vec3> directions;
    for (std::size_t j = 0; j < shape.texels(); ++j)
        directions.push_back(texel_direction(texel_at(j, shape), shape));
    return directions;
}

using Channels = std::array<ChannelProduct, 3>;

Channels diffuse_product(const Brdf& brdf, const DistantLights& lights, const MapShape& shape,
                         int threads) {
    std::vector<SurfaceView> at;
    for (const Vec3 n : texel_directions(shape)) at.push_back({n, n});
    const std::vector<Rgb> radiance = outgoing_radiance(brdf, lights, at, threads);
    Channels channels;
    for (int c = 0; c < 3; ++c)
        channels[static_cast<std::size_t>(c)] =
            product_of(normalised_values(channel_of(radiance, c), shape), white_channel(shape));
    return channels;
}

Channels phong_product(const ModifiedPhong& phong, Vec3 l, Rgb weight, const MapShape& shape) {
    std::vector<double> cosine, lobe;
    for (const Vec3 d : texel_directions(shape)) {
        const double along = std::max(dot(d, l), 0.0);
        cosine.push_back(along);
        lobe.push_back(along > 0.0 ? exact::pow(along, phong.exponent) : 0.0);
    }
    const double normalisation = (phong.exponent + 2.0) / (2.0 * exact::pi);
    Channels channels;
    for (int c = 0; c < 3; ++c) {
        std::vector<double> mirrored;
        for (const double value : lobe)
            mirrored.push_back(weight[c] * (phong.diffuse[c] / exact::pi +
                                            phong.specular[c] * normalisation * value));
        channels[static_cast<std::size_t>(c)] =
            product_of(normalised_values(cosine, shape), normalised_values(mirrored, shape));
    }
    return channels;
}

/// What was measured is never known to be diffuse.
bool is_diffuse(const Brdf& brdf) {
    return std::visit(
        [](const auto& material) {
            if constexpr (requires { material.specular; }) return material.specular == Rgb(0.0);
            return false;
        },
        brdf);
}

/// The only light that shines, if there is but one.
std::optional<std::size_t> only_light(const DistantLights& lights) {
    std::optional<std::size_t> only;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        if (lights.weight(k) == Rgb(0.0)) continue;
        if (only) return std::nullopt;
        only = k;
    }
    return only;
}

FactoredLighting finished(Channels channels, const char* name, const LightingSamples& held_out,
                          const FactorSettings& settings, double white) {
    FactoredLighting result = assembled({std::move(channels)}, {}, held_out, settings, white);
    result.closed_form = name;
    return result;
}

}  // namespace

std::optional<FactoredLighting> closed_form(const Brdf& brdf, const DistantLights& lights,
                                            const LightingSamples& held_out,
                                            const FactorSettings& settings, double white,
                                            int threads) {
    const MapShape shape = shape_of(settings);
    if (is_diffuse(brdf)) {
        FactoredLighting result = finished(diffuse_product(brdf, lights, shape, threads), "diffuse",
                                           held_out, settings, white);
        result.terms[0].constant_t2 = true;
        return result;
    }
    const auto* phong = std::get_if<ModifiedPhong>(&brdf);
    const std::optional<std::size_t> light = only_light(lights);
    if (phong == nullptr || !light) return std::nullopt;
    return finished(phong_product(*phong, lights.direction(*light), lights.weight(*light), shape),
                    "one Phong lobe", held_out, settings, white);
}

}  // namespace twofold
