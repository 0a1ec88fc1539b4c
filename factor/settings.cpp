#include "factor/settings.hpp"

#include <array>
#include <cstddef>

namespace twofold {

const char* name_of(Method method) {
    switch (method) {
        case Method::letter:
            return "letter";
        case Method::paper:
            return "paper";
        case Method::best:
            return "best";
    }
    return "unknown";
}

const char* name_of(Model model) {
    constexpr std::array names{"product", "svd", "nd", "mccool", "slf", "prefilter"};
    return names[static_cast<std::size_t>(model)];
}

const char* name_of(MapForm form) {
    constexpr std::array names{"dual_paraboloid", "cube", "sphere", "hemisphere", "chart"};
    return names[static_cast<std::size_t>(form)];
}

const char* name_of(Solver solver) {
    switch (solver) {
        case Solver::qmr:
            return "qmr";
        case Solver::lsmr:
            return "lsmr";
        case Solver::cgls:
            return "cgls";
        case Solver::qmr_augmented:
            return "qmr_augmented";
    }
    return "unknown";
}

const char* name_of(LightingSum sum) { return sum == LightingSum::full ? "full" : "clustered"; }

FactorSettings method_preset(Method method) {
    FactorSettings settings;
    settings.method = method;
    if (method == Method::paper) return settings;
    if (method == Method::best) {
        settings.solver = Solver::lsmr;
        settings.smoothness = 3.0;  // a third of the mottle of 1
        settings.view_knots = 24;
        settings.view_smoothness = 1.0;
        settings.refinement = 4;
        settings.scale = ScaleRule::best_split;
        settings.shortcuts = true;
        return settings;
    }
    // The paper's own text and nothing else: plain rows of equation (7), no stop test but the
    // limit.
    settings.lighting_sum = LightingSum::full;
    settings.tolerance = 0.0;
    settings.cap = 0.0;
    settings.row_weight = 0.0;
    settings.smoothness = 0.0;
    settings.seam = 0.0;
    settings.column_scaling = false;
    settings.stagnation_window = 0;
    settings.keep_best = false;
    settings.remove_null_vectors = false;
    return settings;
}

}  // namespace twofold
