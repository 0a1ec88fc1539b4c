#pragma once
#include <filesystem>
#include <vector>

#include "bench/factor/peer.hpp"
#include "bench/factor/report.hpp"

namespace twofold::bench {

/// Equation (1) a sample and light, against the same sum in NumPy; one thread.
std::vector<FactorFigure> measure_sampling(const Peer& peer);

/// The sum over merged lights of a 512 x 1024 environment against the full sum, and its error.
std::vector<FactorFigure> measure_clustered();

/// Iterations of LSMR and of QMR on three channels in lockstep, a third of them a channel's,
/// against SciPy's on one channel's matrix; one thread.
std::vector<FactorFigure> measure_solvers(const Peer& peer);

/// The fit of one channel by the number of samples, up to `largest`, and the memory that took.
std::vector<FactorFigure> measure_growth(int largest);

/// Sampling and fit with two threads against one. @throws Error(failure) if bytes differ
std::vector<FactorFigure> measure_threads();

/// The factor step of a scene file, two threads.
std::vector<FactorFigure> measure_scene(const std::filesystem::path& scene);

}  // namespace twofold::bench
