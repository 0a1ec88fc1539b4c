#pragma once
#include <array>
#include <string>
#include <vector>

#include "factor/factor_map.hpp"
#include "factor/fit_error.hpp"
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

    /// At the held-out pairs, or at the fit's own if none were given; defined in FitError.
    double relative_rms = 0.0, byte_rms = 0.0, log_rms = 0.0, median = 0.0, p95 = 0.0;
};

/// The lighting function as two textures and a constant:
/// L_o(v, n) / white ~ scale_color x combiner_scale x 2^doubling_passes x T1(n) x T2(r_v).
struct FactoredLighting {
    FactorMap t1;             ///< over the normal n
    FactorMap t2;             ///< over the reflected view r_v
    Rgb scale_color{0.0};     ///< vertex colour, in [0, 1]
    int combiner_scale = 1;   ///< 1, 2 or 4
    int doubling_passes = 0;  ///< 0 unless c exceeds 4
    Rgb max1{0.0};            ///< what T1 was divided by; 0 in a black channel
    Rgb max2{0.0};            ///< what T2 was divided by
    Rgb c{0.0};               ///< max1 max2 / white
    double white = 1.0;       ///< radiance that the picture shows as 1
    std::array<ChannelFit, 3> fit;
    std::vector<std::string> warnings;
};

/// Factors samples of the lighting function, each channel for itself. The result has the same bits
/// at every number of threads.
/// @param held_out pairs for the error figures, none of them in `fit`; may be empty
/// @param settings every field but samples, held_out and method decides; method_preset() fills them
/// @param white radiance > 0 that the picture shows as 1; 0 only if all samples are black
/// @throws Error if `fit` is empty, a setting is out of range or a channel has no finite sample
/// @source seed paper, sections 3 and 4
FactoredLighting factorize(const LightingSamples& fit, const LightingSamples& held_out,
                           const FactorSettings& settings, double white, int threads);

}  // namespace twofold
