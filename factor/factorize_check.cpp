#include "factor/factorize_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "texunit/error.hpp"

namespace twofold {

namespace {

void require(bool condition, const std::string& text) {
    if (!condition) throw Error(ExitCode::failure, "factor: " + text);
}

}  // namespace

void check_samples(const LightingSamples& samples, const char* name) {
    require(samples.at.size() == samples.radiance.size(),
            fmt::format("{} has {} pairs but {} radiances", name, samples.at.size(),
                        samples.radiance.size()));
}

void check_white(double white) {
    require(white >= 0.0 && std::isfinite(white), fmt::format("white is {}", white));
}

void check_arguments(const LightingSamples& fit, const LightingSamples& held_out,
                     const FactorSettings& settings, double white) {
    require(!fit.at.empty(), "no samples");
    check_samples(fit, "fit");
    check_samples(held_out, "held_out");
    checked(settings);
    check_white(white);
}

const FactorSettings& checked(const FactorSettings& s) {
    require(s.map_size >= 2 && s.map_size <= 2048, fmt::format("map_size is {}", s.map_size));
    require(s.guard > 0.0 && s.guard <= 1.0, fmt::format("guard is {}", s.guard));
    require(s.floor > 0.0 && std::isfinite(s.floor), fmt::format("floor is {}", s.floor));
    require(s.cap >= 0.0, fmt::format("cap is {}", s.cap));
    require(s.smoothness >= 0.0 && std::isfinite(s.smoothness),
            fmt::format("smoothness is {}", s.smoothness));
    require(s.seam >= 0.0 && std::isfinite(s.seam), fmt::format("seam is {}", s.seam));
    require(std::isfinite(s.row_weight), fmt::format("row_weight is {}", s.row_weight));
    require(s.tolerance >= 0.0, fmt::format("tolerance is {}", s.tolerance));
    require(s.iteration_limit > 0, fmt::format("iteration_limit is {}", s.iteration_limit));
    require(s.view_knots == 0 || (s.view_knots >= 2 && s.view_knots <= 256),
            fmt::format("view_knots is {}", s.view_knots));
    require(s.view_smoothness >= 0.0 && std::isfinite(s.view_smoothness),
            fmt::format("view_smoothness is {}", s.view_smoothness));
    require(s.terms >= 1 && s.terms <= 4, fmt::format("terms is {}", s.terms));
    require(
        s.terms == 1 || s.refinement > 0 || s.model != Model::product,
        fmt::format("terms is {} but refinement is 0, and only it tells products apart", s.terms));
    require(s.rounds > 0, fmt::format("rounds is {}", s.rounds));
    require(s.refinement >= 0, fmt::format("refinement is {}", s.refinement));
    require(std::isfinite(s.refinement_weight),
            fmt::format("refinement_weight is {}", s.refinement_weight));
    require(s.scale_percentile > 0.0 && s.scale_percentile <= 100.0,
            fmt::format("scale_percentile is {}", s.scale_percentile));
    require(s.combiner_scale == 1 || s.combiner_scale == 2 || s.combiner_scale == 4,
            fmt::format("combiner_scale is {}", s.combiner_scale));
    return s;
}

}  // namespace twofold
