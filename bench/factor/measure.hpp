#pragma once
#include <filesystem>
#include <vector>

#include "bench/factor/peer.hpp"
#include "bench/factor/report.hpp"

namespace twofold::bench {

/// Equation (1) a sample and light, against the same sum in NumPy; one thread.
std::vector<FactorFigure> measure_sampling(const Peer& peer);

/// Iterations of LSMR and of QMR on one channel's system, against SciPy's on the same matrix; one
/// thread.
std::vector<FactorFigure> measure_solvers(const Peer& peer);

/// The fit of one channel by the number of samples, up to `largest`, and the memory that took.
std::vector<FactorFigure> measure_growth(int largest);

/// Sampling and fit with two threads against one. @throws Error(failure) if bytes differ
std::vector<FactorFigure> measure_threads();

/// The factor step of a scene file, two threads.
std::vector<FactorFigure> measure_scene(const std::filesystem::path& scene);

}  // namespace twofold::bench
