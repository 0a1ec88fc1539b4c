#include "factor/measured_brdf.hpp"

#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

std::vector<BrdfSample> node_samples(const std::vector<Rgb>& values) {
    std::vector<BrdfSample> samples;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const NodeDirections at = node_directions(n);
        if (at.wi.z >= least_node_cosine && at.wo.z >= least_node_cosine)
            samples.push_back({at.wi, at.wo, values[n]});
    }
    return samples;
}

/// Largest channel of the model where light and viewer are at the same place, theta_h from the
/// normal.
double retroreflected(const MeasuredModel& model, double half) {
    const double n_h = 1.0 - half * half * half * half;
    if (model.fill == Fill::interpolate)
        return max_component(trilinear(model.table, {half, 0.0, 0.5}));
    const Rgba32f view = view_part(model.product, n_h);
    return max_component(product(model.product, view, paraboloid_radius(n_h), half));
}

double lobe_half_width(const MeasuredModel& model) {
    const double peak = retroreflected(model, 0.0);
    constexpr int steps = 4 * static_cast<int>(HalfAngleTable::half_nodes);
    for (int i = 1; i < steps; ++i) {
        const double half = static_cast<double>(i) / steps;
        if (retroreflected(model, half) < 0.5 * peak)
            return exact::acos(1.0 - half * half * half * half);
    }
    return exact::pi / 2.0;
}

}  // namespace

MeasuredModel make_model(const MeasuredData& data, Fill fill, int threads) {
    MeasuredModel model;
    model.fill = fill;
    model.report.counts = data.counts;
    const bool needs_nodes = fill == Fill::interpolate || data.scattered.empty();
    const auto values = needs_nodes ? node_values(data.value, threads) : std::vector<Rgb>();
    const auto samples = data.scattered.empty() ? node_samples(values) : data.scattered;
    model.report.samples = samples.size();
    if (fill == Fill::interpolate) {
        model.table = fill_gaps(values);
        model.report.filled = model.table.filled;
    } else {
        FactoredBrdf factored = factor_brdf(samples, threads);
        model.product = std::move(factored.brdf);
        model.report.factors = std::move(factored.fit);
    }
    model.report.lobe_half_width = lobe_half_width(model);
    return model;
}

}  // namespace twofold
