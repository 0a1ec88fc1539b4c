#pragma once
#include <array>
#include <string>
#include <vector>

#include "factor/distant_lights.hpp"
#include "factor/factor_map.hpp"
#include "factor/fit_error.hpp"
#include "factor/fit_samples.hpp"
#include "factor/samples.hpp"
#include "factor/settings.hpp"
#include "factor/solver.hpp"
#include "factor/system.hpp"

namespace twofold {

/// How one channel was fitted.
struct ChannelFit {
    SolverReport solver;
    TreatedSamples counts;
    double untouched_share = 0.0;  ///< share of the texels of both maps that no sample touches
    std::size_t components = 0;  ///< parts of the system that no row joins; each has its own gauge

    /// At the held-out pairs, or at the fit's own if none were given; defined in FitError.
    double relative_rms = 0.0, byte_rms = 0.0, log_rms = 0.0, median = 0.0, p95 = 0.0;
    double psnr = 0.0;  ///< dB
};

/// One product of the sum:
/// white x scale_color x combiner_scale x 2^doubling_passes x T1(n) x T2(r_v) x view(n.v).
struct ProductTerm {
    FactorMap t1;               ///< over the normal n; slf: over the mesh's texture coordinates
    FactorMap t2;               ///< over the reflected view r_v
    bool constant_t2 = false;   ///< T2 is 1 everywhere: no unit needs to look it up
    std::vector<Rgb> view;      ///< g at its knots (factor/view_table.hpp), largest 1; empty = 1
    Rgb scale_color{0.0};       ///< vertex colour, in [0, 1]
    int combiner_scale = 1;     ///< 1, 2 or 4
    Rgb max1{0.0};              ///< what T1 was divided by; 0 in a black channel
    Rgb max2{0.0};              ///< what T2 was divided by
    Rgb c{0.0};                 ///< max t1 max t2 max g / white
    std::vector<Rgb> vertices;  ///< slf: t1 at the mesh's vertices, largest 1, in place of a map
    bool subtract = false;      ///< its passes take it off what is drawn already
    bool sum_of_maps =
        false;  ///< color x T1 + T2 in place of a product; see factor/prefiltered.hpp
};

/// The lighting function as a sum of products, each two textures, a constant and perhaps a table:
/// L_o(v, n) / white ~ 2^doubling_passes x the sum of what the terms' passes show.
struct FactoredLighting {
    Model model = Model::product;
    std::vector<ProductTerm> terms;  ///< one, unless FactorSettings::terms asks for more; svd: the
                                     ///< positive parts of its signed terms
    int doubling_passes = 0;         ///< 0 unless a term's c exceeds the scale
    double white = 1.0;              ///< radiance that the picture shows as 1
    DistantLights lights;     ///< mccool: a pass each; the terms' constants are per irradiance
    std::string closed_form;  ///< the shortcut that gave the texels; empty: they were fitted
    std::array<ChannelFit, 3> fit;
    std::vector<std::string> warnings;
};

/// Puts error figures into a channel's report.
void put_error(ChannelFit& fit, const FitError& error);

/// Pairs that error figures are taken at.
struct JudgedPairs {
    std::vector<PairFootprint> pairs;
    std::vector<Rgb> radiance;
};

/// The shapes of a term's maps.
struct TermShapes {
    MapShape first, second;
    std::size_t vertices = 0;  ///< in place of the first map; 0: there is a map
};

/// Puts the channels of the terms together: units and scale of the maps, images, error figures.
/// @param terms by term, then channel; maps divided by their maxima
/// @param fit what is known of the fits; the error figures are filled in
/// @param doubling_passes at least so many
FactoredLighting assembled(std::vector<std::array<ChannelProduct, 3>> terms,
                           std::array<ChannelFit, 3> fit, const JudgedPairs& judged,
                           const TermShapes& shapes, const FactorSettings& settings, double white,
                           int doubling_passes = 0);

/// The same for two maps of the settings' shape.
FactoredLighting assembled(std::vector<std::array<ChannelProduct, 3>> terms,
                           std::array<ChannelFit, 3> fit, const LightingSamples& judged,
                           const FactorSettings& settings, double white);

/// Factors samples of the lighting function, each channel for itself. The result has the same bits
/// at every number of threads.
/// @param held_out pairs for the error figures, none of them in `fit`; may be empty
/// @param settings every field but samples, held_out and method decides; method_preset() fills them
/// @param white radiance > 0 that the picture shows as 1; 0 only if all samples are black
/// @throws Error if `fit` is empty, a setting is out of range or a channel has no finite sample
/// @source seed paper, sections 3 and 4
FactoredLighting factorize(const LightingSamples& fit, const LightingSamples& held_out,
                           const FactorSettings& settings, double white, int threads);

/// The same for samples that were added in batches: 10,000,000 fit in 512 MiB with QMR and without
/// a refinement, as a sample then takes 48 bytes at most (LSMR keeps 96).
/// @param judged pairs for the error figures
FactoredLighting factorize(FitSamples fit, const LightingSamples& judged, double white,
                           int threads);

}  // namespace twofold
