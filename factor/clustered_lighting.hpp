#pragma once
#include <memory>
#include <span>
#include <vector>

#include "factor/brdf.hpp"
#include "factor/distant_lights.hpp"
#include "factor/samples.hpp"

namespace twofold {

/// What the clustered sum left out, over some views against the full sum.
struct ClusterReport {
    double tolerance = 0.0;     ///< asked for, of the rms radiance
    double bound = 0.0;         ///< rms over views of the bound of |error|, over the rms radiance
    double relative_rms = 0.0;  ///< measured: rms of the error over the rms radiance
    double lights = 0.0;        ///< mean number of merged lights a view took
    std::size_t full_lights = 0;
    std::size_t views = 0;  ///< looked at for this report
};

/// The lighting function as a sum over merged lights: for each view the lights of a cell are taken
/// as one where the lobe varies too little over the cell to tell, which is bounded by the second
/// moment of the cell's energy and the lobe's second derivative (factor/lobe_variation.hpp). Energy
/// and centroid of each cell are kept, so that the error is of second order in its size.
class ClusteredLighting {
  public:
    /// @param tolerance relative rms error wanted, > 0
    ClusteredLighting(const Brdf& brdf, const DistantLights& lights, double tolerance, int threads);
    ~ClusteredLighting();
    ClusteredLighting(ClusteredLighting&&) noexcept;

    /// As outgoing_radiance(); the same at every number of threads.
    std::vector<Rgb> radiance(std::span<const SurfaceView> at, int threads) const;

    const ClusterReport& report() const { return report_; }

    struct Parts;  ///< the tree and where to stop in it

  private:
    std::unique_ptr<const Parts> parts_;
    ClusterReport report_;
};

}  // namespace twofold
