#include "factor/approximate.hpp"

#include "factor/closed_form.hpp"
#include "factor/point_lit.hpp"
#include "factor/prefiltered.hpp"
#include "factor/separable.hpp"
#include "texunit/error.hpp"

namespace twofold {

namespace {

std::optional<FactoredLighting> shortcut(const Brdf& brdf, const DistantLights& lights,
                                         const LightingSamples& judged,
                                         const FactorSettings& settings, double white,
                                         int threads) {
    if (!settings.shortcuts) return std::nullopt;
    return closed_form(brdf, lights, judged, settings, white, threads);
}

FactoredLighting product(const Brdf& brdf, const DistantLights& lights,
                         const MaterialSamples& samples, const FactorSettings& settings,
                         double white, int threads) {
    if (auto known = shortcut(brdf, lights, samples.held_out, settings, white, threads))
        return *std::move(known);
    return factorize(samples.fit, samples.held_out, settings, white, threads);
}

}  // namespace

FactoredLighting approximate(const Brdf& brdf, const DistantLights& lights,
                             const MaterialSamples& samples, const FactorSettings& settings,
                             double white, int threads) {
    switch (settings.model) {
        case Model::svd:
        case Model::nd:
            return factor_separable(samples, settings, white, threads);
        case Model::prefilter:
            return prefilter(brdf, lights, samples, settings, white, threads);
        case Model::mccool:
            return factor_point_lit(brdf, lights, samples, settings, white, threads);
        case Model::slf:
        case Model::product:
            break;
    }
    return product(brdf, lights, samples, settings, white, threads);
}

FactoredLighting approximate_product(const Brdf& brdf, const DistantLights& lights, FitSamples fit,
                                     const LightingSamples& judged, double white, int threads) {
    const FactorSettings settings = fit.settings();
    if (auto known = shortcut(brdf, lights, judged, settings, white, threads))
        return *std::move(known);
    return factorize(std::move(fit), judged, white, threads);
}

}  // namespace twofold
