#include "factor/settings.hpp"

namespace twofold {

FactorSettings method_preset(Method method) {
    FactorSettings settings;
    if (method == Method::paper) return settings;
    // The paper's own text and nothing else: plain rows of equation (7), no stop test but the
    // limit.
    settings.method = Method::letter;
    settings.tolerance = 0.0;
    settings.cap = 0.0;
    settings.row_weight = 0.0;
    settings.smoothness = 0.0;
    settings.seam = 0.0;
    settings.column_scaling = false;
    return settings;
}

}  // namespace twofold
