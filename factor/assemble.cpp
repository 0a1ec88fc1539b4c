#include <algorithm>
#include <utility>

#include "factor/factorize.hpp"
#include "factor/scale.hpp"
#include "texunit/exact_math.hpp"

/// From the products of the channels to images and figures.
namespace twofold {

namespace {

/// The search for the best scale looks at no more pairs than this.
constexpr std::size_t scale_pairs = 4096;

std::vector<Rgb> view_of(const std::array<ChannelProduct, 3>& channels) {
    std::size_t knots = 0;
    for (const ChannelProduct& channel : channels) knots = std::max(knots, channel.view.size());
    std::vector<Rgb> view(knots, Rgb(1.0));
    for (int c = 0; c < 3; ++c) {
        const std::vector<double>& table = channels[static_cast<std::size_t>(c)].view;
        for (std::size_t k = 0; k < table.size(); ++k) view[k][c] = table[k];
    }
    return view;
}

std::vector<Rgb> colors_of(const std::array<ChannelProduct, 3>& channels, std::size_t vertices) {
    std::vector<Rgb> colors(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
        colors[i] = {channels[0].t1.texel[i], channels[1].t1.texel[i], channels[2].t1.texel[i]};
    return colors;
}

ProductTerm term_of(const ScaledProduct& product, const TermShapes& shapes) {
    const auto& [red, green, blue] = product.channels;
    ProductTerm term;
    term.t1.shape = shapes.first;
    term.vertices = colors_of(product.channels, shapes.vertices);
    if (shapes.vertices == 0)
        term.t1 = make_factor_map({red.t1, green.t1, blue.t1}, shapes.first, "t1");
    term.t2 = make_factor_map({red.t2, green.t2, blue.t2}, shapes.second, "t2");
    term.view = view_of(product.channels);
    term.scale_color = product.split.color;
    term.combiner_scale = product.split.combiner_scale;
    term.c = product.c;
    term.subtract = red.subtract;
    for (int i = 0; i < 3; ++i) {
        const ChannelProduct& channel = product.channels[static_cast<std::size_t>(i)];
        if (channel.scale == 0.0) continue;
        term.max1[i] = exact::exp(channel.t1.log_maximum);
        term.max2[i] = exact::exp(channel.t2.log_maximum);
    }
    return term;
}

std::span<const PairFootprint> first_pairs(const std::vector<PairFootprint>& pairs) {
    return std::span(pairs).first(std::min(pairs.size(), scale_pairs));
}

}  // namespace

void put_error(ChannelFit& fit, const FitError& error) {
    fit.relative_rms = error.relative_rms;
    fit.byte_rms = error.byte_rms;
    fit.log_rms = error.log_rms;
    fit.median = error.median;
    fit.p95 = error.p95;
    fit.psnr = error.psnr;
}

FactoredLighting assembled(std::vector<std::array<ChannelProduct, 3>> terms,
                           std::array<ChannelFit, 3> fit, const LightingSamples& judged,
                           const FactorSettings& settings, double white) {
    const MapShape shape = shape_of(settings);
    return assembled(std::move(terms), std::move(fit),
                     {footprints_of(judged.at, shape), judged.radiance}, {shape, shape}, settings,
                     white);
}

FactoredLighting assembled(std::vector<std::array<ChannelProduct, 3>> terms,
                           std::array<ChannelFit, 3> fit, const JudgedPairs& judged,
                           const TermShapes& shapes, const FactorSettings& settings, double white,
                           int doubling_passes) {
    const std::vector<PairFootprint>& pairs = judged.pairs;
    FactoredLighting result;
    result.model = settings.model;
    result.white = white;
    result.doubling_passes = doubling_passes;
    result.fit = std::move(fit);
    std::vector<ScaledProduct> scaled;
    for (const auto& channels : terms) {
        scaled.push_back(scaled_product(channels, settings, white, first_pairs(pairs)));
        const std::vector<std::string>& more = scaled.back().split.warnings;
        result.warnings.insert(result.warnings.end(), more.begin(), more.end());
        result.doubling_passes =
            std::max(result.doubling_passes, scaled.back().split.doubling_passes);
    }
    for (ScaledProduct& product : scaled) {
        product.split = with_doubling(std::move(product.split), result.doubling_passes);
        result.terms.push_back(term_of(product, shapes));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<ChannelProduct> channel;
        for (const ScaledProduct& product : scaled) channel.push_back(product.channels[c]);
        put_error(
            result.fit[c],
            fit_error(channel, pairs, channel_of(judged.radiance, static_cast<int>(c)), white));
    }
    return result;
}

}  // namespace twofold
