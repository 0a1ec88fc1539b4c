#include "factor/cgls.hpp"
#include "factor/first_guess.hpp"
#include "factor/fit_error.hpp"
#include "factor/lsmr.hpp"
#include "factor/qmr.hpp"
#include "factor/system.hpp"
#include "tests/platforms/factor_input.hpp"

/// The linear system of the logarithms and its solvers.
namespace twofold::platforms {
namespace {

FactorSettings small(MapForm form) {
    FactorSettings settings;
    settings.map_form = form;
    settings.map_size = form == MapForm::cube ? 5 : 8;
    settings.view_knots = form == MapForm::cube ? 6 : 0;
    settings.iteration_limit = 40;
    return settings;
}

Hashes solver_hashes(const std::string& name, const WeightedSystem& system, const Vector& start) {
    constexpr std::array solvers{Solver::qmr, Solver::lsmr, Solver::cgls, Solver::qmr_augmented};
    Hashes hashes;
    for (const Solver solver : solvers) {
        const StopRule rule{.tolerance = 1e-6, .iteration_limit = 40};
        const Solution solution = solve(solver, system.problem(), start, rule);
        const std::string of = fmt::format("solve/{}/{}", name, name_of(solver));
        hashes.push_back(hash_of(of + "/x", solution.x));
        hashes.push_back(hash_of(of + "/history", solution.report.history));
        hashes.push_back(hash_of(of + "/end", std::array{static_cast<int>(solution.report.status),
                                                         solution.report.iterations}));
    }
    return hashes;
}

/// What one product with the matrix, or with its transpose, gives.
Hashes product_hashes(const std::string& name, const LogRows& rows, int threads) {
    Vector x(rows.matrix.columns()), y(rows.matrix.rows());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = real(i, 1, -1.0, 1.0);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = real(i, 2, -1.0, 1.0);
    return {hash_of(fmt::format("system/{}/product", name), rows.matrix.multiply(x, threads)),
            hash_of(fmt::format("system/{}/transpose", name),
                    rows.matrix.multiply_transpose(y, threads)),
            hash_of(fmt::format("system/{}/norms", name), rows.matrix.column_norms(y, threads))};
}

Hashes channel_system_hashes(const std::string& name, const LogRows& rows,
                             std::span<const double> radiance, const FactorSettings& settings,
                             int threads) {
    const ChannelRows right =
        channel_rows(rows, Vector(radiance.begin(), radiance.end()), settings, 1.0);
    const FirstGuess guess = first_guess(rows, right, settings.fill_power, threads);
    const WeightedSystem system(rows, right, settings, threads);
    Hashes hashes{hash_of(fmt::format("system/{}/right-side", name), right.right_side),
                  hash_of(fmt::format("system/{}/weights", name), right.weight),
                  hash_of(fmt::format("guess/{}", name), guess.x)};
    append(hashes, solver_hashes(name, system, system.scaled_unknowns(guess.x)));
    return hashes;
}

Hashes form_hashes(const std::string& name, MapForm form, int threads) {
    const FactorSettings settings = small(form);
    const LightingSamples fit = samples(cook_torrance(), 1500, 0, threads);
    const LogRows rows = log_rows(fit.at, settings);
    Hashes hashes = product_hashes(name, rows, threads);
    for (int channel = 0; channel < 3; ++channel)
        append(hashes,
               channel_system_hashes(
                   fmt::format("{}/{}", name, channel_name(static_cast<std::size_t>(channel))),
                   rows, channel_of(fit.radiance, channel), settings, threads));
    return hashes;
}

}  // namespace

Hashes system_hashes(int threads) {
    Hashes hashes = form_hashes("paraboloids", MapForm::dual_paraboloid, threads);
    append(hashes, form_hashes("cube", MapForm::cube, threads));
    return hashes;
}

}  // namespace twofold::platforms
