#include "factor/factorize.hpp"
#include "tests/platforms/factor_input.hpp"

/// The whole factorisation by each method, to the bytes of its maps.
namespace twofold::platforms {
namespace {

Hashes map_hashes_of(const std::string& name, const FactorMap& map) {
    Hashes hashes;
    for (std::size_t face = 0; face < map.real.size(); ++face) {
        const auto of = [&](const char* what) {
            return fmt::format("{}/{}-{}", name, what, face_name(face, map.shape.form));
        };
        hashes.push_back(
            hash_of(of("real"), std::get<std::vector<Rgba32f>>(map.real[face].texels)));
        hashes.push_back(
            hash_of(of("bytes"), std::get<std::vector<Rgba8>>(map.bytes[face].texels)));
    }
    return hashes;
}

Hashes fit_hashes(const std::string& name, const FactoredLighting& result) {
    Hashes hashes;
    for (std::size_t c = 0; c < 3; ++c) {
        const ChannelFit& fit = result.fit[c];
        hashes.push_back(
            hash_of(fmt::format("{}/error-{}", name, channel_name(c)),
                    std::array{fit.relative_rms, fit.byte_rms, fit.log_rms, fit.median, fit.p95}));
    }
    return hashes;
}

Hashes factorisation_hashes(const std::string& name, const FactorSettings& settings, int threads) {
    const FactoredLighting result =
        factorize(samples(phong(), 1200, 0, threads), samples(phong(), 300, 1, threads), settings,
                  1.0, threads);
    Hashes hashes = fit_hashes("fit/" + name, result);
    for (std::size_t k = 0; k < result.terms.size(); ++k) {
        const ProductTerm& term = result.terms[k];
        const std::string of = fmt::format("map/{}/term-{}", name, k);
        append(hashes, map_hashes_of(of + "/t1", term.t1));
        append(hashes, map_hashes_of(of + "/t2", term.t2));
        hashes.push_back(hash_of(of + "/constant", std::array{term.scale_color, term.c}));
        hashes.push_back(hash_of(of + "/view", term.view));
    }
    return hashes;
}

FactorSettings small(Method method) {
    FactorSettings settings = method_preset(method);
    settings.map_size = 6;
    settings.iteration_limit = 30;
    return settings;
}

}  // namespace

Hashes map_hashes(int threads) {
    FactorSettings cube = small(Method::paper), sum = small(Method::best),
                   clipped = small(Method::paper);
    cube.map_form = MapForm::cube;
    cube.map_size = 4;
    sum.terms = 2;
    clipped.scale = ScaleRule::percentile;
    clipped.scale_percentile = 95.0;
    Hashes hashes = factorisation_hashes("letter", small(Method::letter), threads);
    append(hashes, factorisation_hashes("paper", small(Method::paper), threads));
    append(hashes, factorisation_hashes("best", small(Method::best), threads));
    append(hashes, factorisation_hashes("cube", cube, threads));
    append(hashes, factorisation_hashes("two-terms", sum, threads));
    append(hashes, factorisation_hashes("percentile", clipped, threads));
    return hashes;
}

}  // namespace twofold::platforms
