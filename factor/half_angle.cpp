#include "factor/half_angle.hpp"

#include <limits>

#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/parallel.hpp"

namespace twofold {
namespace {

using Table = HalfAngleTable;

/// Nodes a thread takes at a time.
constexpr std::size_t nodes_per_task = Table::difference_nodes * Table::azimuth_nodes;

/// The neighbours of a node along the axes.
struct Neighbours {
    std::array<std::size_t, 6> node{};
    std::size_t count = 0;
};

Neighbours neighbours_of(std::size_t node) {
    Neighbours found;
    std::size_t stride = Table::nodes;
    std::size_t rest = node;
    for (const std::size_t length :
         {Table::half_nodes, Table::difference_nodes, Table::azimuth_nodes}) {
        stride /= length;
        const std::size_t position = rest / stride;
        rest %= stride;
        if (position > 0) found.node[found.count++] = node - stride;
        if (position + 1 < length) found.node[found.count++] = node + stride;
    }
    return found;
}

/// A node to be filled and its value.
struct Filled {
    std::size_t node;
    double value;
};

/// The gaps of `missing` that have known neighbours, with their means.
std::vector<Filled> next_round(const std::vector<double>& values,
                               const std::vector<std::size_t>& missing) {
    std::vector<Filled> round;
    for (const std::size_t node : missing) {
        const Neighbours near = neighbours_of(node);
        double sum = 0.0;
        int known = 0;
        for (std::size_t k = 0; k < near.count; ++k) {
            const double value = values[near.node[k]];
            sum += value == value ? value : 0.0;
            known += value == value ? 1 : 0;
        }
        if (known > 0) round.push_back({node, sum / known});
    }
    return round;
}

std::vector<std::size_t> gaps_of(const std::vector<double>& values) {
    std::vector<std::size_t> gaps;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != values[i]) gaps.push_back(i);
    return gaps;
}

/// @return how many were filled
std::size_t fill_channel(std::vector<double>& values) {
    const std::size_t missing = gaps_of(values).size();
    if (missing == values.size())
        throw Error(ExitCode::failure, "brdf: a channel has no measured value");
    for (auto gaps = gaps_of(values); !gaps.empty(); gaps = gaps_of(values))
        for (const Filled& filled : next_round(values, gaps)) values[filled.node] = filled.value;
    return missing;
}

}  // namespace

NodeDirections node_directions(std::size_t node) {
    const std::size_t i = node / nodes_per_task;
    const std::size_t j = node % nodes_per_task / Table::azimuth_nodes;
    const std::size_t k = node % Table::azimuth_nodes;
    const double half = static_cast<double>(i) / (Table::half_nodes - 1);
    const double difference = static_cast<double>(j) / (Table::difference_nodes - 1);
    const double cosine = 2.0 * static_cast<double>(k) / (Table::azimuth_nodes - 1) - 1.0;
    const double half2 = half * half, difference2 = difference * difference;
    const double ch = 1.0 - half2 * half2, sh = half2 * std::sqrt(2.0 - half2 * half2);
    const double cd = 1.0 - difference2, sd = difference * std::sqrt(2.0 - difference2);
    const Vec3 h(sh, 0.0, ch);
    const Vec3 across =
        cosine * Vec3(ch, 0.0, -sh) + std::sqrt(1.0 - cosine * cosine) * Vec3(0.0, 1.0, 0.0);
    return {normalized(cd * h + sd * across), normalized(cd * h - sd * across)};
}

std::vector<Rgb> node_values(const std::function<Rgb(Vec3 wi, Vec3 wo)>& value, int threads) {
    std::vector<Rgb> values(Table::nodes, Rgb(std::numeric_limits<double>::quiet_NaN()));
    parallel_for(Table::half_nodes, threads, [&](std::size_t task) {
        for (std::size_t n = task * nodes_per_task; n < (task + 1) * nodes_per_task; ++n) {
            const NodeDirections at = node_directions(n);
            if (at.wi.z >= least_node_cosine && at.wo.z >= least_node_cosine)
                values[n] = value(at.wi, at.wo);
        }
    });
    return values;
}

HalfAngleTable fill_gaps(const std::vector<Rgb>& values) {
    Table table{std::vector<Rgba32f>(Table::nodes), {}};
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> channel;
        for (const Rgb& value : values) {
            const double f = value[static_cast<int>(c)];
            channel.push_back(f < 0.0 ? 0.0 : f);
        }
        table.filled[c] = fill_channel(channel);
        for (std::size_t n = 0; n < Table::nodes; ++n)
            table.f[n][c] = static_cast<float>(channel[n]);
    }
    return table;
}

}  // namespace twofold
