#include "factor/view_table.hpp"

#include <cmath>

#include "texunit/fixed.hpp"

namespace twofold {

namespace {

template <class Value>
Value looked_up(std::span<const Value> table, double cosine) {
    if (table.empty()) return Value(1.0);
    const ViewFootprint at = view_footprint(cosine, static_cast<int>(table.size()));
    return at.weight[0] * table[at.index[0]] + at.weight[1] * table[at.index[1]];
}

}  // namespace

ViewFootprint view_footprint(double cosine, int knots) {
    const double last = knots - 1;
    const double root = std::sqrt(min(max(cosine, 0.0), 1.0)) * last;
    const double lower = min(std::floor(root), last - 1.0);
    // Linear in the cosine, not in its root.
    const double from = lower * lower, to = (lower + 1.0) * (lower + 1.0);
    const double weight = min(max((root * root - from) / (to - from), 0.0), 1.0);
    const auto index = static_cast<std::uint32_t>(lower);
    return {{index, index + 1}, {1.0 - weight, weight}};
}

double view_value(std::span<const double> table, double cosine) { return looked_up(table, cosine); }

Rgb view_value(std::span<const Rgb> table, double cosine) { return looked_up(table, cosine); }

}  // namespace twofold
