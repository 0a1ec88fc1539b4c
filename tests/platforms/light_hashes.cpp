#include "factor/evaluate.hpp"
#include "factor/measured_brdf.hpp"
#include "tests/platforms/factor_input.hpp"

namespace twofold::platforms {
namespace {

Hashes of_lights(const std::string& name, const DistantLights& lights) {
    return {hash_of(name + "/x", lights.x),
            hash_of(name + "/y", lights.y),
            hash_of(name + "/z", lights.z),
            hash_of(name + "/red", lights.r),
            hash_of(name + "/green", lights.g),
            hash_of(name + "/blue", lights.b),
            hash_over(name + "/cones", lights.cones.size(),
                      [&](std::size_t i) { return lights.cones[i].sine; })};
}

/// A picture of noise in every form.
Hashes form_hashes() {
    struct Form {
        const char* name;
        EnvironmentForm form;
        int width, height;
    };
    constexpr std::array forms{Form{"latlong", EnvironmentForm::latlong, 24, 12},
                               Form{"probe", EnvironmentForm::probe, 16, 16},
                               Form{"cross", EnvironmentForm::cube_cross, 16, 12},
                               Form{"strip", EnvironmentForm::cube_strip, 24, 4},
                               Form{"openexr", EnvironmentForm::cube_openexr, 4, 24},
                               Form{"paraboloids", EnvironmentForm::dual_paraboloid, 16, 8}};
    Hashes hashes;
    for (const Form& f : forms) {
        FloatImage image{f.width, f.height, 3, {}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.width * f.height * 3); ++i)
            image.samples.push_back(static_cast<float>(real(i, 1, 0.0, 4.0)));
        EnvironmentSettings settings;
        settings.cells = 512;
        settings.form = f.form;
        append(hashes, of_lights(fmt::format("lights/{}", f.name),
                                 environment_of(image, settings, f.name).lights));
    }
    return hashes;
}

/// Samples of Cook-Torrance as if they had been measured.
Brdf measured(Fill fill, int threads) {
    MeasuredData data;
    data.value = [](Vec3 wi, Vec3 wo) { return evaluate(cook_torrance(), {0, 0, 1}, wo, wi); };
    MeasuredBrdf brdf;
    brdf.model = std::make_shared<MeasuredModel>(make_model(data, fill, threads));
    return brdf;
}

Hashes material_hashes(const char* name, const Brdf& brdf, int threads) {
    const std::vector<SurfaceView> at = surface_views(256, 0);
    const std::vector<Rgb> radiance = outgoing_radiance(brdf, sky(), at, threads);
    Hashes hashes{hash_over(fmt::format("brdf/{}", name), at.size(), [&](std::size_t i) {
        return evaluate(brdf, at[i].n, at[i].v, at[(i + 1) % at.size()].n);
    })};
    for (std::size_t block = 0; block < 8; ++block)
        hashes.push_back(hash_over(fmt::format("radiance/{}/pairs-{}", name, 32 * block), 32,
                                   [&](std::size_t i) { return radiance[32 * block + i]; }));
    return hashes;
}

}  // namespace

Hashes light_hashes(int threads) {
    Hashes hashes = of_lights("lights/painted", sky());
    append(hashes, form_hashes());
    append(hashes, material_hashes("phong", phong(), threads));
    append(hashes, material_hashes("cook-torrance", cook_torrance(), threads));
    append(hashes,
           material_hashes("measured-table", measured(Fill::interpolate, threads), threads));
    return hashes;
}

}  // namespace twofold::platforms
