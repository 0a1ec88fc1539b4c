#include "judge.hpp"

#include <algorithm>
#include <cmath>

#include "factor/approximate.hpp"
#include "factor/directions.hpp"
#include "factor/lighting.hpp"
#include "texunit/exact_math.hpp"

namespace twofold::quality {

namespace {

constexpr int held_out_pairs = 20000;
constexpr std::uint64_t held_out_sequence = 1;
constexpr int sphere_lights = 512;

/// `radiance` of the height y over points spread evenly on the sphere.
template <class Radiance>
DistantLights sphere(const Radiance& radiance) {
    DistantLights lights;
    for (int i = 0; i < sphere_lights; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / sphere_lights;
        const double r = std::sqrt(1.0 - y * y), turn = 2.399963229728653 * i;
        lights.push_back({r * exact::cos(turn), y, r * exact::sin(turn)},
                         Rgb(radiance(y) * 4.0 * exact::pi / sphere_lights, 0.0, 0.0));
    }
    return bound_blocks(std::move(lights));
}

DistantLights directional(const std::vector<std::pair<Vec3, double>>& from) {
    DistantLights lights;
    for (const auto& [direction, irradiance] : from)
        lights.push_back(normalized(direction), Rgb(irradiance, 0.0, 0.0));
    return bound_blocks(std::move(lights));
}

/// Red values of both maps of a term, as floats or as bytes.
std::array<std::vector<double>, 2> reds_of(const ProductTerm& term, bool bytes) {
    std::array<std::vector<double>, 2> reds;
    for (std::size_t m = 0; m < 2; ++m) {
        const FactorMap& map = m == 0 ? term.t1 : term.t2;
        for (const Texture& face : faces_of(bytes ? map.bytes : map.real))
            if (bytes)
                for (const Rgba8& t : std::get<std::vector<Rgba8>>(face.texels))
                    reds[m].push_back(t.r / 255.0);
            else
                for (const Rgba32f& t : std::get<std::vector<Rgba32f>>(face.texels))
                    reds[m].push_back(static_cast<double>(t[0]));
    }
    return reds;
}

/// What the passes show at the pairs, 1 = white, clamped.
std::vector<double> displayed(const FactoredLighting& factors,
                              const std::vector<PairFootprint>& pairs, bool bytes) {
    std::vector<double> shown(pairs.size(), 0.0);
    for (const ProductTerm& term : factors.terms) {
        const auto [t1, t2] = reds_of(term, bytes);
        const double constant = term.scale_color.x * term.combiner_scale *
                                static_cast<double>(1 << factors.doubling_passes);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            shown[i] += constant * view_value(std::span(term.view), pairs[i].cosine).x *
                        filtered(t1, pairs[i].first) * filtered(t2, pairs[i].second);
    }
    for (double& value : shown) value = std::min(value, 1.0);
    return shown;
}

double rms_of(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// The 99th percentile.
double white_of(std::vector<double> radiance) {
    std::stable_sort(radiance.begin(), radiance.end());
    return radiance[radiance.size() * 99 / 100];
}

double largest_ratio(const ProductTerm& term) {
    double ratio = 0.0;
    for (std::vector<double> texels : reds_of(term, false)) {
        std::stable_sort(texels.begin(), texels.end());
        ratio = std::max(ratio, texels.back() / texels[texels.size() / 2]);
    }
    return ratio;
}

std::vector<PairFootprint> held_out_footprints(const FactoredLighting& factors) {
    return footprints_of(surface_views(held_out_pairs, held_out_sequence),
                         factors.terms[0].t1.shape);
}

}  // namespace

DistantLights grey_sky() {
    const DistantLights red = lights_named("sky");
    DistantLights grey;
    for (std::size_t k = 0; k < red.size(); ++k)
        grey.push_back(red.direction(k), Rgb(red.weight(k).x));
    return bound_blocks(std::move(grey));
}

DistantLights lights_named(const std::string& name) {
    if (name == "one") return directional({{{1.0, 1.0, 1.0}, 1.0}});
    if (name == "three")
        return directional(
            {{{0.3, 0.5, 0.8}, 1.0}, {{-0.8, 0.1, 0.4}, 0.7}, {{0.2, -0.9, -0.1}, 0.5}});
    if (name == "constant") return sphere([](double) { return 1.0; });
    return sphere([](double y) { return y > 0.0 ? 0.4 + 0.6 * y : 0.1; });
}

Brdf phong(double exponent) { return ModifiedPhong{Rgb(0.5), Rgb(0.5), exponent}; }

Brdf cook_torrance(double slope) {
    return CookTorrance{Rgb(0.3), Rgb(0.7), Rgb(0.04), {{slope, 1.0}}};
}

Brdf diffuse() { return ModifiedPhong{Rgb(0.8), Rgb(0.0), 1.0}; }

FactorSettings settings_of(Method method, int map_size) {
    FactorSettings settings = method_preset(method);
    settings.map_size = map_size;
    settings.solver = Solver::lsmr;
    if (method == Method::paper) settings.smoothness = 0.3;
    return settings;
}

LightingSamples red_samples(const Brdf& brdf, const DistantLights& lights, int count,
                            std::uint64_t sequence) {
    LightingSamples samples{surface_views(count, sequence), {}};
    samples.radiance = outgoing_radiance(brdf, lights, samples.at, 2);
    return samples;
}

Judged judge(const Brdf& brdf, const DistantLights& lights, const FactorSettings& settings,
             int samples, std::uint64_t sequence) {
    const LightingSamples held_out = red_samples(brdf, lights, held_out_pairs, held_out_sequence);
    std::vector<double> radiance = channel_of(held_out.radiance, 0);
    const double white = white_of(radiance);
    Judged judged{approximate(brdf, lights,
                              {red_samples(brdf, lights, samples, sequence), held_out}, settings,
                              white, 2)};
    const ChannelFit& fit = judged.factors.fit[0];
    judged.relative_rms = fit.relative_rms;
    judged.log_rms = fit.log_rms;
    const auto pairs = held_out_footprints(judged.factors);
    const std::vector<double> shown = displayed(judged.factors, pairs, false);
    for (double& value : radiance) value = std::min(value / white, 1.0);
    judged.psnr = -20.0 * std::log10(rms_of(shown, radiance));
    judged.byte_steps = 255.0 * rms_of(displayed(judged.factors, pairs, true), shown);
    judged.largest_ratio = largest_ratio(judged.factors.terms[0]);
    return judged;
}

std::array<ChannelFit, 3> channel_fits(const Brdf& brdf, const DistantLights& lights,
                                       const FactorSettings& settings, int samples) {
    const auto sampled = [&](int count, std::uint64_t sequence) {
        LightingSamples some{surface_views(count, sequence), {}};
        some.radiance = outgoing_radiance(brdf, lights, some.at, 2);
        return some;
    };
    const LightingSamples held_out = sampled(held_out_pairs, held_out_sequence);
    std::vector<double> largest;
    for (const Rgb& radiance : held_out.radiance) largest.push_back(max_component(radiance));
    return factorize(sampled(samples, 0), held_out, settings, white_of(std::move(largest)), 2).fit;
}

double mottle(const Judged& a, const Judged& b) {
    return 255.0 / std::sqrt(2.0) *
           rms_of(displayed(a.factors, held_out_footprints(a.factors), false),
                  displayed(b.factors, held_out_footprints(b.factors), false));
}

}  // namespace twofold::quality
