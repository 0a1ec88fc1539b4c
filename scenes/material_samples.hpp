#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "factor/clustered_lighting.hpp"
#include "factor/fit_samples.hpp"
#include "scenes/scene.hpp"

namespace twofold {

/// Stretches of the direction sequence: no pair is in two of them.
inline constexpr std::uint64_t fit_sequence = 0, held_out_sequence = 1, averaging_sequence = 2;

/// A material's lighting function under the scene's lights, by the sum that the settings name.
class MaterialSampler {
  public:
    /// The material and the lights have to outlive it.
    MaterialSampler(const Brdf& brdf, const DistantLights& lights, const FactorSettings& settings,
                    int threads);

    /// Samples [first, first + count) of those that are fitted.
    LightingSamples fitted(int first, int count) const;
    /// All samples that are fitted.
    LightingSamples fitted() const { return fitted(0, settings_.samples); }
    /// All that are fitted, each batch placed in the maps and dropped: 40 bytes a sample instead of
    /// 72, and the same fit.
    FitSamples placed() const;
    /// The pairs that errors are measured on.
    LightingSamples held_out() const;

    /// Of the clustered sum, if that is what samples.
    std::optional<ClusterReport> report() const;

  private:
    LightingSamples samples(std::uint64_t sequence, int first, int count) const;

    const Brdf& brdf_;
    const DistantLights& lights_;
    FactorSettings settings_;
    int threads_;
    std::optional<ClusteredLighting> clustered_;
};

/// The radiance that is displayed as 1: given by the scene, or the percentile of the largest
/// channel over the samples of all materials; 1 if everything is black.
double white_radiance(const WhitePoint& white,
                      const std::map<std::string, MaterialSamples>& samples);
double white_radiance(const WhitePoint& white, const std::map<std::string, FitSamples>& samples);

}  // namespace twofold
